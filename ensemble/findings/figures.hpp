#pragma once
// How figures are written in tables. For this room only.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "inference/bootstrap.hpp"

namespace floes {

/// Decimals that leave about four digits of a quantity as large as `largest`.
inline int decimals_for(double largest) {
    return largest >= 1000 ? 0 : largest >= 100 ? 1 : largest >= 1 ? 2 : 4;
}

/// "–" where undefined.
inline std::string fixed(double value, int decimals) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "–";
}

/// "[1.2, 3.4]"; empty where undefined.
inline std::string bracket(const Limits& limits, int decimals, double factor = 1) {
    if (!std::isfinite(limits.low) && !std::isfinite(limits.high)) return "";
    return fmt::format("[{}, {}]", fixed(limits.low * factor, decimals), fixed(limits.high * factor, decimals));
}

/// All digits, for CSV; empty where undefined.
inline std::string csv_number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : std::string{};
}

/// RFC 4180: in quotes where a comma, a quote or a line end would be misread.
inline std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result{"\""};
    for (const char letter : text) result += letter == '"' ? std::string{"\"\""} : std::string{letter};
    return result + "\"";
}

/// "0.034", "<0.001"; "–" where undefined.
inline std::string p_text(double p) {
    return !std::isfinite(p) ? "–" : p < 0.001 ? "<0.001" : fmt::format("{:.3f}", p);
}

}  // namespace floes
