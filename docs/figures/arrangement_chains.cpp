// Follows Monte Carlo chains of the paper's channel from both starts and prints what docs/figures/arrangement.py draws:
//   arrangement_chains CHAINS SWEEPS
//   chain,START,number,sweeps,psi4,near_far,sway,columns   at rising numbers of sweeps
//   pose,START,number,sweeps,x,z,yaw                       at 0 sweeps of chain 0, and of all chains at SWEEPS / 2
// near_far: mean cos(pi (x - begin) / length), the slowest wave of the density; sway: mean z, m; columns: |mean exp(2
// pi i x / pitch)| with the pitch of the lattice start.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "arrangement/order.hpp"
#include "arrangement/sampler.hpp"
#include "core/digest.hpp"

namespace {

using namespace floes;

struct Channel {
    Scenario scenario;
    Walls walls = field_walls(scenario);
    Rectangle shape = rectangles(floes_of(scenario)).front();
    double clearance = scenario.arrangement.clearance;
    int count = scenario.field.floes;

    HardFloes<Walls> chain(const std::vector<PlanarPose>& poses) const {
        return {walls.shrunk(clearance), std::vector(poses.size(), corners_of(shape.half_length, shape.half_breadth)),
                clearance, poses};
    }
};

void print_state(const Channel& channel, const std::string& name, std::span<const PlanarPose> poses) {
    const double pitch = lattice_size(channel.walls, channel.shape, channel.clearance, channel.count).gap_x +
                         2 * channel.shape.half_length;
    double near_far = 0, sway = 0, column_cos = 0, column_sin = 0;
    for (const PlanarPose& pose : poses) {
        const double x = pose.x - channel.walls.low_x;
        near_far += std::cos(std::numbers::pi * x / channel.walls.length) / channel.count;
        sway += pose.z / channel.count;
        column_cos += std::cos(2 * std::numbers::pi * x / pitch) / channel.count;
        column_sin += std::sin(2 * std::numbers::pi * x / pitch) / channel.count;
    }
    fmt::print("chain,{},{:.6f},{:.6f},{:.6f},{:.6f}\n", name, fourfold_order(poses), near_far, sway,
               std::hypot(column_cos, column_sin));
}

void print_poses(const std::string& name, std::span<const PlanarPose> poses) {
    for (const PlanarPose& pose : poses) fmt::print("pose,{},{:.5f},{:.5f},{:.5f}\n", name, pose.x, pose.z, pose.yaw);
}

void follow(const Channel& channel, const char* start_name, const std::vector<PlanarPose>& start, std::uint32_t number,
            int sweeps) {
    const auto name = [&](int sweep) { return fmt::format("{},{},{}", start_name, number, sweep); };
    RandomStream random(1, number, StreamId::monte_carlo, digest64(start_name));
    HardFloes tuned = channel.chain(lattice_start(channel.walls, channel.shape, channel.clearance, channel.count));
    const Step step = tune(tuned, random);
    HardFloes floes = channel.chain(start);
    print_state(channel, name(0), floes.poses());
    if (number == 0) print_poses(name(0), floes.poses());
    double next = 100;
    for (int sweep = 1; sweep <= sweeps; ++sweep) {
        floes.sweep(step, random);
        if (sweep == sweeps / 2) print_poses(name(sweep), floes.poses());
        if (sweep < next && sweep != sweeps) continue;
        print_state(channel, name(sweep), floes.poses());
        next *= 1.1;
    }
}

}  // namespace

int main(int count, char** values) {
    if (count != 3) {
        fmt::print(stderr, "usage: arrangement_chains CHAINS SWEEPS\n");
        return 2;
    }
    const Channel channel;
    const auto lattice = lattice_start(channel.walls, channel.shape, channel.clearance, channel.count);
    const auto stripes = stripes_start(channel.walls, channel.shape, channel.clearance, channel.count);
    for (int i = 0; i < std::atoi(values[1]); ++i) {
        follow(channel, "lattice", lattice, static_cast<std::uint32_t>(i), std::atoi(values[2]));
        follow(channel, "stripes", stripes, static_cast<std::uint32_t>(i), std::atoi(values[2]));
    }
}
