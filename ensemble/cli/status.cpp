// floes status: the members of a campaign that are done, failed and still to do. Works during a run and changes
// nothing.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "cli/commands.hpp"
#include "cli/status_text.hpp"

namespace floes {

namespace {

struct StatusOptions {
    std::string file;
    std::string format = "table";
    bool watch = false;
};

constexpr const char* clear_screen = "\033[H\033[2J";
constexpr std::chrono::seconds watch_interval{2};
constexpr int least_pause_per_look = 10;  // reading a large campaign takes seconds

/// Shows the status. Returns whether a run is active.
bool show(const StatusOptions& options) {
    const CampaignStatus status = read_status(options.file);
    if (options.watch && options.format == "table" && ::isatty(STDOUT_FILENO) == 1) std::fputs(clear_screen, stdout);
    std::fputs((options.format == "json" ? status_json(status) : status_table(status)).c_str(), stdout);
    std::fflush(stdout);
    return status.at_work;
}

void watch(const StatusOptions& options) {
    using Clock = std::chrono::steady_clock;
    while (true) {
        const auto begin = Clock::now();
        if (!show(options)) return;
        std::this_thread::sleep_for(
            std::max<Clock::duration>(watch_interval, least_pause_per_look * (Clock::now() - begin)));
    }
}

}  // namespace

void add_status(CLI::App& program, int& exit_status) {
    auto options = std::make_shared<StatusOptions>();
    CLI::App* verb =
        program.add_subcommand("status", "Show the members done, failed and still to do, also during a run");
    verb->add_option("campaign", options->file,
                     "The campaign file (CAMPAIGN.h5); its journal is read from the same folder")
        ->required();
    verb->add_option("--format", options->format, "table or json")
        ->check(CLI::IsMember({"table", "json"}))
        ->capture_default_str();
    verb->add_flag("--watch", options->watch, "Repeat every few seconds until no run is active");
    verb->callback([options, &exit_status] {
        if (options->watch) {
            watch(*options);
        } else {
            show(*options);
        }
        exit_status = 0;
    });
}

}  // namespace floes
