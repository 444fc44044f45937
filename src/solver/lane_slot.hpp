#pragma once
// Where a field of one lane lies. A slot is a body's or joint's place: group * width + lane.

#include <cstddef>
#include <cstdint>

namespace floes {

/// Index of `field` (of `fields` a group) of a slot in its array.
inline std::size_t place(std::uint32_t slot, int fields, int field, int width) {
    const auto w = static_cast<std::uint32_t>(width);
    return (slot / w) * static_cast<std::size_t>(fields * width) + static_cast<std::size_t>(field * width) + slot % w;
}

}  // namespace floes
