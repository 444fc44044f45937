#include "tables/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace floes {

std::string significant(double value, int digits) {
    const std::string text = fmt::format("{:.{}g}", value, digits);
    return text.find("e+") == std::string::npos ? text : fmt::format("{:.0f}", value);
}

Units::Units(double largest) {
    const double load = std::abs(largest);
    if (load >= 1e7) {
        prefix_ = "M";
        factor_ = 1e-6;
    } else if (load >= 1e4) {
        prefix_ = "k";
        factor_ = 1e-3;
    }
}

Units::Shown Units::of(std::string_view si) const {
    using Written = std::pair<std::string_view, std::string_view>;
    constexpr std::array<Written, 6> prefixed{
        {{"N", "N"}, {"N m", "N m"}, {"N m-1", "N/m"}, {"N s-1", "N/s"}, {"J", "J"}, {"Pa", "Pa"}}};
    constexpr std::array<Written, 4> written{{{"1", ""}, {"m2", "m²"}, {"m s-1", "m/s"}, {"h-1", "1/h"}}};
    if (si == "share") return {"%", 100};
    if (const auto* found = std::ranges::find(prefixed, si, &Written::first); found != prefixed.end())
        return {std::string{prefix_} + std::string{found->second}, factor_};
    const auto* found = std::ranges::find(written, si, &Written::first);
    return {std::string{found == written.end() ? si : found->second}, 1};
}

std::string Units::number(double value, std::string_view si, int digits) const {
    return std::isfinite(value) ? significant(of(si).factor * value, digits) : "–";
}

std::string Units::text(double value, std::string_view si, int digits) const {
    const std::string unit = of(si).name;
    return number(value, si, digits) + (unit.empty() || !std::isfinite(value) ? "" : " " + unit);
}

std::string Units::heading(std::string_view words, std::string_view si) const {
    const std::string unit = of(si).name;
    return unit.empty() ? std::string{words} : fmt::format("{}, {}", words, unit);
}

}  // namespace floes
