#include "keys/literal.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace floes {
namespace {

/// TOML tells floats from integers by the decimal point, so a number is always written with one.
std::string with_point(std::string text) {
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

}  // namespace

std::string number_literal(double number) {
    return with_point(fmt::format("{}", number));
}

std::string number_literal(double in_si, double unit) {
    if (unit == 1) return number_literal(in_si);
    const double number = in_si / unit;
    if (!std::isfinite(number)) return number_literal(number);
    // A number that gives in_si again differs from `number` by less than 5e-16 of it. So where fewer than 15 digits are
    // enough, 15 digits are the same ones followed by zeros.
    for (int digits = std::numeric_limits<double>::digits10; digits <= std::numeric_limits<double>::max_digits10;
         ++digits) {
        const std::string text = fmt::format("{:.{}g}", number, digits);
        double rounded = 0;
        std::from_chars(text.data(), text.data() + text.size(), rounded);
        if (rounded * unit == in_si) return number_literal(rounded);
    }
    for (const double neighbour : {std::nextafter(number, -INFINITY), std::nextafter(number, INFINITY)}) {
        if (neighbour * unit == in_si) return number_literal(neighbour);
    }
    return number_literal(number);
}

std::string text_literal(std::string_view text) {
    std::string literal = "\"";
    for (const char character : text) {
        const auto code = static_cast<unsigned char>(character);
        if (character == '"' || character == '\\') {
            literal += '\\';
            literal += character;
        } else if (code < 0x20 || code == 0x7f) {
            literal += fmt::format("\\u{:04x}", code);
        } else {
            literal += character;
        }
    }
    return literal + "\"";
}

}  // namespace floes
