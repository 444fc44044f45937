#include "scenario/scenario.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

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

double Scenario::waterline_radius() const {
    const auto& profile = structure.profile;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const ProfilePoint& below = profile[i - 1];
        const ProfilePoint& above = profile[i];
        if (below.height > 0 || above.height < 0) continue;
        if (above.height == below.height) return std::max(above.radius, below.radius);
        return below.radius + (above.radius - below.radius) * (0.0 - below.height) / (above.height - below.height);
    }
    throw InputError("structure.profile_m does not span the waterline (height 0)");
}

int Scenario::step_count() const {
    return static_cast<int>(std::lround((analysis.steady_start + analysis.window) / general.time_step));
}

int Scenario::first_window_step() const {
    return static_cast<int>(std::lround(analysis.steady_start / general.time_step));
}

}  // namespace floes
