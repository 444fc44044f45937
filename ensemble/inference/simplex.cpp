#include "inference/simplex.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_vector.h>

#include <cmath>
#include <limits>
#include <memory>

namespace floes {

namespace {

constexpr double impossible = 1e300;  // GSL's simplex refuses infinite values

struct VectorDeleter {
    void operator()(gsl_vector* vector) const { gsl_vector_free(vector); }
};
struct MinimizerDeleter {
    void operator()(gsl_multimin_fminimizer* minimizer) const { gsl_multimin_fminimizer_free(minimizer); }
};

/// By default GSL aborts on errors; here they are checked by return value.
class QuietGsl {
  public:
    QuietGsl() : before_(gsl_set_error_handler_off()) {}
    QuietGsl(const QuietGsl&) = delete;
    QuietGsl& operator=(const QuietGsl&) = delete;
    ~QuietGsl() { gsl_set_error_handler(before_); }

  private:
    gsl_error_handler_t* before_;
};

struct Problem {
    const Cost& cost;
    std::vector<double> parameters;

    void read(const gsl_vector* point) {
        for (std::size_t k = 0; k < parameters.size(); ++k) parameters[k] = gsl_vector_get(point, k);
    }
    static double at(const gsl_vector* point, void* self) {
        auto& problem = *static_cast<Problem*>(self);
        problem.read(point);
        const double found = problem.cost(problem.parameters);
        return std::isfinite(found) ? found : impossible;
    }
};

}  // namespace

Minimum walk_simplex(const Cost& cost, std::span<const double> start, const SimplexOptions& options) {
    const QuietGsl quiet;
    const std::size_t count = start.size();
    Problem problem{cost, std::vector<double>(count)};
    gsl_multimin_function function{&Problem::at, count, &problem};
    const std::unique_ptr<gsl_vector, VectorDeleter> point(gsl_vector_alloc(count));
    const std::unique_ptr<gsl_vector, VectorDeleter> steps(gsl_vector_alloc(count));
    gsl_vector_set_all(steps.get(), options.size);
    for (std::size_t k = 0; k < count; ++k) gsl_vector_set(point.get(), k, start[k]);
    const std::unique_ptr<gsl_multimin_fminimizer, MinimizerDeleter> simplex(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, count));
    gsl_multimin_fminimizer_set(simplex.get(), &function, point.get(), steps.get());
    for (int step = 0; step < options.most_steps; ++step) {
        if (gsl_multimin_fminimizer_iterate(simplex.get()) != GSL_SUCCESS) break;
        if (gsl_multimin_fminimizer_size(simplex.get()) < options.small_enough) break;
    }
    problem.read(simplex->x);
    const bool found = simplex->fval < impossible;
    return {std::move(problem.parameters), found ? simplex->fval : std::numeric_limits<double>::infinity()};
}

}  // namespace floes
