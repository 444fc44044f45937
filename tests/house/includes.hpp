#pragma once
// The sources of the house and what they include.

#include <filesystem>
#include <string>
#include <vector>

namespace floes::house {

struct Include {
    int line = 0;
    std::string header;
    bool foreign = false;  ///< in angle brackets
};

struct Source {
    std::string path;  ///< relative to the project: "src/ice/field.cpp"
    std::string text;
};

/// Every #include of the text, in order; those in comments are none.
std::vector<Include> includes_of(const std::string& text);

/// The folder that a file is in: "src/ice/field.cpp" -> "ice", "ensemble/store/hdf5/rows.cpp" -> "hdf5", also
/// "ice/field.hpp" -> "ice"; empty without a folder.
std::string room_of(const std::string& path);

/// The whole text of a file.
std::string text_of(const std::filesystem::path& file);

/// Every .hpp and .cpp in src/ and ensemble/ under `project`, sorted by path.
std::vector<Source> sources_of(const std::filesystem::path& project);

}  // namespace floes::house
