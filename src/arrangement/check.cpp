#include "arrangement/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace floes {

namespace {

constexpr double rounding = 1e-9;        // m
constexpr double area_rounding = 1e-12;  // relative

}  // namespace

Rectangle floe_shape(const Scenario& scenario) {
    return {0.5 * scenario.floe.length, 0.5 * scenario.floe.breadth};
}

Walls field_walls(const Scenario& scenario) {
    const Field& field = scenario.field;
    return {field.begin, -field.half_width, scenario.field_length(), 2 * field.half_width};
}

std::optional<std::string> find_fault(const Scenario& scenario, std::span<const PlanarPose> poses) {
    const Field& field = scenario.field;
    const double clearance = scenario.arrangement.clearance;
    if (poses.size() != static_cast<std::size_t>(field.floes)) {
        return fmt::format("the arrangement has {} floes where the field has {}", poses.size(), field.floes);
    }
    const double covered = field.floes * scenario.floe.length * scenario.floe.breadth;
    const double concentration = covered / ((scenario.field_end() - field.begin) * 2 * field.half_width);
    if (!(std::abs(concentration - field.concentration) <= area_rounding * field.concentration)) {
        return fmt::format("the floes cover {} of the field instead of {}", concentration, field.concentration);
    }
    const Walls walls = field_walls(scenario).shrunk(clearance - rounding);
    const Rectangle grown = floe_shape(scenario).grown(0.5 * (clearance - rounding));
    std::vector<Turn> turns;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const PlanarPose& pose = poses[i];
        // Checked before the turn is computed, which NaN does not have.
        if (!(std::abs(pose.yaw) < 1e6)) return fmt::format("floe {} has the yaw {} rad", i, pose.yaw);
        turns.push_back(turn_of(pose.yaw));
        if (!walls.admits(floe_shape(scenario), pose.x, pose.z, turns.back())) {
            return fmt::format(
                "floe {} at x = {:.4f} m, z = {:.4f} m, yaw = {:.4f} rad is not inside the field with a clearance of "
                "{} m",
                i, pose.x, pose.z, pose.yaw, clearance);
        }
    }
    for (std::size_t i = 0; i < poses.size(); ++i) {
        for (std::size_t j = i + 1; j < poses.size(); ++j) {
            if (overlap(grown, turns[i], turns[j], poses[j].x - poses[i].x, poses[j].z - poses[i].z)) {
                return fmt::format(
                    "floes {} and {}, at x = {:.4f} m, z = {:.4f} m and x = {:.4f} m, z = {:.4f} m, are closer than "
                    "the clearance of {} m",
                    i, j, poses[i].x, poses[i].z, poses[j].x, poses[j].z, clearance);
            }
        }
    }
    return std::nullopt;
}

}  // namespace floes
