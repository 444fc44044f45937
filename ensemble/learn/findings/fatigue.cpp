#include "findings/fatigue.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/units.hpp"
#include "statistics/averaged_load.hpp"

namespace floes {
namespace {

constexpr std::size_t edge_count = 12;

/// Of one member.
struct Counted {
    double time;  ///< s
    std::vector<double> loads;
    std::vector<LoadCycle> cycles;
};

Counted counted_of(const LoadWindow& window) {
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::round(window.averaging / window.step)));
    Counted made{static_cast<double>(window.loads.size()) * window.step, running_means(window.loads, steps), {}};
    made.cycles = rainflow(made.loads);
    return made;
}

/// 1, 2, 2.5 or 5 times a power of ten, not below `least`.
double round_width(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 2.5, 5.0})
        if (digit * power >= least) return digit * power;
    return 10 * power;
}

std::vector<double> edges_of(const std::map<std::size_t, std::vector<Counted>>& cases) {
    double largest = 0;
    for (const auto& [index, members] : cases)
        for (const Counted& one : members) {
            for (const double load : one.loads) largest = std::max(largest, load);
            for (const LoadCycle& cycle : one.cycles) largest = std::max(largest, cycle.range);
        }
    std::vector<double> edges;
    if (largest <= 0) return edges;
    const double width = round_width(largest / edge_count);
    for (std::size_t k = 0; k < edge_count; ++k) edges.push_back(width * static_cast<double>(k));
    return edges;
}

Interval equivalent_of(const std::vector<Counted>& members, double slope) {
    std::vector<double> damage;
    for (const Counted& one : members) damage.push_back(damage_sum(one.cycles, slope) / one.time);
    Interval found = mean_interval(damage);
    for (double* value : {&found.estimate, &found.low, &found.high})
        *value = std::pow(std::max(*value, 0.0), 1 / slope);
    return found;
}

CaseFatigue fatigue_of(std::size_t index, const std::vector<Counted>& members, const std::vector<double>& edges) {
    CaseFatigue made{.case_index = index,
                     .runs = static_cast<int>(members.size()),
                     .equivalent = {},
                     .cycles_above = std::vector<double>(edges.size(), 0),
                     .time_above = std::vector<double>(edges.size(), 0)};
    double hours = 0;
    for (const Counted& one : members) hours += one.time / unit::hour;
    const double runs = static_cast<double>(members.size());
    for (const Counted& one : members) {
        for (const LoadCycle& cycle : one.cycles) {
            made.cycles += cycle.count / hours;
            for (std::size_t k = 0; k < edges.size(); ++k)
                if (cycle.range >= edges[k]) made.cycles_above[k] += cycle.count / hours;
        }
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const auto above = std::ranges::count_if(one.loads, [&](double load) { return load > edges[k]; });
            made.time_above[k] += static_cast<double>(above) / static_cast<double>(one.loads.size()) / runs;
        }
    }
    for (const double slope : fatigue_slopes) made.equivalent.push_back(equivalent_of(members, slope));
    return made;
}

}  // namespace

Fatigue find_fatigue(std::span<const LoadWindow> windows) {
    std::map<std::size_t, std::vector<Counted>> cases;
    std::map<std::size_t, double> averaging;
    for (const LoadWindow& window : windows) {
        Counted one = counted_of(window);
        if (one.loads.empty()) continue;
        cases[window.case_index].push_back(std::move(one));
        averaging[window.case_index] = std::max(window.averaging, window.step);
    }
    Fatigue made{edges_of(cases), {}};
    for (const auto& [index, members] : cases) {
        made.cases.push_back(fatigue_of(index, members, made.edges));
        made.cases.back().averaging = averaging[index];
    }
    return made;
}

}  // namespace floes
