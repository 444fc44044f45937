#pragma once
// Numbers with a decimal comma, as people write them in many countries.

#include <charconv>
#include <string>
#include <string_view>

namespace floes {

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
