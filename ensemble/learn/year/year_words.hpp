#pragma once
// Words of the loads of a year. For this room only.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/units.hpp"
#include "tables/number_text.hpp"

namespace floes {

/// "10^-2", "0.005".
inline std::string per_year_text(double per_year) {
    const double exponent = std::log10(per_year);
    return std::abs(exponent - std::round(exponent)) < 1e-9 ? fmt::format("10^{:.0f}", exponent)
                                                            : fmt::format("{:g}", per_year);
}

/// Of whole percent.
inline std::string percent_of(double share) {
    if (!std::isfinite(share)) return "–";
    return share > 0 && share < 0.005 ? "<1 %" : fixed(share / unit::percent, 0) + " %";
}

}  // namespace floes
