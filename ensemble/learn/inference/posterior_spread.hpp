#pragma once
// Sigma points: a few sets of parameters, of equal weight, that represent a posterior distribution better than its
// mode.

#include "inference/simplex.hpp"

namespace floes {

/// `cost` is the negative logarithm of the posterior, `least` its minimum at m parameters. m + 1 places at the corners
/// of a regular simplex have the mean and covariance of the normal distribution with the curvature at the minimum (S.
/// J. Julier and J. K. Uhlmann, Proc. Am. Control Conf. 2002, 887-892). A corner where
/// the cost is higher than that distribution's is moved towards the minimum.
std::vector<std::vector<double>> spread(const Cost& cost, const Minimum& least);

}  // namespace floes
