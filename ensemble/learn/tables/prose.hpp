#pragma once
// Sentences for a screen.

#include <string>
#include <string_view>

namespace floes {

/// The text with lines of at most `width` characters, broken at spaces; not wider than people like to read. Lines that
/// begin with a space are commands to copy, and stand as they are; what two spaces part from such a command goes to a
/// line of its own where there is no room for it.
std::string wrapped(std::string_view text, int width);

}  // namespace floes
