#include "theory/plate.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/tools/roots.hpp>

#include "core/error.hpp"
#include "theory/kelvin.hpp"

namespace floes {

double FloatingPlate::foundation() const {
    return water_density * gravity;
}

double FloatingPlate::flexural_rigidity(double elastic_modulus) const {
    return elastic_modulus * std::pow(thickness, 3) / (12 * (1 - poisson_ratio * poisson_ratio));
}

double FloatingPlate::characteristic_length(double elastic_modulus) const {
    return std::pow(flexural_rigidity(elastic_modulus) / foundation(), 0.25);
}

double patch_load_slope(const FloatingPlate& plate, double elastic_modulus, double radius) {
    const double x = radius / plate.characteristic_length(elastic_modulus);
    return std::numbers::pi * radius * radius * plate.foundation() / (1 + x * kelvin_ker_prime(x));
}

double modulus_from_point_slope(const FloatingPlate& plate, double slope) {
    const double nu = plate.poisson_ratio;
    return 3.0 / 16.0 * (1 - nu * nu) / (plate.foundation() * std::pow(plate.thickness, 3)) * slope * slope;
}

double modulus_from_patch_slope(const FloatingPlate& plate, double slope, double radius) {
    // E grows with the slope; the softest plate that the Kelvin series reaches has l = a/limit.
    const double nu = plate.poisson_ratio;
    const double softest_length = radius / kelvin_series_limit * (1 + 1e-12);
    const double softest =
        std::pow(softest_length, 4) * plate.foundation() * 12 * (1 - nu * nu) / std::pow(plate.thickness, 3);
    const double stiffest = 4 * modulus_from_point_slope(plate, slope) + 2 * softest;
    const auto excess = [&](double modulus) { return patch_load_slope(plate, modulus, radius) - slope; };
    if (!(excess(softest) < 0))
        throw InputError(
            fmt::format("a slope of {} N/m on a load circle of {} m is too soft for a plate; the water alone "
                        "gives {:.6g} N/m",
                        slope, radius, std::numbers::pi * radius * radius * plate.foundation()));
    std::uintmax_t iterations = 200;
    const auto bracket = boost::math::tools::toms748_solve(excess, softest, stiffest,
                                                           boost::math::tools::eps_tolerance<double>(48), iterations);
    return (bracket.first + bracket.second) / 2;
}

}  // namespace floes
