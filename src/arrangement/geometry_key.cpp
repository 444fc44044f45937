#include <fmt/format.h>

#include <string>

#include "arrangement/arrangement.hpp"
#include "core/hash.hpp"

namespace floes {

std::uint64_t geometry_key(const Scenario& scenario) {
    const Field& field = scenario.field;
    const ArrangementRule& rule = scenario.arrangement;
    // Numbers are written in the shortest form that reads back exactly, so equal text means equal numbers.
    std::string text = fmt::format("floe {} {}\nfield {} {} {} {}\nrule {} {} {} {} {} {}\n", scenario.floe.length,
                                   scenario.floe.breadth, field.floes, field.concentration, field.begin,
                                   field.half_width, static_cast<int>(rule.method), static_cast<int>(rule.start),
                                   rule.clearance, rule.sweeps, rule.jitter, rule.jitter_angle);
    for (const PlanarPose& pose : rule.poses) text += fmt::format("pose {} {} {}\n", pose.x, pose.z, pose.yaw);
    return digest64(text);
}

}  // namespace floes
