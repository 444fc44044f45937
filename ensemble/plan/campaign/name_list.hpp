#pragma once
// Names of cases in a message. A design may have thousands.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <string>
#include <vector>

namespace floes {

/// "E30, E60, E200"; of many the first ones, and how many there are: "p000, p001, p002 … (320 in all)".
inline std::string name_list(const std::vector<std::string>& names) {
    constexpr std::size_t most = 12;
    constexpr std::size_t first = 3;
    if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} … ({} in all)", fmt::join(std::span(names).first(first), ", "), names.size());
}

}  // namespace floes
