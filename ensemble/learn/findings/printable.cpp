#include "findings/printable.hpp"

#include <cmath>

#include "statistics/distributions.hpp"
#include "tables/number_text.hpp"

namespace floes {

bool says_something(double estimate, Limits limits, int runs) {
    constexpr double widest = 4;  // of the estimate
    if (runs < fewest_for_interval || !std::isfinite(limits.low) || !std::isfinite(limits.high)) return false;
    return limits.high > limits.low && limits.high - limits.low <= widest * std::abs(estimate);
}

bool says_something(const Quantity& quantity, double estimate, Limits limits, int runs) {
    if (limits.low <= quantity.least && limits.high >= quantity.most) return false;  // as wide as can be
    const bool has_a_sign = quantity.least < 0 && std::isfinite(quantity.least);
    return says_something(has_a_sign ? limits.high - limits.low : estimate, limits, runs);
}

std::string printable_bracket(const Quantity& quantity, double estimate, Limits limits, int runs, int decimals) {
    if (!std::isfinite(estimate)) return "";
    if (!says_something(quantity, estimate, limits, runs)) return "–";
    const double factor = quantity.factor();
    return bracket(factor * limits.low, factor * limits.high, decimals);
}

int arrangements_for(const Interval& found, int runs, double share) {
    constexpr int most = 10'000;
    constexpr double tail = 0.025;
    const double half = std::max(found.high - found.estimate, found.estimate - found.low);
    if (runs < 2 || !std::isfinite(half) || found.estimate == 0 || half == 0) return 0;
    const double sd = half * std::sqrt(runs) / student_t(runs - 1, tail);
    for (int n = fewest_for_interval; n < most; ++n)
        if (student_t(n - 1, tail) * sd / std::sqrt(n) <= share * std::abs(found.estimate)) return n;
    return most;
}

}  // namespace floes
