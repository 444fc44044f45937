#pragma once
// Hard-rectangle Monte Carlo (Metropolis: every arrangement without overlap is equally likely). A trial move shifts and
// turns one floe uniformly and is accepted if the floe then overlaps nothing. A sweep tries every floe once, in order.
// The boundary (walls or periodic) is a template parameter: the reference test checks the same code that fills the
// channel.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "arrangement/crowd.hpp"
#include "core/random.hpp"
#include "core/vector.hpp"
#include "shapes/polygon.hpp"

namespace floes {

/// The largest shift along x and z (m), and the largest turn (rad), of a trial move.
struct Step {
    double shift = 0;
    double turn = 0;
};

template <class Boundary>
class HardRectangles {
  public:
    /// Rectangles at least clearance (m) apart, starting at `poses`, one a shape, which must not overlap.
    HardRectangles(const Boundary& boundary, std::span<const Rectangle> shapes, double clearance,
                   std::span<const PlanarPose> poses)
        : boundary_(boundary),
          wall_shapes_(shapes.begin(), shapes.end()),
          shapes_(grown(shapes, 0.5 * clearance)),
          half_diagonal_(widest_reach(shapes_)),
          certainly_apart_(4 * half_diagonal_ * half_diagonal_),
          certainly_overlapping_(4 * square(least_half_side(shapes_))),
          poses_(poses.begin(), poses.end()),
          cells_({boundary.low_x, boundary.low_z, boundary.length, boundary.breadth, Boundary::periodic},
                 2 * half_diagonal_, poses.size()) {
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

    /// Reach of the largest rectangle, with half the clearance round it, m.
    double half_diagonal() const { return half_diagonal_; }

  private:
    static double square(double value) { return value * value; }

    static std::vector<Rectangle> grown(std::span<const Rectangle> shapes, double margin) {
        std::vector<Rectangle> result;
        for (const Rectangle& shape : shapes) result.push_back(shape.grown(margin));
        return result;
    }

    bool try_move(std::size_t floe, const Step& step, RandomStream& random) {
        PlanarPose pose = poses_[floe];
        pose.x += step.shift * (2 * random.uniform() - 1);
        pose.z += step.shift * (2 * random.uniform() - 1);
        pose.yaw += step.turn * (2 * random.uniform() - 1);
        const Resident trial = resident(pose, static_cast<int>(floe));
        if (!boundary_.admits(wall_shapes_[floe], trial.x, trial.z, trial.turn) || hits_another(trial)) return false;
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
        const TurnedRectangle own{shapes_[static_cast<std::size_t>(trial.floe)], trial.turn};
        return cells_.any_near(trial.x, trial.z, [&](const Resident& other) {
            double dx = other.x - trial.x;
            double dz = other.z - trial.z;
            boundary_.nearest(dx, dz);
            const double squared = dx * dx + dz * dz;
            if (squared >= certainly_apart_ || other.floe == trial.floe) return false;
            if (squared < certainly_overlapping_) return true;
            return overlap(own, {shapes_[static_cast<std::size_t>(other.floe)], other.turn}, dx, dz);
        });
    }

    Boundary boundary_;
    std::vector<Rectangle> wall_shapes_;  // actual sizes: the walls have been moved inward by the whole clearance
    std::vector<Rectangle> shapes_;       // grown by half the clearance
    double half_diagonal_;                // of the largest
    double certainly_apart_;        // squared distance of centres at which the largest circumscribed circles touch, m²
    double certainly_overlapping_;  // squared distance of centres at which the smallest inscribed circles touch, m²
    std::vector<PlanarPose> poses_;
    Cells cells_;
};

/// Tuning of the step size: rounds of sweeps, each followed by a correction towards the target acceptance.
struct Tuning {
    int rounds = 40;
    int sweeps_per_round = 25;
    double target = 0.45;  ///< accepted moves per trial
};

/// Samples HardRectangles or HardPolygons. Runs the rounds, which are part of the chain and also equilibrate it.
/// Returns the step to use from then on.
template <class HardFloes>
Step tune(HardFloes& floes, RandomStream& random, const Tuning& tuning = {}) {
    const double half_diagonal = floes.half_diagonal();
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

// Two arrangements to start a Monte Carlo chain from, as different as the channel allows. Neither is random.

/// Rows and columns of a lattice with equal gaps.
struct LatticeSize {
    int columns = 0;   ///< along x
    int rows = 0;      ///< along z
    double gap_x = 0;  ///< between columns, and to the walls, m
    double gap_z = 0;  ///< between rows, and to the walls, m
};

/// The lattice of count rectangles inside the walls with the largest smaller gap. Throws InputError if that gap is
/// below clearance (m): without a lattice there is no start.
LatticeSize lattice_size(const Walls& walls, const Rectangle& shape, double clearance, int count);

/// Rows and columns with equal gaps, all yaws 0. psi4 = 1, even density. Sites after `count` stay empty.
std::vector<PlanarPose> lattice_start(const Walls& walls, const Rectangle& shape, double clearance, int count);

/// The columns of that lattice pushed together to one side and to the near end; those of the near half lean one way,
/// the others the other way, as far as space allows. psi4 about 0.6 in the paper's channel, uneven density.
std::vector<PlanarPose> stripes_start(const Walls& walls, const Rectangle& shape, double clearance, int count);

// A lattice whose floes are randomly shifted and turned about their sites: a broken sheet that has not drifted.

/// Largest shift along x and along z (m) and largest turn (rad) of a floe from its site.
struct Jitter {
    double shift = 0;
    double turn = 0;
};

/// A floe of each shape, at least clearance (m) apart and from the walls, each uniformly distributed over the positions
/// within its jitter that the others leave free. Throws InputError if floes fit on no lattice, or if a floe finds no
/// position in 10 000 trials.
std::vector<PlanarPose> jittered_lattice(const Walls& walls, std::span<const Rectangle> shapes, double clearance,
                                         const Jitter& jitter, RandomStream& random);

// Monte Carlo of hard convex polygons between walls: sampler.hpp for other shapes than rectangles, with the same moves
// by the same draws. Squares given as outlines take the very steps of squares.

/// Whether two convex polygons overlap: separation() below 0. Touching is not overlap.
bool overlap(Corners a, Corners b);

class HardPolygons {
  public:
    /// Outlines about their centroids at least clearance (m) apart, starting at `poses`, one an outline, which must not
    /// overlap. walls: moved inward by the clearance.
    HardPolygons(const Walls& walls, std::span<const Outline> outlines, double clearance,
                 std::span<const PlanarPose> poses);

    /// As HardRectangles'.
    int sweep(const Step& step, RandomStream& random);
    const std::vector<PlanarPose>& poses() const { return poses_; }
    double half_diagonal() const { return widest_; }

  private:
    struct Body {
        Outline own;      // in its own axes
        Outline larger;   // likewise, grown by half the clearance
        Outline corners;  // of the larger one, where it is
        double reach;     // of the larger one, m
    };
    bool try_move(std::size_t polygon, const Step& step, RandomStream& random);
    bool hits_another(const Resident& trial, Corners corners) const;

    Walls walls_;
    std::vector<Body> bodies_;
    double widest_;  // the largest reach, m
    std::vector<PlanarPose> poses_;
    Cells cells_;
    Outline trial_;  // corners of the one that is tried
};

}  // namespace floes
