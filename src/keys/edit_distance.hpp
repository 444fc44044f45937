#pragma once
// Distance of a mistyped word from a known one.

#include <cstddef>
#include <string_view>

namespace floes {

/// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other (optimal string
/// alignment distance). Only the first 200 characters of a word are compared.
std::size_t edit_distance(std::string_view one, std::string_view other);

}  // namespace floes
