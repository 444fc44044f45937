#include "simulation/channel.hpp"

namespace floes {
namespace {

/// Floes pass round the structure and stay between walls. 1 m in the paper's tank.
double room_for_a_floe(const FloeSet& floes) {
    return 5 * largest_side(floes) / 3;
}

IceSheet sheet(const Scenario& scenario, const Vec2& x_range, const Vec2& z_range) {
    const Vec2 x_part{x_range.mean(), 0.5 * (x_range.y() - x_range.x())};
    const Vec2 z_part{z_range.mean(), 0.5 * (z_range.y() - z_range.x())};
    return {{x_part.x(), scenario.floe.floating_height(scenario.ice, scenario.water.density), z_part.x()},
            {x_part.y(), 0.5 * scenario.floe.thickness, z_part.y()}};
}

}  // namespace

Channel make_channel(const Scenario& scenario, const FloeSet& floes) {
    const Field& field = scenario.field;
    const bool closed = field.far_end == FarEnd::ice_sheet;
    const double towed = scenario.structure.speed * (scenario.analysis.steady_start + scenario.analysis.window);
    Channel channel;
    channel.room = room_for_a_floe(floes);
    channel.begin = scenario.structure.start - scenario.structure.shape.largest_radius() - channel.room;
    channel.end = scenario.field_end() + field.sheet_width + (closed ? 0.0 : towed);
    channel.inner_edge = field.half_width;
    channel.outer_edge = field.half_width + field.sheet_width;
    const Vec2 along{channel.begin, channel.end};
    channel.sheets.push_back(sheet(scenario, along, {channel.inner_edge, channel.outer_edge}));
    channel.sheets.push_back(sheet(scenario, along, {-channel.outer_edge, -channel.inner_edge}));
    if (closed) {
        const Vec2 across{-channel.inner_edge, channel.inner_edge};
        channel.sheets.push_back(sheet(scenario, {scenario.field_end(), channel.end}, across));
    }
    return channel;
}

}  // namespace floes
