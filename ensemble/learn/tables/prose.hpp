#pragma once
// Sentences for a screen.

#include <string>
#include <string_view>

namespace floes {

/// The text with lines of at most `width` characters, broken at spaces; not wider than people like to read. Lines that
/// begin with a space stand as they are: they are commands to copy.
std::string wrapped(std::string_view text, int width);

}  // namespace floes
