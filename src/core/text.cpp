#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace floes {

namespace {

/// Whether it is a byte of a letter after its first.
bool is_further(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

}  // namespace

bool is_utf8(std::string_view text) {
    constexpr std::uint32_t least[]{0, 0x80, 0x800, 0x10000};  // that needs so many further bytes
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text.front());
        const int more = first < 0x80 ? 0 : first >> 5 == 0x6 ? 1 : first >> 4 == 0xe ? 2 : first >> 3 == 0x1e ? 3 : -1;
        if (more < 0 || text.size() <= static_cast<std::size_t>(more)) return false;
        std::uint32_t code = more == 0 ? first : first & (0x3fu >> more);
        for (const char next : text.substr(1, static_cast<std::size_t>(more))) {
            if (!is_further(next)) return false;
            code = code << 6 | (static_cast<unsigned char>(next) & 0x3f);
        }
        if (code < least[more] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return false;
        text.remove_prefix(static_cast<std::size_t>(more) + 1);
    }
    return true;
}

bool is_utf16(std::string_view text) {
    const std::string_view first = text.substr(0, 2);
    return first == "\xFF\xFE" || first == "\xFE\xFF" || first.find('\0') != std::string_view::npos;
}

bool has_ending(std::string_view file, std::string_view ending) {
    return lower(file).ends_with(ending);
}

std::string in_a_file_name(std::string name) {
    std::ranges::replace_if(
        name, [](unsigned char c) { return c == '/' || c < 32; }, '_');
    constexpr std::size_t longest = 200;  // of the 255 bytes of a file's name, which has endings, too
    return std::string{beginning(name, longest)};
}

std::string in_one_line(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 32 || c == 127; }, ' ');
    return text;
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
}

std::string_view beginning(std::string_view text, std::size_t most) {
    constexpr std::size_t most_further = 3;  // bytes of a letter after its first; more are not UTF-8
    if (text.size() <= most) return text;
    std::size_t end = most;
    while (end > 0 && most - end < most_further && is_further(text[end])) --end;
    return text.substr(0, is_further(text[end]) ? most : end);
}

double to_digits(double value, int digits) {
    const std::string text = fmt::format("{:.{}g}", value, digits);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::string lower(std::string_view text) {
    std::string made(text);
    std::ranges::transform(made, made.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return made;
}

std::string_view trimmed(std::string_view text, std::string_view blanks) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string markup_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '&')
            escaped += "&amp;";
        else if (c == '"')
            escaped += "&quot;";
        else
            escaped += c;
    }
    return escaped;
}

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

std::string shell_word(const std::string& word) {
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                            "0123456789_-+=.,/:@%") == std::string::npos;
    if (plain) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace floes
