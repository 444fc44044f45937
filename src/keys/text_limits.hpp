#pragma once
// Limits of a text, checked before it is parsed: beyond them toml++ would run out of memory or stack.

#include <cstddef>
#include <string>
#include <string_view>

namespace floes {

/// Enough for 100,000 cases of ten keys each, or for 500,000 poses.
inline constexpr std::size_t longest_text = 64 << 20;  // bytes

/// Throws InputError, beginning with `where`, for a text longer than longest_text, for more values than fit into memory
/// (toml++ needs about 150 bytes for each), and for a key of too many parts: toml++ makes a table of each part and
/// destroys them by recursion.
void refuse_what_cannot_be_held(std::string_view text, const std::string& where);

}  // namespace floes
