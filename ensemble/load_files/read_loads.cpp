#include "load_files/read_loads.hpp"

#include <array>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "member/array_output.hpp"
#include "member/quantity.hpp"
#include "store/session.hpp"

namespace floes {

namespace {

void expect_done(const CampaignFile& file, const CampaignTable& table, int member) {
    const std::string name = file.path().string();
    if (member < 0 || member >= std::ssize(table.members))
        throw InputError(
            fmt::format("{} has no member {}: its members are 0 to {}.", name, member, std::ssize(table.members) - 1));
    const MemberRow& row = table.members[static_cast<std::size_t>(member)];
    if (row.status == RowStatus::failed)
        throw InputError(fmt::format("Member {} failed and has no load ({}): choose another.", member, row.reason));
    if (!row.done())
        throw InputError(
            fmt::format("Member {} is not in {} yet: choose another, or compute the rest of the campaign first, floes "
                        "run CONFIG.toml "
                        "-o {} --resume.",
                        member, name, shell_word(name)));
}

/// Histories of how a floating hull lies, rad: empty where the file has none.
struct Lying {
    std::vector<double> pitch, roll;
};

Lying stored_lying(const CampaignFile& file, int member) {
    const std::array both{&array_output("history/pitch"), &array_output("history/roll")};
    Lying lying;
    for_each_histories(
        file, both, [=](int one) { return one == member; },
        [&](const StoredHistories& found) {
            lying.pitch.assign(found.values[0].begin(), found.values[0].end());
            lying.roll.assign(found.values[1].begin(), found.values[1].end());
        });
    return lying;
}

/// The member's load at the scale of the campaign; none where the file keeps no histories of it.
std::optional<LoadSeries> stored_series(const CampaignFile& file, int member, const Lying& lying,
                                        const LoadRequest& request) {
    const std::array forces{&array_output("history/surge_load"), &array_output("history/sway_load"),
                            &array_output("history/heave_load")};
    const std::array turning{&array_output("history/structure_yaw"), &array_output("history/yaw_load")};
    const auto wanted = [=](int one) { return one == member; };
    std::vector<double> yaw;
    std::vector<double> yaw_load;
    for_each_histories(file, turning, wanted, [&](const StoredHistories& found) {
        yaw.assign(found.values[0].begin(), found.values[0].end());
        yaw_load.assign(found.values[1].begin(), found.values[1].end());
    });
    std::optional<LoadSeries> series;
    for_each_histories(file, forces, wanted, [&](const StoredHistories& found) {
        series = load_series(
            {found.step, found.values[0], found.values[1], found.values[2], yaw, yaw_load, lying.pitch, lying.roll},
            request.axes, request.tow_towards * unit::degree);
    });
    return series;
}

LoadSeries cut(const LoadSeries& series, const LoadRequest& request, const std::string& case_name, int stride) {
    const double step = request.step.value_or(series.step);
    if (step < series.step * (1 - 1e-9))
        throw InputError(fmt::format(
            "The loads of case {} are stored as means over {:g} s ({}), and nothing says how they went within: give "
            "--step "
            "{:g} or more{}.",
            case_name, series.step, stride > 1 ? fmt::format("analysis.history_steps = {}", stride) : "a time step",
            series.step, stride > 1 ? ", or run it with analysis.history_steps = 1" : ""));
    const double from = request.from.value_or(0);
    const double to = request.to.value_or(series.length());
    if (from < 0 || to > series.length() * (1 + 1e-9) || whole_steps(from, to, step) == 0)
        throw InputError(
            fmt::format("From {:g} s to {:g} s there is no whole step of {:g} s of the run, which goes from 0 s to "
                        "{:g} s: give --from "
                        "and --to within it.",
                        from, to, step, series.length()));
    return resampled(series, from, to, step);
}

std::string hull_went(const Scenario& scenario) {
    if (scenario.moorings.give_way()) return "gave way on its moorings";
    if (scenario.path.any()) return "followed a path and did not give way";
    if (scenario.field.level_pushed) return "stood still in ice that was pushed on, and did not give way";
    return "was towed straight on and did not give way";
}

LoadOrigin origin_of(const CampaignFile& file, const MemberRow& row, int member, const Case& of) {
    const Campaign& campaign = file.campaign();
    return {.program = "floes " + floes_version(),
            .campaign = campaign.name,
            .fingerprint = fingerprint(campaign),
            .case_name = of.name,
            .arrangement = member_key(campaign, member).arrangement,
            .member = member,
            .hull_went = hull_went(of.scenario),
            .averaged_steps = of.scenario.analysis.history_stride,
            .mean_roll = row.value(quantity("mean_roll_moment")),
            .mean_pitch = -row.value(quantity("mean_pitch_moment")),  // about +z, which is -Y
            .mean_yaw = row.value(quantity("mean_yaw_moment"))};
}

}  // namespace

LoadToWrite read_load(const CampaignFile& file, const CampaignTable& table, int member, const LoadRequest& request) {
    expect_done(file, table, member);
    const MemberRow& row = table.members[static_cast<std::size_t>(member)];
    const Case& of = file.campaign().cases.at(static_cast<std::size_t>(row.case_index));
    const Lying lying = stored_lying(file, member);
    const std::optional<LoadSeries> stored = stored_series(file, member, lying, request);
    if (!stored)
        throw InputError(
            fmt::format("{} keeps no load histories of case {} (analysis.history_steps = 0): run it with "
                        "analysis.history_steps = 1.",
                        file.path().string(), of.name));
    return {.series = cut(scaled(*stored, request.scale), request, of.name, of.scenario.analysis.history_stride),
            .origin = origin_of(file, row, member, of),
            .tilts = of.scenario.moorings.floats() && lying.pitch.empty(),
            .axes = request.axes,
            .tow_towards = request.tow_towards,
            .begin = request.from.value_or(0),
            .scale = request.scale};
}

}  // namespace floes
