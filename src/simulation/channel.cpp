#include "simulation/channel.hpp"

#include <algorithm>
#include <cmath>

namespace floes {
namespace {

/// Floes pass round the structure and stay between walls. 1 m in the paper's tank.
double room_for_a_floe(const FloeSet& floes) {
    return 5 * largest_side(floes) / 3;
}

/// Length of the sides of a field without end, m. The same for every run, or the bits of a load would tell how long
/// its run is; twice the longest tow (scenario/checks_endless.cpp).
constexpr double without_end = 2e5;

/// How far wind and current can take floes beside what the tow pushes, at most: with the current, and by the wind
/// against skin drag alone.
double drift_of(const Scenario& scenario) {
    const Water& water = scenario.water;
    const double duration = scenario.analysis.steady_start + scenario.analysis.window;
    const double least_drag = 0.5 * water.density * std::max(water.skin_drag, 1e-3);
    return duration * (water.current + std::sqrt(scenario.wind.stress().norm() / least_drag));
}

IceSheet sheet(const Scenario& scenario, const Vec2& x_range, const Vec2& z_range) {
    const Vec2 x_part{x_range.mean(), 0.5 * (x_range.y() - x_range.x())};
    const Vec2 z_part{z_range.mean(), 0.5 * (z_range.y() - z_range.x())};
    return {{x_part.x(), scenario.floe.floating_height(scenario.ice, scenario.water.density), z_part.x()},
            {x_part.y(), 0.5 * scenario.floe.thickness, z_part.y()},
            Vec3::Zero(),
            0};
}

}  // namespace

Channel make_channel(const Scenario& scenario, const FloeSet& floes) {
    const Field& field = scenario.field;
    const bool closed = field.far_end == FarEnd::ice_sheet;
    const double towed = scenario.towed();
    Channel channel;
    channel.room = room_for_a_floe(floes);
    channel.begin = scenario.structure.start - scenario.structure.shape.largest_radius() - channel.room;
    channel.end = scenario.field_end() + field.sheet_width + (closed ? 0.0 : towed);
    if (field.endless()) channel.end = channel.begin + without_end;
    channel.inner_edge = field.half_width;
    channel.outer_edge = field.half_width + field.sheet_width;
    const bool moves = field.confining > 0;
    const double drift = drift_of(scenario);
    if (moves || field.sides == FieldSides::open || drift > 0) channel.drift = drift + towed;
    const Vec2 along{channel.begin, channel.end};
    const auto add = [&](const Vec2& x_range, const Vec2& z_range, const Vec3& inwards, double faces) {
        IceSheet& added = channel.sheets.emplace_back(sheet(scenario, x_range, z_range));
        added.inwards = inwards;
        added.faces = faces;
    };
    if (field.sides == FieldSides::ice_sheet) {
        const double faces = scenario.field_length();
        add(along, {channel.inner_edge, channel.outer_edge}, -Vec3::UnitZ(), faces);
        add(along, {-channel.outer_edge, -channel.inner_edge}, Vec3::UnitZ(), faces);
    }
    if (closed) {  // a sheet that moves leaves no gap at the corners when the sides give way
        const double edge = moves ? channel.outer_edge : channel.inner_edge;
        add({scenario.field_end(), channel.end}, {-edge, edge}, -Vec3::UnitX(), 2 * channel.inner_edge);
    }
    return channel;
}

}  // namespace floes
