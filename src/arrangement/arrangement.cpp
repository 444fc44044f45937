#include "arrangement/arrangement.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "arrangement/check.hpp"
#include "arrangement/sampler.hpp"
#include "arrangement/starts.hpp"
#include "core/error.hpp"

namespace floes {

namespace {

constexpr int jitter_trials = 10'000;

std::vector<PlanarPose> start(const Scenario& scenario) {
    const ArrangementRule& rule = scenario.arrangement;
    const auto build = rule.start == ArrangementStart::stripes ? stripes_start : lattice_start;
    return build(field_walls(scenario), floe_shape(scenario), rule.clearance, scenario.field.floes);
}

std::vector<PlanarPose> monte_carlo(const Scenario& scenario, RandomStream random) {
    const ArrangementRule& rule = scenario.arrangement;
    HardRectangles floes(field_walls(scenario).shrunk(rule.clearance), floe_shape(scenario), rule.clearance,
                         start(scenario));
    const Step step = tune(floes, random);
    for (int i = 0; i < rule.sweeps; ++i) floes.sweep(step, random);
    return floes.poses();
}

// A floe's turn comes while those after it still lie on their sites, so every draw leaves a valid arrangement behind.
std::vector<PlanarPose> jittered_lattice(const Scenario& scenario, RandomStream random) {
    const ArrangementRule& rule = scenario.arrangement;
    const Walls walls = field_walls(scenario).shrunk(rule.clearance);
    const Rectangle shape = floe_shape(scenario);
    const Rectangle grown = shape.grown(0.5 * rule.clearance);
    std::vector<PlanarPose> poses = lattice_start(field_walls(scenario), shape, rule.clearance, scenario.field.floes);
    if (rule.jitter == 0 && rule.jitter_angle == 0) return poses;
    std::vector<Turn> turns(poses.size());
    const auto is_free = [&](std::size_t floe, const PlanarPose& pose, Turn turn) {
        if (!walls.admits(shape, pose.x, pose.z, turn)) return false;
        for (std::size_t other = 0; other < poses.size(); ++other) {
            if (other == floe) continue;
            if (overlap(grown, turn, turns[other], poses[other].x - pose.x, poses[other].z - pose.z)) return false;
        }
        return true;
    };
    for (std::size_t floe = 0; floe < poses.size(); ++floe) {
        const PlanarPose site = poses[floe];
        int trial = 0;
        for (bool placed = false; !placed; ++trial) {
            if (trial == jitter_trials) {
                throw InputError(fmt::format(
                    "the jittered lattice has no room for floe {} of {} (none in {} trials); lower "
                    "arrangement.jitter_m = {} or arrangement.jitter_angle_deg, or use method = \"monte_carlo\"",
                    floe, poses.size(), jitter_trials, rule.jitter));
            }
            const PlanarPose pose{site.x + random.uniform(-rule.jitter, rule.jitter),
                                  site.z + random.uniform(-rule.jitter, rule.jitter),
                                  site.yaw + random.uniform(-rule.jitter_angle, rule.jitter_angle)};
            const Turn turn = turn_of(pose.yaw);
            placed = is_free(floe, pose, turn);
            if (placed) {
                poses[floe] = pose;
                turns[floe] = turn;
            }
        }
    }
    return poses;
}

}  // namespace

double fourfold_order(std::span<const PlanarPose> poses) {
    double cos_sum = 0;
    double sin_sum = 0;
    for (const PlanarPose& pose : poses) {
        const auto [c, s] = turn_of(pose.yaw);
        const double c2 = c * c - s * s;
        const double s2 = 2 * s * c;
        cos_sum += c2 * c2 - s2 * s2;
        sin_sum += 2 * s2 * c2;
    }
    return std::sqrt(cos_sum * cos_sum + sin_sum * sin_sum) / static_cast<double>(poses.size());
}

Arrangement make_arrangement(const Scenario& scenario, std::uint64_t seed, std::uint32_t number) {
    const ArrangementMethod method = scenario.arrangement.method;
    const auto stream = [&](StreamId id) { return RandomStream(seed, number, id, geometry_key(scenario)); };
    std::vector<PlanarPose> poses = method == ArrangementMethod::file ? scenario.arrangement.poses
                                    : method == ArrangementMethod::lattice
                                        ? jittered_lattice(scenario, stream(StreamId::lattice_jitter))
                                        : monte_carlo(scenario, stream(StreamId::monte_carlo));
    if (const std::optional<std::string> fault = find_fault(scenario, poses)) {
        if (method == ArrangementMethod::file) throw InputError("the given poses are no arrangement: " + *fault);
        throw RunError(fmt::format("arrangement {} is wrong: {}", number, *fault));
    }
    const double psi4 = fourfold_order(poses);
    return {std::move(poses), psi4};
}

}  // namespace floes
