// floes status: the members of a campaign that are done, failed and still to do. Works during a run. Writes nothing
// except, on request, a page.

#include "cli/status.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "core/text.hpp"
#include "page/status_page.hpp"
#include "run/campaign_status.hpp"
#include "store/session.hpp"
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

namespace {

struct StatusOptions {
    std::string file;
    std::string format = "table";
    std::string page;
    bool watch = false;
};

constexpr const char* clear_screen = "\033[H\033[2J";
constexpr std::chrono::seconds watch_interval{2};
constexpr std::chrono::seconds page_interval{status_page_seconds};
constexpr int least_pause_per_look = 10;  // reading a large campaign takes seconds

/// Prints the status or writes its page. Returns whether a run is active.
bool show(const StatusOptions& options) {
    if (!options.page.empty()) {
        const CampaignSnapshot snapshot = read_snapshot(options.file);
        write_page(options.page, status_page(snapshot, options.file, utc_now()));
        return snapshot.status.at_work;
    }
    const CampaignStatus status = read_status(options.file);
    if (options.watch && options.format == "table" && ::isatty(STDOUT_FILENO) == 1) std::fputs(clear_screen, stdout);
    std::fputs((options.format == "json" ? status_json(status) : status_table(status)).c_str(), stdout);
    std::fflush(stdout);
    return status.at_work;
}

void watch(const StatusOptions& options) {
    using Clock = std::chrono::steady_clock;
    const Clock::duration interval = options.page.empty() ? watch_interval : page_interval;
    while (true) {
        const auto begin = Clock::now();
        if (!show(options)) return;
        std::this_thread::sleep_for(std::max(interval, least_pause_per_look * (Clock::now() - begin)));
    }
}

}  // namespace

void add_status(CommandLine& line) {
    auto options = std::make_shared<StatusOptions>();
    Verb verb = line.verb("status", "Show the members done, failed and still to do, also during a run");
    verb.option("campaign", options->file, "The campaign file (CAMPAIGN.h5); its journal is read from the same folder")
        .required();
    Option format = verb.option("--format", options->format, "table or json");
    format.one_of({"table", "json"}).shows_default();
    verb.option("--html", options->page,
                "Write one HTML page instead, with the report's first section as far as members are done; with "
                "--watch anew every 30 s, and the page loads itself again")
        .excludes(format);
    verb.flag("--watch", options->watch, "Repeat every few seconds until no run is active");
    verb.runs([options] {
        if (options->watch) {
            watch(*options);
        } else {
            show(*options);
        }
        if (!options->page.empty()) std::printf("%s\n", options->page.c_str());
        return 0;
    });
}

}  // namespace floes
