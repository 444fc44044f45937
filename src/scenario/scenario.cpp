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

double Scenario::floating_height() const {
    return ice.thickness * (0.5 - ice.density / water.density);
}

double Scenario::waterline_radius() const {
    const auto& profile = structure.profile;
    double radius = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const ProfilePoint& below = profile[i - 1];
        const ProfilePoint& above = profile[i];
        if (below.height > 0 || above.height < 0) continue;
        const double rise = above.height - below.height;
        const double here = rise > 0 ? below.radius - (above.radius - below.radius) * below.height / rise
                                     : std::max(below.radius, above.radius);
        radius = std::max(radius, here);  // a flat ring at the waterline: the larger radius
    }
    return radius;
}

int Scenario::step_count() const {
    return static_cast<int>(std::lround((analysis.steady_start + analysis.window) / general.time_step));
}

int Scenario::first_window_step() const {
    return static_cast<int>(std::lround(analysis.steady_start / general.time_step));
}

}  // namespace floes
