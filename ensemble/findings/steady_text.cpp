// Steady states as a table, JSON and CSV.

#include "findings/steady_text.hpp"

#include "findings/columns.hpp"
#include "findings/figures.hpp"
#include "findings/json.hpp"

namespace floes {

namespace {

std::string seconds(const std::optional<double>& time) {
    return time ? fixed(*time, 1) : "none";
}

Json json_optional(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

}  // namespace

std::string steady_table(const Summary& summary, const SteadyReport& steady, int width) {
    if (steady.members.empty()) return no_histories;
    std::vector<std::vector<std::string>> lines{{"case", "window from, s", "steady from, s", "single runs, s",
                                                 "without", "decorrelation, s", "effective samples"}};
    for (std::size_t index = 0; index < steady.cases.size(); ++index) {
        const CaseSteady& one = steady.cases[index];
        const CaseRow& about = summary.cases[index].about;
        lines.push_back({about.name, fixed(about.analysis.steady_start, 1), seconds(one.start),
                         seconds(one.median_start), fmt::format("{}", one.without_start),
                         fixed(one.median_decorrelation_time, 2), fixed(one.median_effective_samples, 0)});
    }
    return "Steady state\n\n" + columns(lines, width) +
           "\nSteady from: MSER of the mean history of the case; single runs: median of its members' own; without: "
           "members in\nwhich no steady part is seen. Decorrelation: load that counts as one independent value; "
           "effective samples: of the\nwindow. Both are medians over the members.\n";
}

std::string steady_csv(const Summary& summary, const CampaignTable& table, const SteadyReport& steady) {
    std::string text = "member,case,steady_start_s,decorrelation_time_s,effective_samples\n";
    for (const MemberSteady& member : steady.members) {
        const MemberRow& row = table.members.at(static_cast<std::size_t>(member.member));
        text += fmt::format("{},{},{},{},{}\n", member.member,
                            summary.cases.at(static_cast<std::size_t>(row.case_index)).about.name,
                            member.start ? csv_number(*member.start) : "", csv_number(member.decorrelation_time),
                            csv_number(member.effective_samples));
    }
    return text;
}

Json steady_as_json(const Summary& summary, const SteadyReport& steady) {
    Json cases = Json::array();
    for (std::size_t index = 0; index < steady.cases.size(); ++index) {
        const CaseSteady& one = steady.cases[index];
        cases.push_back({{"case", summary.cases[index].about.name},
                         {"steady_start_s", json_optional(one.start)},
                         {"median_member_start_s", json_optional(one.median_start)},
                         {"members_without_start", one.without_start},
                         {"median_decorrelation_time_s", json_number(one.median_decorrelation_time)},
                         {"median_effective_samples", json_number(one.median_effective_samples)}});
    }
    Json members = Json::array();
    for (const MemberSteady& member : steady.members) {
        members.push_back({{"member", member.member},
                           {"steady_start_s", json_optional(member.start)},
                           {"decorrelation_time_s", json_number(member.decorrelation_time)},
                           {"effective_samples", json_number(member.effective_samples)}});
    }
    return {{"cases", cases}, {"members", members}};
}

}  // namespace floes
