#pragma once
// What every text of floes is.

#include <string_view>

namespace floes {

/// Whether a text is UTF-8: without overlong forms, surrogates, and letters cut off.
bool is_utf8(std::string_view text);

}  // namespace floes
