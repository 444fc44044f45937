#pragma once
// Draws from a distribution of a few parameters of which only the density is known, up to a factor: the adaptive
// Metropolis walk of H. Haario, E. Saksman and J. Tamminen, Bernoulli 7 (2001) 223-242. It adapts in its first part
// only, which is thrown away, so that the rest is an ordinary Metropolis walk.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "inference/simplex.hpp"

namespace floes {

/// Log of the density at parameters; -infinity outside their range.
using LogDensity = std::function<double(std::span<const double>)>;

struct WalkOptions {
    int steps = 6000;        ///< after the first part, which is a third as long
    int kept = 600;          ///< draws, evenly spaced over the steps
    std::uint32_t draw = 0;  ///< each number gives another, independent walk
};

struct Walk {
    std::vector<std::vector<double>> draws;
    /// Log of the integral of the density, by Laplace's method with the covariance of the draws.
    double log_evidence = 0;
};

/// Walks from `start`, where the density is positive, with first steps of about `sizes`. Deterministic. No draws if the
/// density at the start is not finite.
Walk walk_at_random(const LogDensity& density, std::span<const double> start, std::span<const double> sizes,
                    const WalkOptions& options = {});

// Sigma points: a few sets of parameters, of equal weight, that represent a posterior distribution better than its
// mode.

/// `cost` is the negative logarithm of the posterior, `least` its minimum at m parameters. m + 1 places at the corners
/// of a regular simplex have the mean and covariance of the normal distribution with the curvature at the minimum (S.
/// J. Julier and J. K. Uhlmann, Proc. Am. Control Conf. 2002, 887-892). A corner where
/// the cost is higher than that distribution's is moved towards the minimum.
std::vector<std::vector<double>> spread(const Cost& cost, const Minimum& least);

}  // namespace floes
