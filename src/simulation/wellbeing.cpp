#include "simulation/wellbeing.hpp"

#include <fmt/format.h>

#include <cmath>

namespace floes {
namespace {

bool within(double value, double low, double high) {
    return value >= low && value <= high;
}  // false for NaN

}  // namespace

Wellbeing::Wellbeing(const Scenario& scenario, const Channel& channel)
    : speed(scenario.general.runaway_speed),
      begin(channel.begin - channel.room - channel.drift),
      end(channel.end + channel.room + channel.drift),
      outer_edge(channel.outer_edge + channel.drift),
      top(channel.room),
      bottom(scenario.structure.shape.bottom() - channel.room) {}

std::optional<std::string> Wellbeing::trouble(const BodyState& state) const {
    const Vec3& at = state.position;
    if (!at.allFinite() || !state.rotation.allFinite() || !state.velocity.allFinite() ||
        !state.angular_velocity.allFinite()) {
        return "has a state that is not a number";
    }
    if (state.velocity.squaredNorm() > speed * speed) {
        return fmt::format("has run away: its speed is {:.4g} m/s, over runaway_speed = {:.4g} m/s",
                           state.velocity.norm(), speed);
    }
    if (!within(at.z(), -outer_edge, outer_edge)) {
        return fmt::format("is gone: it lies at z = {:.4g} m, beyond the outer edge of a wall sheet at {:.4g} m",
                           at.z(), std::copysign(outer_edge, at.z()));
    }
    if (!within(at.x(), begin, end)) {
        return fmt::format("is gone: it lies at x = {:.4g} m, outside the channel from {:.4g} to {:.4g} m", at.x(),
                           begin, end);
    }
    if (!within(at.y(), bottom, top)) {
        return fmt::format("is gone: it lies at height {:.4g} m, outside {:.4g} to {:.4g} m", at.y(), bottom, top);
    }
    return std::nullopt;
}

}  // namespace floes
