#include "cli/status_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/wording.hpp"
#include "driver/status_words.hpp"
#include "tables/data_rows.hpp"

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

DataRows timed_records(const char* place, const std::vector<TimedMember>& members) {
    return make_rows<TimedMember>(place, members,
                                  {{"member", [](const TimedMember& one) { return Datum(one.number); }},
                                   {"case", [](const TimedMember& one) { return Datum(one.case_name); }},
                                   {"arrangement", [](const TimedMember& one) { return Datum(one.arrangement); }},
                                   {"attempt", [](const TimedMember& one) { return Datum(one.attempt); }},
                                   {"seconds", [](const TimedMember& one) { return Datum(one.seconds); }}});
}

std::vector<DataColumn<CaseStatus>> count_columns() {
    return {{"done", [](const CaseStatus& one) { return Datum(one.done); }},
            {"failed", [](const CaseStatus& one) { return Datum(one.failed); }},
            {"missing", [](const CaseStatus& one) { return Datum(one.missing); }},
            {"total", [](const CaseStatus& one) { return Datum(members_of(one)); }}};
}

/// The value, or null where there is none.
template <class Value>
Datum known(const std::optional<Value>& value) {
    return value ? Datum(*value) : Datum(Undefined{});
}

DataRows head_records(const CampaignStatus& status) {
    return make_object<CampaignStatus>(
        "", status,
        {{"title", [](const CampaignStatus& one) { return Datum(one.title); }},
         {"at_work", [](const CampaignStatus& one) { return Datum(one.at_work); }},
         {"seconds_left", [](const CampaignStatus& one) { return known(one.seconds_left); }},
         {"members_per_second", [](const CampaignStatus& one) { return known(one.rate); }},
         {"stop", [](const CampaignStatus&) { return Datum(Undefined{}); }},
         {"heartbeat", [](const CampaignStatus&) { return Datum(Undefined{}); }}});
}

DataRows stop_records(const StopStatus& stop) {
    return make_object<StopStatus>(
        "stop", stop,
        {{"of", [](const StopStatus& one) { return Datum(what_of(one.rule)); }},
         {"met", [](const StopStatus& one) { return Datum(one.met); }},
         {"arrangements", [](const StopStatus& one) { return Datum(one.arrangements); }},
         {"most_arrangements", [](const StopStatus& one) { return Datum(one.most_arrangements); }},
         {"half_width_percent", [](const StopStatus& one) { return Datum(100 * one.achieved); }},
         {"wanted_percent", [](const StopStatus& one) { return Datum(100 * one.rule.half_width); }}});
}

DataRows heartbeat_records(const Heartbeat& heartbeat, bool at_work) {
    return make_object<Heartbeat>("heartbeat", heartbeat,
                                  {{"host", [](const Heartbeat& one) { return Datum(one.host); }},
                                   {"process", [](const Heartbeat& one) { return Datum(one.process); }},
                                   {"age_s", [](const Heartbeat& one) { return Datum(age_of(one)); }},
                                   {"stale", [=](const Heartbeat&) { return Datum(!at_work); }}});
}

DataRows case_records(const std::vector<CaseStatus>& cases) {
    std::vector<DataColumn<CaseStatus>> columns{{"name", [](const CaseStatus& one) { return Datum(one.name); }}};
    for (const DataColumn<CaseStatus>& count : count_columns()) columns.push_back(count);
    return make_rows<CaseStatus>("cases", cases, columns);
}

DataRows failure_records(const std::vector<FailedMember>& failures) {
    return make_rows<FailedMember>("failures", failures,
                                   {{"member", [](const FailedMember& one) { return Datum(one.number); }},
                                    {"case", [](const FailedMember& one) { return Datum(one.case_name); }},
                                    {"arrangement", [](const FailedMember& one) { return Datum(one.arrangement); }},
                                    {"reason", [](const FailedMember& one) { return Datum(one.reason); }}});
}

DataRows session_records(const std::vector<Session>& sessions) {
    return make_rows<Session>("sessions", sessions,
                              {{"started", [](const Session& one) { return Datum(one.started); }},
                               {"ended", [](const Session& one) { return Datum(one.ended); }},
                               {"outcome", [](const Session& one) { return Datum(one.outcome); }},
                               {"host", [](const Session& one) { return Datum(one.host); }},
                               {"job", [](const Session& one) { return Datum(one.job); }},
                               {"ranks", [](const Session& one) { return Datum(one.ranks); }},
                               {"threads", [](const Session& one) { return Datum(one.threads); }},
                               {"reused", [](const Session& one) { return Datum(one.reused); }},
                               {"computed", [](const Session& one) { return Datum(one.computed); }},
                               {"retried", [](const Session& one) { return Datum(one.retried); }},
                               {"set_aside", [](const Session& one) { return Datum(one.set_aside); }}});
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
    std::vector<DataRows> all{head_records(status), make_object("", total_of(status), count_columns()),
                              case_records(status.cases), failure_records(status.failures)};
    if (status.stop) all.push_back(stop_records(*status.stop));
    if (status.heartbeat) all.push_back(heartbeat_records(*status.heartbeat, status.at_work));
    all.push_back(timed_records("under_way", status.under_way));
    all.push_back(timed_records("slowest", status.slowest));
    all.push_back(session_records(status.sessions));
    return json(all);
}

}  // namespace floes
