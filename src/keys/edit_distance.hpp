#pragma once
// Distance of a mistyped word from a known one.

#include <cstddef>
#include <string_view>

namespace floes {

/// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other (optimal string
/// alignment distance). Of a long word only the beginning counts.
std::size_t edit_distance(std::string_view one, std::string_view other);

}  // namespace floes
