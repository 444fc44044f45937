#include "house/floors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace floes::house {

namespace {

bool lists(const std::string& doors, const std::string& entry) {
    return (", " + doors + ", ").find(", " + entry + ", ") != std::string::npos;
}

}  // namespace

const std::vector<Room>& rooms() {
    static const std::vector<Room> table{
        {0, "core", "Eigen, fmt (all rooms), POSIX, Random123, xxHash"},
        {1, "keys", "toml++"},
        {1, "solver", "Eigen"},
        {1, "structure", ""},
        {2, "scenario", ""},
        {3, "arrangement", ""},
        {3, "water", ""},
        {3, "statistics", "Boost"},
        {3, "theory", "Boost"},
        {3, "world", "Bullet"},
        {4, "ice", ""},
        {5, "quantities", ""},
        {5, "simulation", ""},
        {5, "laboratory", ""},
        {6, "member", "POSIX"},
        {7, "campaign", "Boost"},
        {7, "schedule", ""},
        {8, "wire", "MPI, POSIX"},
        {8, "tables", "nlohmann json"},
        {8, "records", "POSIX, zlib"},
        {8, "inference", "Boost, Eigen, NLopt"},
        {8, "attempt", "POSIX"},
        {9, "journal", "Boost, POSIX"},
        {9, "hdf5", "HDF5, POSIX"},
        {10, "campaign_file", "POSIX"},
        {11, "driver", "POSIX, TBB"},
        {11, "forecast", ""},
        {11, "findings", ""},
        {11, "replay", "POSIX"},
        {12, "view", ""},
        {12, "match", "Boost, Eigen"},
        {13, "page", ""},
        {13, "picture", "cairo, POSIX, zlib"},
        {13, "player", "nlohmann json, zlib"},
        {13, "vtk", "zlib"},
        {14, "cli", "CLI11, nlohmann json, POSIX, TBB"},
    };
    return table;
}

const Room* find_room(std::string_view name) {
    const auto found = std::ranges::find(rooms(), name, &Room::name);
    return found == rooms().end() ? nullptr : &*found;
}

const std::vector<Library>& libraries() {
    static const std::vector<Library> all{
        {"Boost", std::regex{R"(boost/.*)"}},
        {"Bullet", std::regex{R"((bt[A-Z]|Bullet|LinearMath/).*)"}},
        {"cairo", std::regex{R"((cairo/)?cairo.*\.h)"}},
        {"CLI11", std::regex{R"(CLI/.*)"}},
        {"Eigen", std::regex{R"((unsupported/)?Eigen/.*)"}},
        {"fmt", std::regex{R"(fmt/.*)"}},
        {"HDF5", std::regex{R"(hdf5(_hl)?\.h|hdf5/serial/.*|H5.*)"}},
        {"MPI", std::regex{R"((mpi|openmpi/).*)"}},
        {"NLopt", std::regex{R"(nlopt\.h(pp)?)"}},
        {"nlohmann json", std::regex{R"(nlohmann/.*)"}},
        {"POSIX", std::regex{R"((sys/.*|gnu/libc-version|fcntl|poll|sched|signal|spawn|time|unistd)(\.h))"}},
        {"Random123", std::regex{R"(Random123/.*)"}},
        {"TBB", std::regex{R"((oneapi/)?tbb/.*)"}},
        {"toml++", std::regex{R"(toml(\+\+|\.hpp).*)"}},
        {"xxHash", std::regex{R"(xxh(ash|3)\.h)"}},
        {"zlib", std::regex{R"(z(lib|conf)\.h)"}},
    };
    return all;
}

bool has_door(const Room& room, const Library& library) {
    const auto opens_all = [&](const Room& one) { return lists(one.doors, library.name + " (all rooms)"); };
    return lists(room.doors, library.name) || std::ranges::any_of(rooms(), opens_all);
}

std::string rooms_with_door(const Library& library) {
    std::vector<std::string> names;
    for (const Room& room : rooms())
        if (has_door(room, library)) names.push_back(room.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace floes::house
