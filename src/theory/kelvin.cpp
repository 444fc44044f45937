#include "theory/kelvin.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {
namespace {

// ber, bei and the digamma-weighted sum of ker are power series in t = (x²/4). Term n belongs to t^n/(n!)² with the
// sign of i^n, and weight ψ(n + 1) = -γ + H_n. Even n make ber and ker, odd n bei.
struct KelvinSums {
    double ber = 0, ber_prime = 0, bei_prime = 0, ker_sum_prime = 0;
};

KelvinSums kelvin_sums(double x) {
    KelvinSums sums;
    const double t = x * x / 4;
    double power = 1;  // t^n/(n!)²
    double digamma = -std::numbers::egamma;
    for (int n = 0; n < 80; ++n) {
        const double sign = (n % 4 < 2) ? 1 : -1;
        const double value = sign * power;
        const double slope = value * 2 * n / x;  // d/dx t^n = 2 n t^n/x
        if (n % 2 == 0) {
            sums.ber += value;
            sums.ber_prime += slope;
            sums.ker_sum_prime += digamma * slope;
        } else {
            sums.bei_prime += slope;
        }
        power *= t / ((n + 1.0) * (n + 1.0));
        digamma += 1.0 / (n + 1);
        if (power < 1e-40) break;
    }
    return sums;
}

}  // namespace

double kelvin_ker_prime(double x) {
    if (!(x > 0 && x <= kelvin_series_limit))
        throw InputError(fmt::format("the Kelvin functions are evaluated at x = {}; allowed is above 0 to {}", x,
                                     kelvin_series_limit));
    const KelvinSums s = kelvin_sums(x);
    // ker = -ln(x/2) ber + (π/4) bei + Σ ψ ..., differentiated term by term
    return -s.ber / x - std::log(x / 2) * s.ber_prime + std::numbers::pi / 4 * s.bei_prime + s.ker_sum_prime;
}

}  // namespace floes
