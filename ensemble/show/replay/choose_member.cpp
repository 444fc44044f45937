#include "replay/choose_member.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace floes {
namespace {

constexpr double round_worst = 10;  // s of frames before and after the largest load
constexpr double long_span = 60;    // s; of longer ones fewer frames are kept
constexpr double short_every = 0.1;
constexpr double long_every = 0.25;

}  // namespace

int chosen_member(const CampaignTable& table, const MemberChoice& choice) {
    if (choice.number) return *choice.number;
    const auto cases = static_cast<int>(table.cases.size());
    const int arrangements = static_cast<int>(table.members.size()) / std::max(cases, 1);
    const auto named = std::ranges::find(table.cases, choice.case_name, &CaseRow::name);
    if (!choice.case_name.empty() && named == table.cases.end()) {
        std::vector<std::string> names;
        for (const CaseRow& one : table.cases) names.push_back(one.name);
        throw InputError(
            fmt::format("There is no case {}; the cases are {}.", choice.case_name, fmt::join(names, ", ")));
    }
    if (choice.arrangement.value_or(0) >= arrangements)
        throw InputError(fmt::format("There is no arrangement {}; the arrangements are 0 to {}.", *choice.arrangement,
                                     arrangements - 1));
    const bool any_case = choice.case_name.empty();
    const auto case_index = static_cast<int>(named - table.cases.begin());
    if (choice.worst) {
        const std::optional<int> worst = member_with_largest_load(table, [&](const MemberRow& row) {
            const auto number = static_cast<int>(&row - table.members.data());
            return (any_case || row.case_index == case_index) &&
                   (!choice.arrangement || number / cases == *choice.arrangement);
        });
        if (!worst) throw InputError("None of these members is done, so none has a largest load yet.");
        return *worst;
    }
    if ((any_case && cases > 1) || (!choice.arrangement && arrangements > 1))
        throw InputError(
            "Which member? Give its number, --case and --arrangement, or --worst for the one with the largest load.");
    return choice.arrangement.value_or(0) * cases + (any_case ? 0 : case_index);
}

FrameTimes chosen_times(const ReplaySubject& subject, const TimeChoice& choice) {
    const Scenario& scenario = subject.about.scenario;
    const double end = scenario.general.time_step * scenario.step_count();
    FrameTimes times{.from = 0, .to = end, .every = 0, .through = 0};
    if (choice.worst) {
        times.through = time_of_largest_load(subject);
        if (std::isnan(times.through))
            throw InputError(fmt::format(
                "{} keeps no load history of member {} (analysis.history_steps = 0), so it does not say when "
                "its largest load came; give --from and --to instead of --worst.",
                subject.file.string(), subject.about.member));
        times.from = std::max(0.0, times.through - round_worst);
        times.to = std::min(end, times.through + round_worst);
    }
    times.from = choice.from.value_or(times.from);
    times.to = choice.to.value_or(times.to);
    times.every = choice.every.value_or(times.to - times.from > long_span ? long_every : short_every);
    return times;
}

}  // namespace floes
