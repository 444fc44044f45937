#pragma once
// The rules of the house about one file, about the rooms that CMakeLists.txt declares, and about ARCHITECTURE.md.

#include <string>
#include <vector>

#include "house/floors.hpp"
#include "house/includes.hpp"

namespace floes::house {

/// One sentence for each rule that the file breaks:
///   - #include "room/file.hpp" names the file's own room or one of a lower floor;
///   - #include <foreign/header.h> is of a library with a door in the file's room;
///   - no header includes Boost, whose headers are long;
///   - src/ opens no file and prints nothing: no <fstream>, <iostream>, <cstdio>;
///   - at most 300 lines.
std::vector<std::string> broken_rules(const Source& file);

/// One sentence for each room that floes_room(… ROOMS …) declares and no file of it includes, and the other way round.
std::vector<std::string> broken_edges(const std::string& cmake, const std::vector<Source>& sources);

/// The lines of the tables of rooms in ARCHITECTURE.md; a line that begins with `src/` or `ensemble/WING/` says where
/// the rooms below it are.
std::vector<Room> drawn_rooms(const std::string& architecture);

}  // namespace floes::house
