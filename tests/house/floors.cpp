#include "house/floors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace floes::house {

namespace {

bool lists(const std::string& doors, const std::string& entry) {
    return (", " + doors + ", ").find(", " + entry + ", ") != std::string::npos;
}

}  // namespace

const std::vector<Room>& rooms() {
    static const std::vector<Room> table{
        {0, "core", "Eigen, fmt (all rooms), POSIX, Random123, xxHash", "src"},
        {1, "keys", "toml++", "src"},
        {1, "solver", "Eigen", "src"},
        {1, "structure", "", "src"},
        {1, "laws", "Boost", "src"},
        {1, "outline", "", "src"},
        {2, "scenario", "", "src"},
        {2, "collision", "", "src"},
        {3, "arrangement", "", "src"},
        {3, "water", "", "src"},
        {3, "statistics", "Boost", "src"},
        {3, "theory", "Boost", "src"},
        {3, "world", "Bullet", "src"},
        {4, "ice", "", "src"},
        {5, "quantities", "", "src"},
        {5, "simulation", "", "src"},
        {5, "laboratory", "", "src"},
        {6, "member", "POSIX", "src"},
        {6, "cad", "assimp", "plan"},
        {6, "traced", "nlohmann json", "plan"},
        {7, "campaign", "Boost", "plan"},
        {7, "schedule", "", "plan"},
        {8, "records", "POSIX, zlib", "store"},
        {9, "journal", "Boost, POSIX", "store"},
        {9, "hdf5", "HDF5, POSIX", "store"},
        {10, "campaign_file", "POSIX", "store"},
        {8, "tables", "libxlsxwriter, nlohmann json", "learn"},
        {8, "inference", "Boost, Eigen, NLopt", "learn"},
        {11, "findings", "", "learn"},
        {12, "match", "Boost, Eigen", "learn"},
        {13, "year", "", "learn"},
        {8, "wire", "MPI, POSIX", "run"},
        {8, "attempt", "POSIX", "run"},
        {11, "driver", "POSIX, TBB", "run"},
        {11, "forecast", "", "run"},
        {11, "replay", "POSIX", "show"},
        {12, "view", "", "show"},
        {13, "picture", "cairo, POSIX, zlib", "show"},
        {13, "player", "nlohmann json, zlib", "show"},
        {13, "vtk", "zlib", "show"},
        {13, "page", "", "show"},
        {14, "cli", "CLI11, POSIX, TBB", "cli"},
    };
    return table;
}

int wing_number(std::string_view wing) {
    static constexpr std::array<std::string_view, 7> wings{"src", "plan", "store", "learn", "run", "show", "cli"};
    return static_cast<int>(std::ranges::find(wings, wing) - wings.begin());
}

const Room* find_room(std::string_view name) {
    const auto found = std::ranges::find(rooms(), name, &Room::name);
    return found == rooms().end() ? nullptr : &*found;
}

const std::vector<Library>& libraries() {
    static const std::vector<Library> all{
        {"assimp", std::regex{R"(assimp/.*)"}},
        {"Boost", std::regex{R"(boost/.*)"}},
        {"Bullet", std::regex{R"((bt[A-Z]|Bullet|LinearMath/).*)"}},
        {"cairo", std::regex{R"((cairo/)?cairo.*\.h)"}},
        {"CLI11", std::regex{R"(CLI/.*)"}},
        {"Eigen", std::regex{R"((unsupported/)?Eigen/.*)"}},
        {"fmt", std::regex{R"(fmt/.*)"}},
        {"HDF5", std::regex{R"(hdf5(_hl)?\.h|hdf5/serial/.*|H5.*)"}},
        {"libxlsxwriter", std::regex{R"(xlsxwriter(/.*)?\.h)"}},
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
