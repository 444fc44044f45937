#include "core/wording.hpp"

#include <fmt/format.h>

#include <cmath>

namespace floes {

std::string counted(std::int64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string duration_text(double seconds) {
    const auto s = std::llround(seconds);
    if (s < 100) return fmt::format("{} s", s);
    const auto minutes = std::llround(seconds / 60);
    if (minutes < 100) return fmt::format("{} min", minutes);
    const auto hours = std::llround(seconds / 3600);
    if (hours < 48) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
    return fmt::format("{} d {} h", hours / 24, hours % 24);
}

std::string duration_in_figures(double seconds) {
    if (seconds < 1) return fmt::format("{:.3g} ms", 1e3 * seconds);
    if (seconds < 120) return fmt::format("{:.3g} s", seconds);
    if (seconds < 2 * 3600) return fmt::format("{:.3g} min", seconds / 60);
    if (seconds < 100 * 3600) return fmt::format("{:.3g} h", seconds / 3600);
    return fmt::format("{:.3g} d", seconds / 86400);
}

}  // namespace floes
