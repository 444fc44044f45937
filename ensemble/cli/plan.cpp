// What `floes plan` prints.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "cli/commands.hpp"
#include "cli/config.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "run/plan.hpp"
#include "tables/section.hpp"

namespace floes {

/// Values common to all rows.
struct PlanHead {
    std::string title;
    int members = 0;
    double mean_run_time = 0;  ///< s
    double longest = 0;        ///< s
    double message_bytes = 0;  ///< the largest answer
    std::string source;        ///< origin of the run times
    bool calibrates = false;   ///< cases are calibrated first, which the plan does not count
};

PlanHead plan_head(const Campaign& campaign, const PlannedMembers& planned);

/// For people with a note on the bottleneck of each setting that has one. In JSON one object, in CSV a line for each
/// setting; times in s, sizes in bytes.
Section plan_section(const PlanHead& head, std::span<const PlanRow> rows);

namespace {

constexpr double busy_master = 0.7;

std::string size(double bytes) {
    constexpr std::array units{"B", "kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    for (; bytes >= 1000 && unit + 1 < units.size(); ++unit) bytes /= 1000;
    return bytes < 100 ? fmt::format("{:.2g} {}", bytes, units[unit]) : fmt::format("{:.0f} {}", bytes, units[unit]);
}

double core_hours(const PlanRow& row) {
    return row.cores * row.forecast.wall_time / unit::hour;
}

std::string remark(const PlanHead& head, const PlanRow& row) {
    const Forecast& forecast = row.forecast;
    const std::string cores = counted(row.cores, "core");
    if (forecast.master_load > busy_master)
        return fmt::format("{}: the master is busy {:.0f} % of the time; more cores gain little.", cores,
                           100 * forecast.master_load);
    if (forecast.writer_load > busy_master)
        return fmt::format("{}: ranks that keep results are busy {:.0f} % of the time; ask for more with --writers.",
                           cores, 100 * forecast.writer_load);
    if (forecast.wall_time - forecast.last_member > 0.1 * forecast.wall_time)
        return fmt::format(
            "{}: start-up takes {} of the time, and writing the campaign file {}; floes run --no-file "
            "leaves that to one core.",
            cores, duration_in_figures(forecast.start_up), duration_in_figures(forecast.file_time));
    if (forecast.efficiency < 0.9 && head.members < 3 * row.cores)
        return fmt::format("{}: too few members; cores are idle while the last ones run.", cores);
    return "";
}

}  // namespace

PlanHead plan_head(const Campaign& campaign, const PlannedMembers& planned) {
    PlanHead head;
    head.title = campaign.name;
    head.members = member_count(campaign);
    for (const SimulatedMember& member : planned.members) {
        head.mean_run_time += member.run_time / head.members;
        head.longest = std::max(head.longest, member.run_time);
        head.message_bytes = std::max(head.message_bytes, member.record_bytes);
    }
    head.source = planned.source;
    head.calibrates = std::ranges::count(campaign.cases, Pairing::find_cfm, &Case::pairing) > 0;
    return head;
}

Section plan_section(const PlanHead& head, std::span<const PlanRow> rows) {
    Section section;
    section.before = fmt::format("{}: {} of {} on average, {} at most, {} each.\nRun times: {}.\n", head.title,
                                 counted(head.members, "member"), duration_in_figures(head.mean_run_time),
                                 duration_in_figures(head.longest), size(head.message_bytes), head.source);
    if (head.calibrates) section.before += "Not counted: cases are calibrated first, about a minute.\n";
    section.before += "\n";
    Results common = object("", {{"campaign", head.title},
                                 {"members", head.members},
                                 {"mean_run_time_s", head.mean_run_time},
                                 {"longest_run_time_s", head.longest},
                                 {"message_bytes", head.message_bytes},
                                 {"run_times_from", head.source},
                                 {"calibration_not_counted", head.calibrates}});
    Results plans{.place = "plans",
                  .columns = {{"cores", "cores"},
                              {"ranks", "ranks"},
                              {"", "wall time"},
                              {"wall_time_s"},
                              {.key = "core_hours", .words = "core-hours", .digits = 4},
                              {.key = "efficiency", .words = "efficiency", .unit = "share", .decimals = 1},
                              {.key = "master_busy", .words = "master busy", .unit = "share", .digits = 2},
                              {"start_up_s"},
                              {"last_member_s"},
                              {"file_s"},
                              {"writers"},
                              {"writer_busy"},
                              {"", "file"},
                              {"file_bytes"},
                              {"", "journal"},
                              {"journal_bytes"},
                              {"", "master memory"},
                              {"master_memory_bytes"}}};
    for (const PlanRow& row : rows) {
        const Forecast& forecast = row.forecast;
        plans.add({row.cores, row.ranks, duration_in_figures(forecast.wall_time), forecast.wall_time, core_hours(row),
                   forecast.efficiency, forecast.master_load, forecast.start_up, forecast.last_member,
                   forecast.file_time, forecast.writers, forecast.writer_load, size(forecast.file_bytes),
                   std::round(forecast.file_bytes), size(forecast.journal_bytes), forecast.journal_bytes,
                   size(row.master_memory), row.master_memory});
        if (const std::string told = remark(head, row); !told.empty()) section.notes.push_back(told);
    }
    section.results = {std::move(common), std::move(plans)};
    return section;
}

// floes plan: predicts wall time, core-hours, efficiency and sizes of a campaign.

namespace {

struct PlanOptions {
    std::string config;
    std::vector<int> cores;
    std::vector<int> ranks;
    std::string from;
    double record_bytes = 0;  // 0: the actual size
    int writers = 0;
    bool no_file = false;
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
        Machine machine = machine_of(cores[k], ranks);
        machine.writers = options.writers;
        rows[k] = plan_row(planned.members, machine, costs, !options.no_file);
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
    verb.option("--writers", options->writers, "Number of ranks that keep results; default: one for every 64 ranks")
        .within(1, 1'000'000);
    verb.flag("--no-file", options->no_file, "Of a run that leaves the campaign file to a later --resume");
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
