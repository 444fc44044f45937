#include "keys/range.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

namespace floes {

Range Range::at_most(double bound) const {
    Range range = *this;
    range.high = bound;
    return range;
}

Range Range::below(double bound) const {
    Range range = at_most(bound);
    range.high_included = false;
    return range;
}

Range Range::or_infinity() const {
    Range range = *this;
    range.infinity_included = true;
    return range;
}

Range Range::because(std::string_view why) const {
    Range range = *this;
    range.reason = why;
    return range;
}

bool Range::contains(double value) const {
    const bool high_enough = low_included ? value >= low : value > low;
    const bool low_enough = high_included ? value <= high : value < high;
    if (std::isinf(value)) return infinity_included && value > 0;
    return high_enough && low_enough;
}

Range above(double bound) {
    Range range = at_least(bound);
    range.low_included = false;
    return range;
}

Range at_least(double bound) {
    Range range;
    range.low = bound;
    return range;
}

std::string to_text(const Range& range) {
    std::vector<std::string> parts;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (range.low > -infinity)
        parts.push_back(fmt::format("{} {}", range.low_included ? "at least" : "above", range.low));
    if (range.high < infinity)
        parts.push_back(fmt::format("{} {}", range.high_included ? "at most" : "below", range.high));
    const std::string bounds = parts.empty() ? "any number" : fmt::format("{}", fmt::join(parts, " and "));
    return range.infinity_included ? bounds + ", or inf" : bounds;
}

}  // namespace floes
