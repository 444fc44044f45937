#include "house/floors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <string_view>

namespace floes::house {

namespace {

constexpr int most_lines = 300;

struct Door {
    std::string_view library;
    std::regex header;
    std::string_view room;
};

const std::array<Door, 5>& doors() {
    static const std::array<Door, 5> all{{
        {"Bullet", std::regex{R"((bt[A-Z]|Bullet|LinearMath/).*)"}, "world"},
        {"toml++", std::regex{R"(toml(\+\+|\.hpp).*)"}, "keys"},
        {"MPI", std::regex{R"((mpi|openmpi/).*)"}, "wire"},
        {"HDF5", std::regex{R"((hdf5(_hl)?\.h|hdf5/serial/.*|H5.*))"}, "hdf5"},
        {"GSL", std::regex{R"(gsl/.*)"}, "inference"},
    }};
    return all;
}

void check_own(const std::string& path, int line, const std::string& header, std::vector<std::string>& broken) {
    const std::string other = header.substr(0, header.find('/'));
    const auto floor = floors().find(other);
    if (floor == floors().end() || other == header) {
        broken.push_back(
            fmt::format(R"({}:{} includes "{}", which is not "room/file.hpp" of a known room)", path, line, header));
        return;
    }
    const std::string room = room_of(path);
    const int own_floor = floors().contains(room) ? floors().at(room) : -1;
    if (other != room && floor->second >= own_floor) {
        broken.push_back(
            fmt::format(R"({}:{} includes "{}": {} is on floor {}, {} on floor {}; only lower floors may be used)",
                        path, line, header, room, own_floor, other, floor->second));
    }
}

void check_foreign(const std::string& path, int line, const std::string& header, std::vector<std::string>& broken) {
    for (const Door& door : doors()) {
        if (std::regex_match(header, door.header) && room_of(path) != door.room) {
            broken.push_back(fmt::format("{}:{} includes <{}>; {} comes in by the room {} only", path, line, header,
                                         door.library, door.room));
        }
    }
    constexpr std::array<std::string_view, 6> files_and_output{"fstream", "iostream", "cstdio",
                                                               "stdio.h", "print",    "syncstream"};
    if (path.starts_with("src/") && std::ranges::find(files_and_output, header) != files_and_output.end()) {
        broken.push_back(fmt::format("{}:{} includes <{}>; src/ opens no file and prints nothing", path, line, header));
    }
}

}  // namespace

const std::map<std::string, int>& floors() {
    static const std::map<std::string, int> table{
        {"core", 0},      {"keys", 1},       {"solver", 1},         {"scenario", 2},   {"arrangement", 3},
        {"structure", 1}, {"water", 3},      {"theory", 3},         {"statistics", 3}, {"world", 3},
        {"ice", 4},       {"simulation", 5}, {"laboratory", 5},     {"member", 6},     {"campaign", 7},
        {"schedule", 7},  {"wire", 8},       {"records", 8},        {"inference", 8},  {"attempt", 8},
        {"journal", 9},   {"hdf5", 9},       {"campaign_file", 10}, {"driver", 11},    {"forecast", 11},
        {"findings", 11}, {"page", 12},      {"cli", 13},
    };
    return table;
}

std::string room_of(const std::string& path) {
    static const std::regex shape{"(?:src|ensemble)/([^/]+)/.+"};
    std::smatch match;
    return std::regex_match(path, match, shape) ? match[1].str() : std::string{};
}

std::vector<std::string> broken_rules(const std::string& path, const std::string& text) {
    static const std::regex include{R"(\s*#\s*include\s*([<"])([^>"]+)[>"].*)"};
    std::vector<std::string> broken;
    std::istringstream lines{text};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::smatch match;
        if (!std::regex_match(line, match, include)) continue;
        const std::string header = match[2].str();
        check_foreign(path, number, header, broken);
        if (match[1].str() == "\"") check_own(path, number, header, broken);
    }
    if (number > most_lines) {
        broken.push_back(fmt::format("{} has {} lines, more than {}; split it", path, number, most_lines));
    }
    return broken;
}

std::vector<std::filesystem::path> source_files(const std::filesystem::path& project) {
    std::vector<std::filesystem::path> files;
    for (const char* top : {"src", "ensemble"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(project / top)) {
            const std::string kind = entry.path().extension().string();
            if (kind == ".hpp" || kind == ".cpp") files.push_back(std::filesystem::relative(entry.path(), project));
        }
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace floes::house
