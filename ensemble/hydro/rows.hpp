#pragma once
// Lines of numbers as Fortran writes them, and what WAMIT has in common in its files.

#include <optional>
#include <string_view>
#include <vector>

namespace floes {

std::vector<std::string_view> lines_of(std::string_view text);

/// The numbers of a line; nothing if a word is none. Fortran writes 1.0D+00 too.
std::optional<std::vector<double>> numbers_of(std::string_view line);

/// How many of two motions (0 to 5) are turns: the powers of the length that WAMIT's units have more.
int turns_of(int i, int j);

}  // namespace floes
