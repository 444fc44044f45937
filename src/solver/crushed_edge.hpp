#pragma once
// How deep the edge at a point of contact is crushed, from step to step. A blow may be over within a step, and a step
// finds bodies that met on the way as deep in each other as they went in it: so the overlap alone says how deep only
// where a blow takes many steps. The work of the contact says it at any: it is what the crushing took
// (docs/contact.md).

#include <algorithm>
#include <cmath>

namespace floes {

struct CrushedEdge {
    double depth = 0;      ///< m, >= 0, when the step begins
    double ahead = 0;      ///< m, depth less the overlap
    double approach = 0;   ///< m/s, >= 0, when the step begins
    double force = 0;      ///< N, at which the edge yields at that depth
    double stiffness = 0;  ///< N/m, what that gains per depth

    /// Before a solve. overlap: now, m; speed: of approach, m/s; impulse: along the normal, of the last step, N s.
    /// least: the speed below which bodies count as standing, what sweeps leave; their jitter crushes nothing.
    ///
    /// The last step took the edge on by x, with F x + K x²/2 = impulse * (mean of the speeds of approach before and
    /// after it), and the bodies by speed * time_step. Where nothing acted they only came to where they overlap.
    void begin_step(double overlap, double speed, double impulse, double time_step, double least) {
        const double now = speed > least ? speed : 0;
        const double work = 0.5 * impulse * (approach + now);
        const double crushed = work > 0 ? 2 * work / (force + std::sqrt(force * force + 2 * stiffness * work)) : 0;
        depth = std::max(0.0, overlap + ahead + crushed - now * time_step);
        ahead = depth - overlap;
        approach = now;
    }

    /// The mean depth of a step at whose end the bodies stand, if they slow down evenly: where the section is taken.
    double mean_depth(double time_step) const { return depth + approach * time_step / 3; }

    /// After a solve. at_mean: N, at which the edge yields at the mean depth; gain: N/m.
    void end_step(double at_mean, double gain, double time_step) {
        force = std::max(0.0, at_mean - gain * approach * time_step / 3);
        stiffness = gain;
    }
};

}  // namespace floes
