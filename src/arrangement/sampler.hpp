#pragma once
// Hard-rectangle Monte Carlo (Metropolis: every arrangement without overlap is equally likely). A trial move shifts and
// turns one floe uniformly and is accepted if the floe then overlaps nothing. A sweep tries every floe once, in order.
// The boundary (walls or periodic) is a template parameter: the reference test checks the same code that fills the
// channel.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "arrangement/boundary.hpp"
#include "arrangement/cells.hpp"
#include "core/random.hpp"
#include "core/vector.hpp"

namespace floes {

/// The largest shift along x and z (m), and the largest turn (rad), of a trial move.
struct Step {
    double shift = 0;
    double turn = 0;
};

template <class Boundary>
class HardRectangles {
  public:
    /// Rectangles of one shape at least clearance (m) apart, starting at `poses`, which must not overlap.
    HardRectangles(const Boundary& boundary, const Rectangle& shape, double clearance,
                   std::span<const PlanarPose> poses)
        : boundary_(boundary),
          wall_shape_(shape),
          shape_(shape.grown(0.5 * clearance)),
          certainly_apart_(4 * shape_.half_diagonal() * shape_.half_diagonal()),
          certainly_overlapping_(4 * square(std::min(shape_.half_length, shape_.half_breadth))),
          poses_(poses.begin(), poses.end()),
          cells_({boundary.low_x, boundary.low_z, boundary.length, boundary.breadth, Boundary::periodic},
                 2 * shape_.half_diagonal(), poses.size()) {
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            cells_.insert({poses_[i].x, poses_[i].z, turn_of(poses_[i].yaw), static_cast<int>(i)});
        }
    }

    /// Tries every floe once. Returns the number of accepted moves. Three draws for each floe.
    int sweep(const Step& step, RandomStream& random) {
        int accepted = 0;
        for (std::size_t i = 0; i < poses_.size(); ++i) accepted += try_move(i, step, random);
        return accepted;
    }

    /// Where the floes are now. Yaw in [-pi, pi].
    const std::vector<PlanarPose>& poses() const { return poses_; }

    const Rectangle& shape() const { return shape_; }

  private:
    static double square(double value) { return value * value; }

    bool try_move(std::size_t floe, const Step& step, RandomStream& random) {
        PlanarPose pose = poses_[floe];
        pose.x += step.shift * (2 * random.uniform() - 1);
        pose.z += step.shift * (2 * random.uniform() - 1);
        pose.yaw += step.turn * (2 * random.uniform() - 1);
        const Resident trial = resident(pose, static_cast<int>(floe));
        if (!boundary_.admits(wall_shape_, trial.x, trial.z, trial.turn) || hits_another(trial)) return false;
        poses_[floe] = {trial.x, trial.z, std::remainder(pose.yaw, 2 * std::numbers::pi)};
        cells_.move(trial);
        return true;
    }

    Resident resident(const PlanarPose& pose, int floe) const {
        Resident result{pose.x, pose.z, turn_of(pose.yaw), floe};
        boundary_.into(result.x, result.z);
        return result;
    }

    bool hits_another(const Resident& trial) const {
        return cells_.any_near(trial.x, trial.z, [&](const Resident& other) {
            double dx = other.x - trial.x;
            double dz = other.z - trial.z;
            boundary_.nearest(dx, dz);
            const double squared = dx * dx + dz * dz;
            if (squared >= certainly_apart_ || other.floe == trial.floe) return false;
            return squared < certainly_overlapping_ || overlap(shape_, trial.turn, other.turn, dx, dz);
        });
    }

    Boundary boundary_;
    Rectangle wall_shape_;          // actual size: the walls have been moved inward by the whole clearance
    Rectangle shape_;               // grown by half the clearance
    double certainly_apart_;        // squared distance of centres at which circumscribed circles touch, m²
    double certainly_overlapping_;  // squared distance of centres at which inscribed circles touch, m²
    std::vector<PlanarPose> poses_;
    Cells cells_;
};

/// Tuning of the step size: rounds of sweeps, each followed by a correction towards the target acceptance.
struct Tuning {
    int rounds = 40;
    int sweeps_per_round = 25;
    double target = 0.45;  ///< accepted moves per trial
};

/// Runs the rounds, which are part of the chain and also equilibrate it. Returns the step to use from then on.
template <class Boundary>
Step tune(HardRectangles<Boundary>& floes, RandomStream& random, const Tuning& tuning = {}) {
    const double half_diagonal = floes.shape().half_diagonal();
    double scale =
        0.1;  // largest shift in half-diagonals, and largest turn in radians: a corner moves as far by either
    for (int round = 0; round < tuning.rounds; ++round) {
        std::size_t accepted = 0;
        for (int i = 0; i < tuning.sweeps_per_round; ++i) {
            accepted += static_cast<std::size_t>(floes.sweep({scale * half_diagonal, scale}, random));
        }
        const double trials = static_cast<double>(floes.poses().size()) * tuning.sweeps_per_round;
        const double correction = static_cast<double>(accepted) / trials / tuning.target;
        scale = std::min(1.0, scale * std::min(1.5, std::max(0.5, correction)));
    }
    return {scale * half_diagonal, scale};
}

}  // namespace floes
