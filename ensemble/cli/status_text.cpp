#include "cli/status_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/wording.hpp"
#include "driver/progress.hpp"

namespace floes {
namespace {

CaseStatus total_of(const CampaignStatus& status) {
    CaseStatus total{"all", 0, 0, 0};
    for (const CaseStatus& one : status.cases) {
        total.done += one.done;
        total.failed += one.failed;
        total.missing += one.missing;
    }
    return total;
}

int members_of(const CaseStatus& one) {
    return one.done + one.failed + one.missing;
}

/// With a stop rule the run may end sooner.
std::string left_text(const CampaignStatus& status) {
    return fmt::format(", {} {} left", status.stop ? "at most" : "about", duration_text(*status.seconds_left));
}

std::string work_line(const CampaignStatus& status, int missing) {
    if (status.sessions.empty()) return missing > 0 ? "Continue it with floes run --resume.\n" : "";
    const Session& last = status.sessions.back();
    if (status.at_work)
        return fmt::format("Running: {}, {} from {} since {}{}{}.\n", counted(last.ranks, "rank"),
                           counted(last.threads, "thread"), last.host, last.started,
                           status.rate ? ", " + rate_text(*status.rate) : "",
                           status.seconds_left ? left_text(status) : "");
    if (missing == 0) return fmt::format("Ended {}.\n", last.ended.empty() ? "at an unknown time" : last.ended);
    if (last.ended.empty() && status.heartbeat)
        return fmt::format(
            "The run started on {} at {} (process {}) sent its last heartbeat {} ago: it was killed; continue it "
            "with floes run --resume.\n",
            last.host, last.started, status.heartbeat->process, duration_text(age_of(*status.heartbeat)));
    if (last.ended.empty())
        return fmt::format(
            "The run started on {} at {} was killed or is running on another machine; if it was killed, continue "
            "it with floes run --resume.\n",
            last.host, last.started);
    return fmt::format("Ended {} ({}); continue it with floes run --resume.\n", last.ended, last.outcome);
}

/// "mean_load of every case", "mean_load of E200 - E60".
std::string what_of(const StopRule& rule) {
    std::string text = rule.of;
    if (rule.case_name != "none") text += rule.case_name == "all" ? " of every case" : " of case " + rule.case_name;
    if (rule.contrast != "none") {
        text += rule.case_name != "none" ? " and" : "";
        text += rule.contrast == "all" ? " of every difference of two cases" : " of " + rule.contrast;
    }
    return text;
}

std::string stop_line(const StopStatus& stop) {
    const std::string most =
        stop.most_arrangements > stop.arrangements ? fmt::format(" of at most {}", stop.most_arrangements) : "";
    const std::string reached =
        std::isnan(stop.achieved)
            ? fmt::format("not known yet, target {:g} %", 100 * stop.rule.half_width)
            : fmt::format("{:.1f} %, target {:g} %", 100 * stop.achieved, 100 * stop.rule.half_width);
    if (stop.met)
        return fmt::format("Precise enough after {}{}, no more are needed. Half-width for {}: {}.\n",
                           counted(stop.arrangements, "arrangement"), most, what_of(stop.rule), reached);
    return fmt::format("Half-width for {} after {}{}: {}.\n", what_of(stop.rule),
                       counted(stop.arrangements, "arrangement"), most, reached);
}

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
    const CaseStatus total = total_of(status);
    std::string text = fmt::format("{}: {} of {} done, {} failed, {} to do\n", status.title, total.done,
                                   counted(members_of(total), "member"), total.failed, total.missing);
    text += work_line(status, total.missing);
    if (status.stop) text += stop_line(*status.stop);
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
