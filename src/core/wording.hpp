#pragma once
// Counts and durations in words, the same wherever the program says them.

#include <cstdint>
#include <string>
#include <string_view>

namespace floes {

/// "1 member", "3 members": nouns that take an s.
std::string counted(std::int64_t count, std::string_view noun);

/// A duration in s to the whole unit that a clock shows: "42 s", "15 min", "3 h 20 min", "2 d 5 h".
std::string duration_text(double seconds);

/// A duration in s to three figures of one unit: "2.5 ms", "31.3 s", "67.9 min", "17.2 h", "183 d".
std::string duration_in_figures(double seconds);

}  // namespace floes
