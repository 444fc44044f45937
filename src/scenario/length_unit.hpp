#pragma once
// Units of length in files that do not say theirs.

#include <array>
#include <cstddef>
#include <string_view>

namespace floes {

enum class LengthUnit { m, mm, cm, inch, foot };

inline constexpr std::array<std::string_view, 5> length_unit_words{"m", "mm", "cm", "in", "ft"};

constexpr double metres(LengthUnit unit) {
    constexpr std::array lengths{1.0, 1e-3, 1e-2, 0.0254, 0.3048};
    return lengths.at(static_cast<std::size_t>(unit));
}

}  // namespace floes
