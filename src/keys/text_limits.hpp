#pragma once
// What is refused of a text before it is parsed, because toml++ could not stand it.

#include <cstddef>
#include <string>
#include <string_view>

namespace floes {

/// A text of 100,000 cases with ten keys each, or 500,000 poses, is shorter.
inline constexpr std::size_t longest_text = 64 << 20;  // bytes

/// Throws InputError, beginning with `where`, for a text longer than longest_text, with more values than may be held
/// (toml++ takes some 150 bytes for each), or with a key of more parts than any table has: toml++ makes a table of each
/// part and takes them apart again by recursion.
void refuse_what_cannot_be_held(std::string_view text, const std::string& where);

}  // namespace floes
