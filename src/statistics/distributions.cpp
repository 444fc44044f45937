#include "statistics/distributions.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace floes {

using boost::math::cdf;
using boost::math::complement;
using boost::math::quantile;

double normal_below(double z) {
    return cdf(boost::math::normal(), z);
}

double normal_above(double z) {
    return cdf(complement(boost::math::normal(), z));
}

double normal_quantile(double share) {
    return quantile(boost::math::normal(), share);
}

double normal_quantile_above(double tail) {
    return quantile(complement(boost::math::normal(), tail));
}

double student_above(double t, double freedom) {
    return cdf(complement(boost::math::students_t(freedom), t));
}

double student_t(double freedom, double tail) {
    return quantile(complement(boost::math::students_t(freedom), tail));
}

double chi_squared_above(double value, double freedom) {
    return cdf(complement(boost::math::chi_squared(freedom), value));
}

double chi_squared_quantile_above(double tail, double freedom) {
    return quantile(complement(boost::math::chi_squared(freedom), tail));
}

double fisher_quantile_above(double tail, double freedom_above, double freedom_below) {
    return quantile(complement(boost::math::fisher_f(freedom_above, freedom_below), tail));
}

}  // namespace floes
