#pragma once
// Texts with other letters.

#include <cctype>
#include <string>
#include <string_view>

namespace floes {

/// Every `from` as `to`.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

inline std::string in_capitals(std::string text) {
    for (char& one : text) one = static_cast<char>(std::toupper(static_cast<unsigned char>(one)));
    return text;
}

}  // namespace floes
