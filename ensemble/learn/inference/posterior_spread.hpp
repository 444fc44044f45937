#pragma once
// Parameters that stand for a posterior distribution: a few of equal weight instead of the likeliest alone.

#include "inference/simplex.hpp"

namespace floes {

/// `cost` is the negative logarithm of the posterior, `least` its minimum at m parameters. m + 1 places at the corners
/// of a regular simplex have the mean and covariance of the normal distribution with the curvature at the minimum (S.
/// J. Julier and J. K. Uhlmann, Proc. Am. Control Conf. 2002, 887-892). Where the cost rises faster than that on the
/// way to a corner, the corner is drawn in.
std::vector<std::vector<double>> spread(const Cost& cost, const Minimum& least);

}  // namespace floes
