#pragma once
// The rooms with their floors, and the foreign libraries with their doors. ARCHITECTURE.md draws the same table.

#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace floes::house {

/// A line of the table in ARCHITECTURE.md.
struct Room {
    int floor = 0;
    std::string name;
    std::string
        doors;  ///< foreign libraries that may be included here: "Eigen, NLopt"; those "(all rooms)" in all of them
    std::string wing;  ///< "src", or the folder of ensemble/ that the room is in
    friend bool operator==(const Room&, const Room&) = default;
};

/// All rooms, in the order of ARCHITECTURE.md. A room includes rooms of lower floors and itself.
const std::vector<Room>& rooms();

/// Wings from the lowest: a room includes rooms of its own wing and of lower ones.
int wing_number(std::string_view wing);

/// The room of that name; nothing when there is none.
const Room* find_room(std::string_view name);

struct Library {
    std::string name;
    std::regex header;  ///< what stands between the angle brackets
};

const std::vector<Library>& libraries();

/// May the room include headers of the library?
bool has_door(const Room& room, const Library& library);

/// "statistics, theory": where the library comes in.
std::string rooms_with_door(const Library& library);

}  // namespace floes::house
