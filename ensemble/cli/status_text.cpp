#include "cli/status_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/wording.hpp"
#include "driver/status_words.hpp"

namespace floes {
namespace {

std::string timed_text(const char* title, const std::vector<TimedMember>& members) {
    if (members.empty()) return {};
    std::string text = fmt::format("\n{}\n", title);
    for (const TimedMember& one : members)
        text +=
            fmt::format("  member {} (case {}, arrangement {}{}): {}\n", one.number, one.case_name, one.arrangement,
                        one.attempt > 1 ? fmt::format(", attempt {}", one.attempt) : "", duration_text(one.seconds));
    return text;
}

nlohmann::ordered_json timed_json(const std::vector<TimedMember>& members) {
    auto json = nlohmann::ordered_json::array();
    for (const TimedMember& one : members)
        json.push_back({{"member", one.number},
                        {"case", one.case_name},
                        {"arrangement", one.arrangement},
                        {"attempt", one.attempt},
                        {"seconds", one.seconds}});
    return json;
}

nlohmann::ordered_json counts_json(const CaseStatus& one) {
    return {{"done", one.done}, {"failed", one.failed}, {"missing", one.missing}, {"total", members_of(one)}};
}

}  // namespace

std::string status_table(const CampaignStatus& status) {
    std::string text = counts_sentence(status) + "\n";
    if (const std::string work = work_sentence(status); !work.empty()) text += work + "\n";
    if (status.stop) text += stop_sentence(*status.stop) + "\n";
    std::size_t width = 4;
    for (const CaseStatus& one : status.cases) width = std::max(width, one.name.size());
    text += fmt::format("\n{:<{}}  {:>6}  {:>6}  {:>6}  {:>6}\n", "case", width, "done", "failed", "to do", "total");
    for (const CaseStatus& one : status.cases)
        text += fmt::format("{:<{}}  {:>6}  {:>6}  {:>6}  {:>6}\n", one.name, width, one.done, one.failed, one.missing,
                            members_of(one));
    if (!status.failures.empty()) text += "\nfailed\n";
    for (const FailedMember& one : status.failures)
        text += fmt::format("  member {} (case {}, arrangement {}): {}\n", one.number, one.case_name, one.arrangement,
                            one.reason);
    text += timed_text("running", status.under_way);
    text += timed_text("slowest", status.slowest);
    return text;
}

std::string status_json(const CampaignStatus& status) {
    nlohmann::ordered_json json{{"title", status.title}};
    json.update(counts_json(total_of(status)));
    json["at_work"] = status.at_work;
    json["seconds_left"] = status.seconds_left ? nlohmann::ordered_json(*status.seconds_left) : nullptr;
    json["stop"] = nullptr;
    if (const auto& stop = status.stop)
        json["stop"] = {{"of", what_of(stop->rule)},
                        {"met", stop->met},
                        {"arrangements", stop->arrangements},
                        {"most_arrangements", stop->most_arrangements},
                        {"half_width_percent", 100 * stop->achieved},
                        {"wanted_percent", 100 * stop->rule.half_width}};
    json["cases"] = nlohmann::ordered_json::array();
    for (const CaseStatus& one : status.cases) {
        nlohmann::ordered_json row{{"name", one.name}};
        row.update(counts_json(one));
        json["cases"].push_back(row);
    }
    json["failures"] = nlohmann::ordered_json::array();
    for (const FailedMember& one : status.failures)
        json["failures"].push_back({{"member", one.number},
                                    {"case", one.case_name},
                                    {"arrangement", one.arrangement},
                                    {"reason", one.reason}});
    json["members_per_second"] = status.rate ? nlohmann::ordered_json(*status.rate) : nullptr;
    json["heartbeat"] = nullptr;
    if (status.heartbeat)
        json["heartbeat"] = {{"host", status.heartbeat->host},
                             {"process", status.heartbeat->process},
                             {"age_s", age_of(*status.heartbeat)},
                             {"stale", !status.at_work}};
    json["under_way"] = timed_json(status.under_way);
    json["slowest"] = timed_json(status.slowest);
    json["sessions"] = nlohmann::ordered_json::array();
    for (const Session& one : status.sessions)
        json["sessions"].push_back({{"started", one.started},
                                    {"ended", one.ended},
                                    {"outcome", one.outcome},
                                    {"host", one.host},
                                    {"job", one.job},
                                    {"ranks", one.ranks},
                                    {"threads", one.threads},
                                    {"reused", one.reused},
                                    {"computed", one.computed},
                                    {"retried", one.retried},
                                    {"set_aside", one.set_aside}});
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace floes
