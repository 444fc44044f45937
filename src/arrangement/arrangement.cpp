#include "arrangement/arrangement.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "arrangement/check.hpp"
#include "arrangement/jittered_lattice.hpp"
#include "arrangement/sampler.hpp"
#include "arrangement/starts.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"

namespace floes {

namespace {

std::vector<PlanarPose> monte_carlo(const Scenario& scenario, RandomStream random) {
    const ArrangementRule& rule = scenario.arrangement;
    const Walls walls = field_walls(scenario);
    const Rectangle shape = floe_shape(scenario);
    const auto begin_at = [&](const std::vector<PlanarPose>& poses) {
        return HardRectangles(walls.shrunk(rule.clearance), shape, rule.clearance, poses);
    };
    // The step is tuned for the field, not for the start: tuned where floes are packed, it would be too short for the
    // chain ever to leave the start.
    HardRectangles floes = begin_at(lattice_start(walls, shape, rule.clearance, scenario.field.floes));
    const Step step = tune(floes, random);
    if (rule.start == ArrangementStart::stripes) {
        floes = begin_at(stripes_start(walls, shape, rule.clearance, scenario.field.floes));
    }
    for (int i = 0; i < rule.sweeps; ++i) floes.sweep(step, random);
    return floes.poses();
}

std::vector<PlanarPose> lattice(const Scenario& scenario, RandomStream random) {
    const ArrangementRule& rule = scenario.arrangement;
    return jittered_lattice(field_walls(scenario), floe_shape(scenario), rule.clearance, scenario.field.floes,
                            {rule.jitter, rule.jitter_angle}, random);
}

std::vector<PlanarPose> find_poses(const Scenario& scenario, std::uint64_t seed, std::uint32_t number) {
    const std::uint64_t geometry = geometry_key(scenario);
    switch (scenario.arrangement.method) {
        case ArrangementMethod::file:
            return scenario.arrangement.poses;
        case ArrangementMethod::lattice:
            return lattice(scenario, RandomStream(seed, number, StreamId::lattice_jitter, geometry));
        case ArrangementMethod::monte_carlo:
            break;
    }
    return monte_carlo(scenario, RandomStream(seed, number, StreamId::monte_carlo, geometry));
}

}  // namespace

std::uint64_t geometry_key(const Scenario& scenario) {
    const Field& field = scenario.field;
    const ArrangementRule& rule = scenario.arrangement;
    // A number is written in the fewest digits that give it back, so equal text means equal numbers.
    std::string text = fmt::format("floe {} {}\nfield {} {} {} {}\nrule {} {} {} {} {} {}\n", scenario.floe.length,
                                   scenario.floe.breadth, field.floes, field.concentration, field.begin,
                                   field.half_width, static_cast<int>(rule.method), static_cast<int>(rule.start),
                                   rule.clearance, rule.sweeps, rule.jitter, rule.jitter_angle);
    for (const PlanarPose& pose : rule.poses) text += fmt::format("pose {} {} {}\n", pose.x, pose.z, pose.yaw);
    return digest64(text);
}

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
    std::vector<PlanarPose> poses = find_poses(scenario, seed, number);
    if (const std::optional<Fault> fault = find_fault(scenario, poses)) {
        if (scenario.arrangement.method == ArrangementMethod::file) {
            throw InputError(fmt::format("the given poses are no arrangement of this field: {}", fault->sentence));
        }
        throw RunError(fmt::format("arrangement {} came out wrong, which is an error of the program: {}", number,
                                   fault->sentence));
    }
    const double psi4 = fourfold_order(poses);
    return {std::move(poses), psi4};
}

}  // namespace floes
