#pragma once
// The local minimum of a function of a few parameters without derivatives: the Nelder-Mead simplex of NLopt.

#include <functional>
#include <span>
#include <vector>

namespace floes {

/// Cost of parameters; anything that is not finite counts as outside their range.
using Cost = std::function<double(std::span<const double>)>;

struct Minimum {
    std::vector<double> at;
    double cost;  ///< infinite if no finite cost was met
};

struct SimplexOptions {
    double size;          ///< edge of the first simplex, the same along all parameters
    double small_enough;  ///< ends when no corner is farther than this from their centre along any parameter
    int most_costs = 4000;
};

/// Walks from `start`. Scale the parameters so that one size suits all. Deterministic.
Minimum walk_simplex(const Cost& cost, std::span<const double> start, const SimplexOptions& options);

}  // namespace floes
