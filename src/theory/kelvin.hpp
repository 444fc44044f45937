#pragma once
// The Kelvin function that a plate on a liquid needs (Abramowitz & Stegun 9.9; DLMF 10.61, 10.65).

namespace floes {

/// Largest argument for which the power series below keeps 10 digits.
inline constexpr double kelvin_series_limit = 8.0;

/// ker'(x), x in (0, kelvin_series_limit]; ker'(x) -> -1/x as x -> 0. Throws InputError outside.
double kelvin_ker_prime(double x);

}  // namespace floes
