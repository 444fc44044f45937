#pragma once
// What every text of floes is.

#include <cstddef>
#include <string_view>

namespace floes {

/// Whether a text is UTF-8: without overlong forms, surrogates, and letters cut off.
bool is_utf8(std::string_view text);

/// The first bytes of a text, `most` or so many fewer that no letter is cut apart.
std::string_view beginning(std::string_view text, std::size_t most);

}  // namespace floes
