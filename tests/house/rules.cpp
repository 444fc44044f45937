#include "house/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

namespace floes::house {

namespace {

constexpr std::ptrdiff_t most_lines = 300;

void check_own(const std::string& path, const Include& include, std::vector<std::string>& broken) {
    const Room* other = find_room(room_of(include.header));
    if (other == nullptr) {
        broken.push_back(fmt::format(R"({}:{} includes "{}", which is not "room/file.hpp" of a known room)", path,
                                     include.line, include.header));
        return;
    }
    const Room* room = find_room(room_of(path));
    const int own_floor = room == nullptr ? -1 : room->floor;
    if (other != room && other->floor >= own_floor) {
        broken.push_back(
            fmt::format(R"({}:{} includes "{}": {} is on floor {}, {} on floor {}; only lower floors may be used)",
                        path, include.line, include.header, room_of(path), own_floor, other->name, other->floor));
    }
    if (room != nullptr && wing_number(other->wing) > wing_number(room->wing)) {
        broken.push_back(
            fmt::format(R"({}:{} includes "{}": {} is in wing {}, {} in wing {}; only lower wings may be used)", path,
                        include.line, include.header, room->name, room->wing, other->name, other->wing));
    }
}

/// Names of the standard library have no point and no slash.
bool is_standard(const std::string& header) {
    return header.find_first_of("./") == std::string::npos;
}

void check_foreign(const std::string& path, const Include& include, std::vector<std::string>& broken) {
    const std::string where = fmt::format("{}:{} includes <{}>; ", path, include.line, include.header);
    constexpr std::array<std::string_view, 5> files_and_output{"fstream", "iostream", "cstdio", "print", "syncstream"};
    if (path.starts_with("src/") && std::ranges::find(files_and_output, include.header) != files_and_output.end())
        broken.push_back(where + "src/ opens no file and prints nothing");
    if (is_standard(include.header)) return;
    if (path.ends_with(".hpp") && include.header.starts_with("boost/"))
        broken.push_back(where + "it took half of the build when it was in a header; include it in a .cpp");
    const auto library = std::ranges::find_if(
        libraries(), [&](const Library& one) { return std::regex_match(include.header, one.header); });
    if (library == libraries().end()) {
        broken.push_back(where + "no library of tests/house/floors.cpp has such a header");
        return;
    }
    const Room* room = find_room(room_of(path));
    if (room == nullptr || !has_door(*room, *library))
        broken.push_back(where + fmt::format("{} comes in by {} only", library->name, rooms_with_door(*library)));
}

/// What each floes_room() of the text declares.
std::map<std::string, std::set<std::string>> declared_rooms(const std::string& cmake) {
    static const std::regex command{R"(\n\s*floes_room\((?:src|ensemble)/(?:[a-z]+/)?([a-z_0-9]+)([^)]*)\))"};
    static const std::regex word{R"(\S+)"};
    std::map<std::string, std::set<std::string>> declared;
    const std::string text = "\n" + cmake;
    for (auto room = std::sregex_iterator(text.begin(), text.end(), command); room != std::sregex_iterator(); ++room) {
        std::set<std::string>& own = declared[(*room)[1].str()];
        const std::string arguments = (*room)[2].str();
        bool in_rooms = false;
        for (auto at = std::sregex_iterator(arguments.begin(), arguments.end(), word); at != std::sregex_iterator();
             ++at) {
            const std::string argument = at->str();
            const bool keyword = argument == "ROOMS" || argument == "LIBRARIES" || argument == "PRIVATE";
            if (keyword) in_rooms = argument == "ROOMS";
            if (!keyword && in_rooms) own.insert(argument);
        }
    }
    return declared;
}

/// For each room the other rooms that it includes, with a place for each.
std::map<std::string, std::map<std::string, std::string>> included_rooms(const std::vector<Source>& sources) {
    std::map<std::string, std::map<std::string, std::string>> included;
    for (const Source& file : sources) {
        const std::string room = room_of(file.path);
        included[room];
        for (const Include& include : includes_of(file.text)) {
            const std::string other = room_of(include.header);
            if (!include.foreign && !other.empty() && other != room)
                included[room].emplace(other, fmt::format("{}:{}", file.path, include.line));
        }
    }
    return included;
}

}  // namespace

std::vector<std::string> broken_rules(const Source& file) {
    std::vector<std::string> broken;
    for (const Include& include : includes_of(file.text)) {
        if (include.foreign) {
            check_foreign(file.path, include, broken);
        } else {
            check_own(file.path, include, broken);
        }
    }
    const auto lines = std::ranges::count(file.text, '\n');
    if (lines > most_lines)
        broken.push_back(fmt::format("{} has {} lines, more than {}; split it", file.path, lines, most_lines));
    return broken;
}

std::vector<std::string> broken_edges(const std::string& cmake, const std::vector<Source>& sources) {
    std::vector<std::string> broken;
    const auto declared = declared_rooms(cmake);
    for (const auto& [room, included] : included_rooms(sources)) {
        const auto own = declared.find(room);
        if (own == declared.end()) {
            broken.push_back(fmt::format("CMakeLists.txt has no floes_room() for {}", room));
            continue;
        }
        for (const auto& [other, where] : included) {
            if (!own->second.contains(other))
                broken.push_back(
                    fmt::format("{} includes {} at {}, and CMakeLists.txt does not declare it", room, other, where));
        }
        for (const std::string& other : own->second) {
            if (!included.contains(other))
                broken.push_back(fmt::format("CMakeLists.txt declares that {} uses {}, and no file of {} includes it",
                                             room, other, room));
        }
    }
    return broken;
}

std::vector<Room> drawn_rooms(const std::string& architecture) {
    static const std::regex head{R"(`(?:ensemble/)?([a-z]+)/`.*)"};
    static const std::regex row{R"(\| (\d+) \| `([a-z_0-9]+)` \|[^|]*\| ([^|]*?) ?\|)"};
    std::vector<Room> drawn;
    std::istringstream lines{architecture};
    std::string wing;
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_match(line, match, head)) wing = match[1].str();
        if (std::regex_match(line, match, row))
            drawn.push_back({std::stoi(match[1].str()), match[2].str(), match[3].str(), wing});
    }
    return drawn;
}

}  // namespace floes::house
