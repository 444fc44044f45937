#pragma once
// Number formats of the text tables.

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace floes {

/// Decimals that give a quantity as large as `largest` about four digits.
inline int decimals_for(double largest) {
    return largest >= 1000 ? 0 : largest >= 100 ? 1 : largest >= 1 ? 2 : 4;
}

/// About three digits.
inline int few_decimals(double largest) {
    return largest >= 100 ? 0 : largest >= 1 ? 1 : largest >= 0.1 ? 2 : largest > 0 ? 3 : 1;
}

/// "–" where undefined.
inline std::string fixed(double value, int decimals) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "–";
}

/// So many significant digits, and all digits before the point: "1230", not "1.23e+03".
inline std::string significant(double value, int digits) {
    const int before = value == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return before > digits ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

/// "[1.2, 3.4]"; empty where undefined.
inline std::string bracket(double low, double high, int decimals) {
    if (!std::isfinite(low) && !std::isfinite(high)) return "";
    return fmt::format("[{}, {}]", fixed(low, decimals), fixed(high, decimals));
}

/// "0.034", "<0.001"; "–" where undefined.
inline std::string p_text(double p) {
    return !std::isfinite(p) ? "–" : p < 0.001 ? "<0.001" : fmt::format("{:.3f}", p);
}

/// A unit in which loads are shown, and N to it.
struct LoadUnit {
    const char* name;
    double factor;
};

/// N, kN or MN, so that a load of `largest` N is below 10,000 of it where it can be.
inline LoadUnit load_unit(double largest) {
    return largest < 1e4 ? LoadUnit{"N", 1} : largest < 1e7 ? LoadUnit{"kN", 1e-3} : LoadUnit{"MN", 1e-6};
}

}  // namespace floes
