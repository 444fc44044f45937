#include "campaign/lost_digits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {

namespace {

double largest_of(std::span<const double> numbers) {
    double largest = 0;
    for (const double one : numbers) largest = std::max(largest, std::abs(one));
    return largest;
}

bool all_multiples(std::span<const double> numbers, double step) {
    return std::ranges::all_of(numbers, [&](double one) { return std::fmod(one, step) == 0; });
}

}  // namespace

double single_precision_step(std::span<const double> numbers) {
    const double largest = largest_of(numbers);
    if (!(largest > 0 && largest < std::numeric_limits<float>::max())) return 0;
    if (std::ranges::any_of(numbers, [](double one) { return static_cast<double>(static_cast<float>(one)) != one; }))
        return 0;
    const double step = std::nextafter(static_cast<float>(largest), std::numeric_limits<float>::infinity()) - largest;
    return all_multiples(numbers, 2 * step) ? 0 : step;
}

double decimal_step(std::span<const double> numbers) {
    constexpr double most_wasted = 1e4;  // five digits
    double step = 1;
    while (10 * step * most_wasted <= largest_of(numbers) && all_multiples(numbers, 10 * step)) step *= 10;
    return step > 1 ? step : 0;
}

}  // namespace floes
