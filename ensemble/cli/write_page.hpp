#pragma once
// Puts a page where a browser may be reading it.

#include <filesystem>
#include <string>

namespace floes {

/// Writes aside and renames, so that a reader finds the old page or the new one, whole. Throws RunError when the file
/// system refuses.
void write_page(const std::filesystem::path& path, const std::string& page);

}  // namespace floes
