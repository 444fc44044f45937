#pragma once
// Monte Carlo of hard convex floes (Metropolis: every arrangement without overlap is equally likely). A trial move
// shifts and turns one floe uniformly and is accepted if the floe then overlaps nothing. A sweep tries every floe once,
// in order. The boundary (walls or periodic) is a template parameter: the reference test checks the same code that
// fills the channel.

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

/// Whether two convex polygons overlap, the second's corners moved by `apart`. Touching is not overlap.
bool overlap(Corners a, Corners b, const Corner& apart);

template <class Boundary>
class HardFloes {
  public:
    /// Outlines about their centroids at least clearance (m) apart, starting at `poses`, one an outline, which must not
    /// overlap. boundary: moved inwards by the clearance.
    HardFloes(const Boundary& boundary, std::span<const Outline> outlines, double clearance,
              std::span<const PlanarPose> poses)
        : boundary_(boundary),
          rectangles_(std::ranges::all_of(outlines, is_rectangle)),
          poses_(poses.begin(), poses.end()),
          bodies_(bodies_of(outlines, 0.5 * clearance)),
          half_diagonal_(std::ranges::max(bodies_, {}, &Body::reach).reach),
          certainly_overlapping_(4 * square(least_half_side(bodies_))),
          cells_({boundary.low_x, boundary.low_z, boundary.length, boundary.breadth, Boundary::periodic},
                 2 * half_diagonal_, poses.size()) {
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            const Turn turn = turn_of(poses_[i].yaw);
            if (!rectangles_) turn_corners(bodies_[i].larger, turn, bodies_[i].corners);
            cells_.insert({poses_[i].x, poses_[i].z, turn, static_cast<int>(i)});
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

    /// Reach of the largest floe, with half the clearance round it, m.
    double half_diagonal() const { return half_diagonal_; }

  private:
    /// Larger: by half the clearance. The walls have been moved inwards by the whole clearance, and want the actual
    /// size.
    struct Body {
        Rectangle rectangle, larger_rectangle;  // of those that are
        Outline own, larger;                    // in its own axes
        Outline corners;                        // of the larger one, turned
        double reach = 0;                       // likewise, m
    };

    static double square(double value) { return value * value; }

    static std::vector<Body> bodies_of(std::span<const Outline> outlines, double margin) {
        std::vector<Body> bodies;
        for (const Outline& one : outlines) {
            Body& body = bodies.emplace_back(Body{{}, {}, one, grown(one, margin), {}, 0});
            body.reach = reach_of(body.larger);
            if (const auto half = half_sides_of(one)) body.rectangle = {half->x, half->z};
            body.larger_rectangle = body.rectangle.grown(margin);
        }
        return bodies;
    }

    static double least_half_side(std::span<const Body> bodies) {
        double half = std::numeric_limits<double>::infinity();
        for (const Body& one : bodies)
            half = std::min({half, one.larger_rectangle.half_length, one.larger_rectangle.half_breadth});
        return half;
    }

    bool try_move(std::size_t floe, const Step& step, RandomStream& random) {
        PlanarPose pose = poses_[floe];
        pose.x += step.shift * (2 * random.uniform() - 1);
        pose.z += step.shift * (2 * random.uniform() - 1);
        pose.yaw += step.turn * (2 * random.uniform() - 1);
        Resident trial{pose.x, pose.z, turn_of(pose.yaw), static_cast<int>(floe)};
        boundary_.into(trial.x, trial.z);
        if (!(rectangles_ ? is_free_rectangle(trial) : is_free(trial))) return false;
        poses_[floe] = {trial.x, trial.z, std::remainder(pose.yaw, 2 * std::numbers::pi)};
        cells_.move(trial);
        return true;
    }

    const Body& body(const Resident& of) const { return bodies_[static_cast<std::size_t>(of.floe)]; }

    /// `see(other, from trial to other)` until it holds of one.
    template <class See>
    bool any_beside(const Resident& trial, const See& see) const {
        return cells_.any_near(trial.x, trial.z, [&](const Resident& other) {
            if (other.floe == trial.floe) return false;
            Corner apart{other.x - trial.x, other.z - trial.z};
            boundary_.nearest(apart.x, apart.z);
            return see(other, apart);
        });
    }

    bool is_free_rectangle(const Resident& trial) const {
        if (!boundary_.admits(body(trial).rectangle, trial.x, trial.z, trial.turn)) return false;
        const TurnedRectangle own{body(trial).larger_rectangle, trial.turn};
        const double certainly_apart = 4 * half_diagonal_ * half_diagonal_;
        return !any_beside(trial, [&](const Resident& other, const Corner& apart) {
            const double squared = dot(apart, apart);
            if (squared >= certainly_apart) return false;
            if (squared < certainly_overlapping_) return true;
            return overlap(own, {body(other).larger_rectangle, other.turn}, apart.x, apart.z);
        });
    }

    /// Leaves its corners there.
    bool is_free(const Resident& trial) {
        Body& own = bodies_[static_cast<std::size_t>(trial.floe)];
        turn_corners(own.own, trial.turn, trial_);
        if (!boundary_.admits(trial_, trial.x, trial.z)) return false;
        turn_corners(own.larger, trial.turn, trial_);
        const bool hits = any_beside(trial, [&](const Resident& other, const Corner& apart) {
            return dot(apart, apart) < square(own.reach + body(other).reach) &&
                   overlap(trial_, body(other).corners, apart);
        });
        if (!hits) std::swap(own.corners, trial_);
        return !hits;
    }

    Boundary boundary_;
    bool rectangles_;  // all are, which takes fewer operations
    std::vector<PlanarPose> poses_;
    std::vector<Body> bodies_;
    double half_diagonal_;          // of the largest
    double certainly_overlapping_;  // squared distance of centres at which the smallest inscribed circles touch, m²
    Cells cells_;
    Outline trial_;  // corners of the one that is tried
};

/// Tunes the step size by rounds of sweeps, each followed by a correction towards the target acceptance. They are part
/// of the chain and also equilibrate it. Returns the step to use from then on.
template <class Boundary>
Step tune(HardFloes<Boundary>& floes, RandomStream& random) {
    constexpr int rounds = 40;
    constexpr int sweeps_per_round = 25;
    constexpr double target = 0.45;  // accepted moves per trial
    const double half_diagonal = floes.half_diagonal();
    double scale = 0.1;  // largest shift in half-diagonals, and turn in radians: a corner moves as far by either
    for (int round = 0; round < rounds; ++round) {
        std::size_t accepted = 0;
        for (int i = 0; i < sweeps_per_round; ++i)
            accepted += static_cast<std::size_t>(floes.sweep({scale * half_diagonal, scale}, random));
        const double trials = static_cast<double>(floes.poses().size()) * sweeps_per_round;
        const double correction = static_cast<double>(accepted) / trials / target;
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

}  // namespace floes
