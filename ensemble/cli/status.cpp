// floes status: the members of a campaign that are done, failed and still to do. Works during a run. Writes nothing
// except, on request, a page.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "cli/commands.hpp"
#include "cli/watch.hpp"
#include "page/page.hpp"
#include "run/campaign_status.hpp"
#include "store/session.hpp"
#include "tables/section.hpp"

namespace floes {

namespace {

std::string timed_text(const char* title, const std::vector<TimedMember>& members) {
    if (members.empty()) return {};
    std::string text = fmt::format("\n{}\n", title);
    for (const TimedMember& one : members)
        text += fmt::format("  member {} (case {}, arrangement {}{}): {}\n", one.number, one.case_name, one.arrangement,
                            one.attempt > 1 ? fmt::format(", attempt {}", one.attempt) : "", time_words(one));
    return text;
}

Results timed(std::string place, const std::vector<TimedMember>& members) {
    return list(std::move(place), "member case arrangement attempt seconds simulated_s of_s", members,
                [](const TimedMember& one) -> std::vector<Datum> {
                    const bool told = one.end > 0;
                    return {one.number,
                            one.case_name,
                            one.arrangement,
                            one.attempt,
                            one.seconds,
                            if_known(told, one.time),
                            if_known(told, one.end)};
                });
}

}  // namespace

std::string status_table(const CampaignStatus& status) {
    std::string text = counts_sentence(status) + "\n";
    if (const std::string work = work_sentence(status); !work.empty()) text += work + "\n";
    if (status.stop) text += stop_sentence(*status.stop) + "\n";
    for (const std::string& remark : status.remarks) text += remark + "\n";
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
    const CaseStatus total = total_of(status);
    std::vector<Results> all{
        object("", {{"title", status.title},
                    {"at_work", status.at_work},
                    {"seconds_left", if_known(status.seconds_left.has_value(), status.seconds_left.value_or(0))},
                    {"members_per_second", if_known(status.rate.has_value(), status.rate.value_or(0))},
                    {"stop", Undefined{}},
                    {"heartbeat", Undefined{}},
                    {"parts", Undefined{}},
                    {"done", total.done},
                    {"failed", total.failed},
                    {"missing", total.missing},
                    {"total", members_of(total)}})};
    all.push_back(
        list("cases", "name done failed missing total", status.cases, [](const CaseStatus& one) -> std::vector<Datum> {
            return {one.name, one.done, one.failed, one.missing, members_of(one)};
        }));
    all.push_back(list("failures", "member case arrangement reason", status.failures,
                       [](const FailedMember& one) -> std::vector<Datum> {
                           return {one.number, one.case_name, one.arrangement, one.reason};
                       }));
    if (const auto& stop = status.stop)
        all.push_back(object("stop", {{"of", what_of(stop->rule)},
                                      {"met", stop->met},
                                      {"arrangements", stop->arrangements},
                                      {"most_arrangements", stop->most_arrangements},
                                      {"half_width_percent", 100 * stop->achieved},
                                      {"wanted_percent", 100 * stop->rule.half_width}}));
    if (const auto& heartbeat = status.heartbeat)
        all.push_back(object("heartbeat", {{"host", heartbeat->host},
                                           {"process", heartbeat->process},
                                           {"age_s", age_of(*heartbeat)},
                                           {"stale", !status.at_work}}));
    all.push_back(list("remarks", "sentence", status.remarks,
                       [](const std::string& one) -> std::vector<Datum> { return {one}; }));
    if (const auto& parts = status.parts)
        all.push_back(object("parts", {{"parts", parts->parts},
                                       {"running", parts->running},
                                       {"threads", parts->threads},
                                       {"hosts", parts->hosts}}));
    all.push_back(timed("under_way", status.under_way));
    all.push_back(timed("slowest", status.slowest));
    all.push_back(list("sessions", "started ended outcome host job ranks threads reused computed retried set_aside",
                       status.sessions, [](const Session& one) -> std::vector<Datum> {
                           return {one.started, one.ended,  one.outcome,  one.host,    one.job,      one.ranks,
                                   one.threads, one.reused, one.computed, one.retried, one.set_aside};
                       }));
    return json(std::vector{Section{.results = std::move(all)}});
}

namespace {

struct StatusOptions {
    std::vector<std::string> files;
    std::string format = "table";
    std::string page;
    bool watch = false;

    std::vector<std::filesystem::path> paths() const { return {files.begin(), files.end()}; }
};

/// Prints the status or writes its page. Returns whether a run is active.
bool show(const StatusOptions& options) {
    if (!options.page.empty()) {
        const CampaignSnapshot snapshot = read_snapshot(options.paths());
        write_page(options.page, status_page(snapshot, options.files.front(), utc_now()));
        return snapshot.status.at_work;
    }
    const CampaignStatus status = read_status(options.paths());
    std::fputs((options.format == "json" ? status_json(status) : status_table(status)).c_str(), stdout);
    std::fflush(stdout);
    return status.at_work;
}

void watch(const StatusOptions& options) {
    if (options.page.empty() && options.format == "table" && ::isatty(STDOUT_FILENO) == 1) {
        watch_on_terminal(options.paths());
        show(options);
        return;
    }
    using Clock = std::chrono::steady_clock;
    const Clock::duration interval = options.page.empty() ? watch_interval : std::chrono::seconds(status_page_seconds);
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
    verb.option("campaign", options->files,
                "The campaign file (CAMPAIGN.h5), or the parts of one; journals are read from the same folder")
        .required();
    Option format = verb.option("--format", options->format, "table or json");
    format.one_of({"table", "json"}).shows_default();
    verb.option("--html", options->page,
                "Write one HTML page instead, with the report's first section as far as members are done; with "
                "--watch anew every 30 s, and the page loads itself again")
        .file_ending({".html", ".htm"})
        .excludes(format);
    verb.flag("--watch", options->watch,
              "Until no run is active or q is pressed, fill the terminal: bars by case, intervals, failures, what runs "
              "and what "
              "is slowest; elsewhere repeat every few seconds");
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
