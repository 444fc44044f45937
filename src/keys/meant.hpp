#pragma once
// What somebody who mistyped a word or a number probably meant.

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace floes {

/// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other (optimal string
/// alignment distance). Only the first 200 characters of a word are compared.
std::size_t edit_distance(std::string_view one, std::string_view other);

/// "0,033" -> "0.033"; empty for what is no such number.
inline std::string with_decimal_point(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return {};
    std::string pointed(text);
    pointed[comma] = '.';
    double number = 0;
    const char* const end = pointed.data() + pointed.size();
    const auto [stop, fault] = std::from_chars(pointed.data(), end, number);
    return fault == std::errc{} && stop == end ? pointed : std::string();
}

}  // namespace floes
