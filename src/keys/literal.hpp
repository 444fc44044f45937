#pragma once
// Numbers and words as TOML writes them.

#include <string>
#include <string_view>

namespace floes {

/// The shortest text that reads back to the same double, always with a point or an exponent: 75 -> "75.0".
std::string number_literal(double number);

/// `in_si / unit` with the fewest digits for which the product with `unit` is `in_si` again, bit for bit. If there is
/// no such double (which happens for values that did not come from text), the nearest one.
std::string number_literal(double in_si, double unit);

/// A basic string in quotes, escaped for TOML.
std::string text_literal(std::string_view text);

}  // namespace floes
