#include "house/cycles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <map>

namespace floes::house {

namespace {

using Units = std::map<std::string, std::set<std::string>>;

std::string unit_of(std::string path) {
    for (const char* top : {"src/", "ensemble/"})
        if (path.starts_with(top)) path.erase(0, std::string(top).size());
    return path.substr(0, path.rfind('.'));
}

Units units_of(const std::vector<Source>& sources) {
    Units units;
    for (const Source& file : sources) {
        const std::string unit = unit_of(file.path);
        for (const Include& include : includes_of(file.text)) {
            const std::string other = unit_of(include.header);
            if (!include.foreign && other != unit) units[unit].insert(other);
        }
    }
    return units;
}

/// The shortest way from `start` back to it; empty when there is none.
std::vector<std::string> cycle_through(const std::string& start, const Units& units) {
    std::map<std::string, std::string> from;
    std::deque<std::string> next{start};
    while (!next.empty()) {
        const std::string unit = next.front();
        next.pop_front();
        const auto includes = units.find(unit);
        if (includes == units.end()) continue;
        for (const std::string& other : includes->second) {
            if (!from.emplace(other, unit).second) continue;
            if (other != start) {
                next.push_back(other);
                continue;
            }
            std::vector<std::string> cycle{unit};
            while (cycle.back() != start) cycle.push_back(from.at(cycle.back()));
            std::ranges::reverse(cycle);
            return cycle;
        }
    }
    return {};
}

}  // namespace

std::vector<std::string> cycles_of(const std::vector<Source>& sources) {
    const Units units = units_of(sources);
    std::set<std::vector<std::string>> cycles;
    for (const auto& [unit, includes] : units) {
        std::vector<std::string> cycle = cycle_through(unit, units);
        std::ranges::rotate(cycle, std::ranges::min_element(cycle));  // the same cycle from whichever unit
        if (!cycle.empty()) cycles.insert(cycle);
    }
    std::vector<std::string> sentences;
    for (const std::vector<std::string>& cycle : cycles)
        sentences.push_back(
            fmt::format("these files include each other in a ring: {} -> {}", fmt::join(cycle, " -> "), cycle.front()));
    return sentences;
}

}  // namespace floes::house
