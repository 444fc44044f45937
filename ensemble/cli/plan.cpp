// floes plan: predicts wall time, core-hours, efficiency and sizes of a campaign.

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "cli/plan_text.hpp"
#include "cli/terminal.hpp"
#include "cli/waiting_note.hpp"
#include "core/error.hpp"
#include "core/wording.hpp"

namespace floes {

namespace {

struct PlanOptions {
    std::string config;
    std::vector<int> cores;
    std::vector<int> ranks;
    std::string from;
    double record_bytes = 0;  // 0: the actual size
    std::string format = "table";
    std::vector<std::string> overrides;
};

std::vector<PlanRow> rows_of(const PlanOptions& options, const PlannedMembers& planned) {
    std::vector<int> cores = options.cores;
    if (cores.empty()) cores.push_back(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    if (options.ranks.size() > 1 && options.ranks.size() != cores.size()) {
        throw InputError(fmt::format("--ranks has {} numbers and --cores {}; give one for all, or one for each.",
                                     options.ranks.size(), cores.size()));
    }
    const DriverCosts costs = measured_costs();
    std::vector<PlanRow> rows(cores.size());
    tbb::parallel_for(std::size_t{0}, cores.size(), [&](std::size_t k) {
        int ranks = usual_ranks(cores[k]);
        if (!options.ranks.empty()) ranks = options.ranks[options.ranks.size() == 1 ? 0 : k];
        rows[k] = plan_row(planned.members, cores[k], ranks, costs);
    });
    return rows;
}

std::string plan_text(const PlanOptions& options) {
    const Campaign campaign = load_campaign(options.config, options.overrides);
    const WaitingNote patience(std::cerr, fmt::format("simulating the run of {} on each number of cores …",
                                                      counted(member_count(campaign), "member")));
    PlannedMembers planned =
        options.from.empty() ? expected_members(campaign) : measured_members(campaign, read_measured_run(options.from));
    if (options.record_bytes > 0) set_record_bytes(planned, options.record_bytes);
    const std::vector<PlanRow> rows = rows_of(options, planned);
    return written({plan_section(plan_head(campaign, planned), rows)}, options.format);
}

}  // namespace

void add_plan(CommandLine& line) {
    auto options = std::make_shared<PlanOptions>();
    Verb verb = line.verb("plan", "Predict wall time, core-hours and efficiency of a run");
    verb.option("config", options->config, "The configuration (CONFIG.toml)").required();
    verb.option("--cores", options->cores,
                "Total number of cores, one or several settings; default: the cores of this machine")
        .comma_separated()
        .within(1, 10'000'000);
    verb.option("--ranks", options->ranks,
                "Number of ranks, one for all settings or one for each; default: one for every 64 cores")
        .comma_separated()
        .within(1, 1'000'000);
    verb.option("--from", options->from, "Take run times from this campaign file (CAMPAIGN.h5), finished or running");
    verb.option("--record-bytes", options->record_bytes,
                "Assumed size of a member's result; default: the size of its record")
        .within(1.0, 1e12);
    add_format(verb, options->format);
    add_overrides(verb, options->overrides);
    verb.runs([options] {
        std::fputs(plan_text(*options).c_str(), stdout);
        return 0;
    });
}

}  // namespace floes
