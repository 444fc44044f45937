#include "cli/plan_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/units.hpp"
#include "core/wording.hpp"

namespace floes {
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
    const double after = forecast.wall_time - forecast.last_member;
    if (after > 0.1 * forecast.wall_time)
        return fmt::format("{}: start-up takes {} of the time, and writing the campaign file {}.", cores,
                           duration_in_figures(forecast.start_up), duration_in_figures(after));
    if (forecast.efficiency < 0.9 && head.members < 3 * row.cores)
        return fmt::format("{}: too few members; cores are idle while the last ones run.", cores);
    return "";
}

std::vector<DataRows> plan_records(const PlanHead& head, std::span<const PlanRow> rows) {
    DataRows common =
        make_object<PlanHead>("", head,
                              {{"campaign", [](const PlanHead& one) { return Datum(one.title); }},
                               {"members", [](const PlanHead& one) { return Datum(one.members); }},
                               {"mean_run_time_s", [](const PlanHead& one) { return Datum(one.mean_run_time); }},
                               {"longest_run_time_s", [](const PlanHead& one) { return Datum(one.longest); }},
                               {"message_bytes", [](const PlanHead& one) { return Datum(one.message_bytes); }},
                               {"run_times_from", [](const PlanHead& one) { return Datum(one.source); }},
                               {"calibration_not_counted", [](const PlanHead& one) { return Datum(one.calibrates); }}});
    DataRows plans = make_rows<PlanRow>(
        "plans", rows,
        {{"cores", [](const PlanRow& row) { return Datum(row.cores); }},
         {"ranks", [](const PlanRow& row) { return Datum(row.ranks); }},
         {"wall_time_s", [](const PlanRow& row) { return Datum(row.forecast.wall_time); }},
         {"core_hours", [](const PlanRow& row) { return Datum(core_hours(row)); }},
         {"efficiency", [](const PlanRow& row) { return Datum(row.forecast.efficiency); }},
         {"master_busy", [](const PlanRow& row) { return Datum(row.forecast.master_load); }},
         {"start_up_s", [](const PlanRow& row) { return Datum(row.forecast.start_up); }},
         {"last_member_s", [](const PlanRow& row) { return Datum(row.forecast.last_member); }},
         {"file_bytes", [](const PlanRow& row) { return Datum(std::round(row.forecast.file_bytes)); }},
         {"journal_bytes", [](const PlanRow& row) { return Datum(row.forecast.journal_bytes); }},
         {"master_memory_bytes", [](const PlanRow& row) { return Datum(row.master_memory); }}});
    return {json_only(std::move(common)), std::move(plans)};
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
    Section section{.records = plan_records(head, rows)};
    section.before = fmt::format("{}: {} of {} on average, {} at most, {} each.\nRun times: {}.\n", head.title,
                                 counted(head.members, "member"), duration_in_figures(head.mean_run_time),
                                 duration_in_figures(head.longest), size(head.message_bytes), head.source);
    if (head.calibrates) section.before += "Not counted: cases are calibrated first, about a minute.\n";
    section.before += "\n";
    section.table = {
        {"cores", "ranks", "wall time", "core-hours", "efficiency", "master busy", "file", "journal", "master memory"}};
    for (const PlanRow& row : rows) {
        const Forecast& forecast = row.forecast;
        section.table.push_back({fmt::format("{}", row.cores), fmt::format("{}", row.ranks),
                                 duration_in_figures(forecast.wall_time), fmt::format("{:.4g}", core_hours(row)),
                                 fmt::format("{:.1f} %", 100 * forecast.efficiency),
                                 fmt::format("{:.2g} %", 100 * forecast.master_load), size(forecast.file_bytes),
                                 size(forecast.journal_bytes), size(row.master_memory)});
        if (const std::string told = remark(head, row); !told.empty()) section.notes.push_back(told);
    }
    return section;
}

}  // namespace floes
