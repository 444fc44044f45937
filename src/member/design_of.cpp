#include "member/design_of.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "statistics/averaged_load.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

template <auto history>
double as_it_is(const Moorings&, const MotionHistory& motion, std::size_t step) {
    return (motion.*history)[step];
}

template <auto history>
double either_way(const Moorings&, const MotionHistory& motion, std::size_t step) {
    return std::abs((motion.*history)[step]);
}

double resultant(const Moorings&, const MotionHistory& motion, std::size_t step) {
    return std::hypot(motion.surge_mooring[step], motion.sway_mooring[step]);
}

double offset_of(const Moorings& moorings, const MotionHistory& motion, std::size_t step) {
    return horizontal_offset(moorings, motion.surge_offset[step], motion.sway_offset[step], motion.yaw[step]);
}

constexpr std::array in_surge{Motion::surge, Motion::surge};
constexpr std::array in_sway{Motion::sway, Motion::sway};
constexpr std::array horizontally{Motion::surge, Motion::sway};
constexpr std::array in_yaw{Motion::yaw, Motion::yaw};
constexpr std::array in_heave{Motion::heave, Motion::heave};
constexpr std::array in_pitch{Motion::pitch, Motion::pitch};
constexpr std::array in_roll{Motion::roll, Motion::roll};

}  // namespace

constinit const std::array<DesignOf, 12> design_ofs{
    DesignOf{"load", "Design load", "load", "load", "N"},
    DesignOf{"mooring_force", "Design mooring force", "horizontal resultant of springs, lines and turret", "force", "N",
             resultant, horizontally},
    DesignOf{"surge_mooring", "Design mooring force along the tow", "force of springs, lines and turret along the tow",
             "force", "N", as_it_is<&MotionHistory::surge_mooring>, in_surge, true},
    DesignOf{"sway_mooring", "Design mooring force across the tow", "force of springs, lines and turret across the tow",
             "force", "N", either_way<&MotionHistory::sway_mooring>, in_sway, true},
    DesignOf{"offset", "Design offset", "horizontal offset of the turret, without one of the hull's axis", "offset",
             "m", offset_of, horizontally},
    DesignOf{"surge_offset", "Design offset along the tow", "offset of the hull's axis along the surge load", "offset",
             "m", as_it_is<&MotionHistory::surge_offset>, in_surge, true},
    DesignOf{"sway_offset", "Design offset abeam", "offset of the hull's axis abeam either way", "offset", "m",
             either_way<&MotionHistory::sway_offset>, in_sway, true},
    DesignOf{"yaw", "Design yaw", "yaw either way", "yaw", "rad", either_way<&MotionHistory::yaw>, in_yaw},
    DesignOf{"heave", "Design heave", "heave up or down", "heave", "m", either_way<&MotionHistory::heave>, in_heave},
    DesignOf{"pitch", "Design pitch", "pitch either way", "pitch", "rad", either_way<&MotionHistory::pitch>, in_pitch},
    DesignOf{"roll", "Design roll", "roll either way", "roll", "rad", either_way<&MotionHistory::roll>, in_roll},
    DesignOf{"line_tension", "Design tension of a line over its break load",
             "tension of a line over its break load, of any line", "ratio", "1", as_it_is<&MotionHistory::line_use>,
             horizontally, false, has_lines_that_break},
};

bool DesignOf::is_of(const Scenario& scenario) const {
    const Moorings& moorings = scenario.moorings;
    if (value == nullptr) return true;
    return moorings.give_way() && std::ranges::any_of(motions, [&](Motion one) { return moorings.is_free(one); }) &&
           (has == nullptr || has(moorings));
}

std::string DesignOf::motion_words() const {
    const std::string first{motion_names.at(at(motions[0]))};
    return motions[0] == motions[1] ? first : first + " or " + std::string{motion_names.at(at(motions[1]))};
}

const DesignOf* find_design_of(std::string_view word) {
    const auto found = std::ranges::find(design_ofs, word, &DesignOf::word);
    return found == design_ofs.end() ? nullptr : &*found;
}

const Response* response_of(const MemberOutputs& outputs, const DesignOf& of) {
    const auto kinds = response_kinds();
    const auto at = static_cast<std::size_t>(std::ranges::find(kinds, of.word, &DesignOf::word) - kinds.begin());
    return at < outputs.responses.size() ? &outputs.responses[at] : nullptr;
}

namespace {

/// s, of the mode that is mostly this motion, the longest where none is; 0 where the motion is held.
double period_of(const Scenario& scenario, Motion motion) {
    if (!scenario.moorings.give_way() || !scenario.moorings.is_free(motion)) return 0;
    if (!scenario.moorings.floats() && !scenario.moorings.turret.any()) return scenario.moorings.period(motion);
    double longest = 0;
    for (const NaturalMode& mode : natural_modes(scenario.moorings, scenario.water_stiffness())) {
        if (weathervanes(scenario.moorings, mode)) continue;
        if (mode.motion == motion) return mode.period;
        longest = std::max(longest, mode.period);
    }
    return longest;
}

/// Of the critical, of the motion by itself: what moorings.damping gives, and waves.
double damping_ratio(const Scenario& scenario, Motion motion) {
    const Moorings& moorings = scenario.moorings;
    const auto k = static_cast<int>(motion);
    const double critical = 2 * std::sqrt(moorings.held(scenario.water_stiffness())(k, k) * moorings.inertia()(k, k));
    return moorings.damping + (critical > 0 ? moorings.radiation()(k, k) / critical : 0);
}

/// `values`: of the window.
Response response(const std::vector<double>& values, const Scenario& scenario, double separation) {
    const Analysis& analysis = scenario.analysis;
    const double step = scenario.general.time_step;
    const LoadStatistics found = load_statistics(values, step, analysis.segments);
    const auto apart = static_cast<std::size_t>(std::max(1LL, std::llround(separation / step)));
    return {.mean = found.mean,
            .rise = found.trend * step * static_cast<double>(values.size()),
            .segment_maximum = found.segment_maximum,
            .peaks = declustered_peaks(values, apart, found.mean)};
}

}  // namespace

double period_of(const Scenario& scenario, const DesignOf& of) {
    if (of.value == nullptr || !of.is_of(scenario)) return 0;
    double longest = 0;
    for (const Motion motion : of.motions) longest = std::max(longest, period_of(scenario, motion));
    return longest;
}

double separation_of(const Scenario& scenario, const DesignOf& of) {
    double longest = std::max(scenario.analysis.peak_separation, period_of(scenario, of));
    if (of.value == nullptr || !of.is_of(scenario)) return longest;
    for (const Motion motion : of.motions)
        if (const double ratio = damping_ratio(scenario, motion); ratio > 0)
            longest = std::max(longest, period_of(scenario, motion) / (2 * std::numbers::pi * ratio));
    return longest;
}

std::vector<Response> responses_of(const Scenario& scenario, const MotionHistory& motion) {
    std::vector<Response> all;
    if (!scenario.moorings.give_way()) return all;
    std::vector<double> values;
    for (const DesignOf& of : response_kinds()) {
        Response& one = all.emplace_back();
        if (!of.is_of(scenario)) continue;
        values.clear();
        for (auto step = static_cast<std::size_t>(scenario.first_window_step()); step < motion.surge_offset.size();
             ++step)
            values.push_back(of.value(scenario.moorings, motion, step));
        one = response(values, scenario, separation_of(scenario, of));
    }
    return all;
}

}  // namespace floes
