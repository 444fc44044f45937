#include "scenario/scenario.hpp"

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

double Scenario::floating_height() const {
    return ice.thickness * (0.5 - ice.density / water.density);
}

int Scenario::step_count() const {
    return static_cast<int>(std::lround((analysis.steady_start + analysis.window) / general.time_step));
}

int Scenario::first_window_step() const {
    return static_cast<int>(std::lround(analysis.steady_start / general.time_step));
}

}  // namespace floes
