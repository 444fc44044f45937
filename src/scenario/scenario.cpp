#include "scenario/scenario.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

int Floe::elements_long() const {
    return static_cast<int>(std::lround(length / element));
}

int Floe::elements_broad() const {
    return static_cast<int>(std::lround(breadth / element));
}

double Scenario::field_length() const {
    return field.floes * floe.length * floe.breadth / (field.concentration * 2.0 * field.half_width);
}

double Scenario::field_end() const {
    return field.begin + field_length();
}

double Scenario::element_mass() const {
    return ice.density * floe.element * floe.element * ice.thickness;
}

double Scenario::moving_mass() const {
    return element_mass() * (1 + water.added_mass);
}

ContactLaw Scenario::contact_law() const {
    ContactLaw law = contact;
    if (law.crushing_pressure == 0) law.crushing_pressure = ice.compressive_strength;
    return law;
}

double Scenario::floating_height() const {
    return ice.thickness * (0.5 - ice.density / water.density);
}

bool Scenario::is_averaging_time(double time) const {
    constexpr double rounding = 1e-9;  // relative: 0.1 / 0.02 need not be 5 in binary
    const double steps = time / general.time_step;
    return std::lround(steps) >= 1 && std::abs(steps - std::round(steps)) <= rounding * steps &&
           time <= analysis.window / analysis.segments * (1 + rounding);
}

std::vector<double> Scenario::averaging_times() const {
    std::vector<double> times = analysis.averaging;
    if (times == Analysis{}.averaging) std::erase_if(times, [&](double time) { return !is_averaging_time(time); });
    return times;
}

int Scenario::step_count() const {
    return static_cast<int>(std::lround((analysis.steady_start + analysis.window) / general.time_step));
}

int Scenario::first_window_step() const {
    return static_cast<int>(std::lround(analysis.steady_start / general.time_step));
}

}  // namespace floes
