#pragma once
// The files of page_assets/ and three.js, as they were when the program was built. For this module only.

#include <optional>
#include <string_view>

namespace floes {

/// The content of the file with this name; nothing if there is none.
std::optional<std::string_view> asset(std::string_view name);

}  // namespace floes
