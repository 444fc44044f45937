#include "replay/asked.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "member/design_of.hpp"
#include "shapes/moorings.hpp"

namespace floes {

std::optional<AskedOf> asked_of(std::string_view name) {
    const auto* found = std::ranges::find(asked_names, name);
    if (found == asked_names.end()) return {};
    return static_cast<AskedOf>(found - asked_names.begin());
}

std::string Asked::words() const {
    constexpr std::array<const char*, 4> names{"load", "mooring force", "offset", "line tension"};
    if (of == AskedOf::load && !averaged()) return "load of a step";
    const char* what = names.at(static_cast<std::size_t>(of));
    return averaged() ? fmt::format("{} over {:g} s", what, averaging) : what;
}

void HullHistory::add_last(const Simulation& run, const Moorings& moorings) {
    if (!moorings.give_way()) return;
    const MotionHistory& motion = run.motions();
    const auto last = [&](std::string_view of) {
        return find_design_of(of)->value(moorings, motion, motion.surge_offset.size() - 1);
    };
    mooring_force.push_back(last("mooring_force"));
    offset.push_back(last("offset"));
    yaw.push_back(motion.yaw.back());
    if (moorings.line_count() == 0) return;
    double most = 0;
    for (std::size_t k = 0; k < moorings.line_count(); ++k)
        if (const std::optional<LinePull> line = run.structure().moored()->line(k))
            most = std::max(most, line->tension);
    tension.push_back(most);
}

std::vector<double> running_mean(std::span<const double> values, std::size_t count) {
    FLOES_EXPECTS(count > 0);
    const std::size_t whole = std::min(count, values.size());
    std::vector<double> sums{0};
    for (const double value : values) sums.push_back(sums.back() + value);
    std::vector<double> means;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const std::size_t first = std::min(k - std::min(k, whole / 2), values.size() - whole);
        means.push_back((sums[first + whole] - sums[first]) / static_cast<double>(whole));
    }
    FLOES_ENSURES(means.size() == values.size());
    return means;
}

std::size_t averaged_values(const Asked& asked, double step) {
    FLOES_EXPECTS(step > 0);
    return asked.averaged() ? static_cast<std::size_t>(std::max(1.0, std::round(asked.averaging / step))) : 1;
}

std::string averaging_refusal(const Asked& asked, double step, double window) {
    constexpr double rounding = 1e-9;
    if (!asked.averaged() || (asked.averaging >= step * (1 - rounding) && asked.averaging <= window * (1 + rounding)))
        return "";
    return fmt::format(
        "no mean over {:g} s lies in its window of {:g} s with values that are {:g} s apart: give --averaging-s "
        "from {:g} to {:g}",
        asked.averaging, window, step, step, window);
}

std::vector<double> asked_history(const Asked& asked, std::span<const double> values, double step) {
    const std::size_t count = averaged_values(asked, step);
    if (count == 1) return {values.begin(), values.end()};
    return running_mean(values, count);
}

std::vector<double> asked_history(const Asked& asked, const LoadHistory& loads, const HullHistory& hull, double step) {
    if (asked.of == AskedOf::offset) return hull.offset;
    if (asked.of == AskedOf::tension) return hull.tension;
    return asked_history(asked, asked.of == AskedOf::load ? loads.surge : hull.mooring_force, step);
}

}  // namespace floes
