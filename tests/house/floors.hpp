#pragma once
// The rules of the house about includes, as a function of a file's path and text.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace floes::house {

/// Floor of every room; a room includes rooms of lower floors and itself. ARCHITECTURE.md draws the same table.
const std::map<std::string, int>& floors();

/// "src/ice/field.cpp" -> "ice"; empty when the path is not inside a room.
std::string room_of(const std::string& path);

/// One sentence for each rule that the file breaks. `path` is relative to the project ("src/ice/field.cpp").
///   - #include "room/file.hpp" names the file's own room or one of a lower floor;
///   - each foreign library comes in by its one door: Bullet world, toml++ keys, MPI wire, HDF5 store;
///   - src/ opens no file and prints nothing: no <fstream>, <iostream>, <cstdio>;
///   - at most 300 lines.
std::vector<std::string> broken_rules(const std::string& path, const std::string& text);

/// Every .hpp and .cpp in src/ and ensemble/ under `project`, relative to it, sorted.
std::vector<std::filesystem::path> source_files(const std::filesystem::path& project);

}  // namespace floes::house
