// floes status: the members of a campaign that are done, failed and still to do. Works during a run. Writes nothing
// except, on request, a page.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "cli/commands.hpp"
#include "cli/status_text.hpp"
#include "cli/write_page.hpp"
#include "page/status_page.hpp"
#include "records/session.hpp"

namespace floes {

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
