#pragma once
// Allowed ranges of numbers.

#include <limits>
#include <string>
#include <string_view>

namespace floes {

/// Allowed range of a number, in the unit of the key. NaN is never allowed.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_included = true;
    bool high_included = true;
    bool infinity_included = false;
    std::string_view reason;  ///< why, if it is not obvious; part of the message

    Range at_most(double bound) const;
    Range below(double bound) const;
    Range or_infinity() const;
    Range because(std::string_view why) const;
    bool contains(double value) const;
};
Range above(double bound);
Range at_least(double bound);

/// "above 0 and below 1"; "any number" without bounds.
std::string to_text(const Range& range);

}  // namespace floes
