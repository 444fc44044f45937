#pragma once
// Writes a page that a browser may be reading at the same time.

#include <filesystem>
#include <string>

namespace floes {

/// Writes a temporary file and renames it, so that a reader finds either the old page or the new one. Throws RunError
/// if the file cannot be written.
void write_page(const std::filesystem::path& path, const std::string& page);

}  // namespace floes
