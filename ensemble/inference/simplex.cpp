#include "inference/simplex.hpp"

#include <nlopt.h>

#include <cmath>
#include <limits>
#include <memory>

namespace floes {

namespace {

struct OptimizerDeleter {
    void operator()(nlopt_opt_s* optimizer) const { nlopt_destroy(optimizer); }
};

double cost_at(unsigned count, const double* point, double*, void* cost) {
    const double found = (*static_cast<const Cost*>(cost))({point, count});
    return std::isfinite(found) ? found : std::numeric_limits<double>::infinity();
}

}  // namespace

Minimum walk_simplex(const Cost& cost, std::span<const double> start, const SimplexOptions& options) {
    Minimum found{{start.begin(), start.end()}, std::numeric_limits<double>::infinity()};
    const std::unique_ptr<nlopt_opt_s, OptimizerDeleter> simplex(
        nlopt_create(NLOPT_LN_NELDERMEAD, static_cast<unsigned>(start.size())));
    nlopt_set_min_objective(simplex.get(), cost_at, const_cast<Cost*>(&cost));
    nlopt_set_initial_step1(simplex.get(), options.size);
    nlopt_set_xtol_abs1(simplex.get(), options.small_enough);
    nlopt_set_maxeval(simplex.get(), options.most_costs);
    // Any status will do: the least cost so far stands in `found`.
    nlopt_optimize(simplex.get(), found.at.data(), &found.cost);
    return found;
}

}  // namespace floes
