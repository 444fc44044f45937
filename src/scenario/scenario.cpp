#include "scenario/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scenario/floes.hpp"
#include "shapes/hydrostatics.hpp"

namespace floes {

// Lengths in a field without end, in widths of the field (docs/field.md).
constexpr double widths_ahead = 2;
constexpr double widths_behind = 1;
constexpr double lengths_ahead = 8;  // characteristic, of level ice: docs/field.md
constexpr double lengths_behind = 4;

double FloeShape::elements() const {
    if (has_squares()) return static_cast<double>(elements_long()) * elements_broad();
    return count_cells(corners(), element);
}

Outline FloeShape::corners() const {
    return is_polygon() ? outline : corners_of(length / 2, breadth / 2);
}

Outline FloeShape::hull() const {
    return is_polygon() && !is_convex(outline) ? convex_hull(outline) : corners();
}

CutFloe FloeShape::cut() const {
    if (has_squares()) return cut_into_squares(elements_long(), elements_broad(), element);
    return cut_into_cells(corners(), element, static_cast<std::uint32_t>(std::max(0, pattern)));
}

double FloeShape::element_mass(const Ice& ice) const {
    return ice.density * element * element * thickness;
}

double FloeShape::element_mass(const Ice& ice, const CutElement& of) const {
    return has_squares() ? element_mass(ice) : ice.density * thickness * of.area;
}

double FloeShape::floating_height(const Ice& ice, double water_density) const {
    return thickness * (0.5 - ice.density / water_density);
}

int Scenario::pattern_of(std::size_t number) const {
    constexpr int stock = 16;
    if (!has_cells()) return FloeShape::squares;
    return stock * elements.draw + static_cast<int>(number % stock);
}

int Scenario::pattern_of_sheet(std::uint32_t arrangement) const {
    constexpr std::int64_t draws = 1 << 20;
    if (!has_cells()) return FloeShape::squares;
    return static_cast<int>((draws * arrangement + elements.draw) % std::numeric_limits<int>::max());
}

std::vector<PathPlace> Scenario::places() const {
    return path.any() ? places_of(path, general.time_step, step_count()) : std::vector<PathPlace>{};
}

double Scenario::first_yaw() const {
    return path.any() ? places_of(path, general.time_step, 0).front().pose.yaw : 0;
}

double Scenario::reach() const {
    double farthest = 0;
    for (const PathPlace& place : places()) farthest = std::max(farthest, place.pose.x);
    return path.any() ? farthest : towed();
}

double Scenario::towed() const {
    if (path.any()) return way_of(places(), general.time_step);
    return structure.speed * (analysis.steady_start + analysis.window);
}

double Scenario::drift() const {
    const std::vector<PathPlace> all = places();
    const auto moving = std::ranges::count_if(all, [](const PathPlace& place) { return !place.velocity.isZero(0); });
    return moving > 0 ? way_of(all, 1) / static_cast<double>(moving) : structure.speed;
}

Mat6 Scenario::water_stiffness() const {
    if (!moorings.floats()) return Mat6::Zero();
    return floes::water_stiffness(hydrostatics(structure.shape), water.density, general.gravity, moorings.mass,
                                  moorings.height);
}

double Scenario::characteristic_length() const {
    const double rigidity =
        mean_ice().elastic_modulus * std::pow(floe.thickness, 3) / (12 * (1 - ice.poisson_ratio * ice.poisson_ratio));
    return std::pow(rigidity / (water.density * general.gravity), 0.25);
}

double Scenario::stress_averaging() const {
    if (joint.averaging > 0) return joint.averaging;
    return 0.1 * std::sqrt(characteristic_length() / general.gravity);
}

int Scenario::stress_steps() const {
    return static_cast<int>(std::clamp(std::lround(stress_averaging() / general.time_step), 1L, 1L << 30));
}

double Scenario::window_ahead() const {
    if (field.ahead > 0) return field.ahead;
    if (arrangement.level()) return structure.shape.largest_radius() + lengths_ahead * characteristic_length();
    return widths_ahead * 2 * field.half_width;
}

double Scenario::window_behind() const {
    if (field.behind > 0) return field.behind;
    if (arrangement.level()) return structure.shape.largest_radius() + lengths_behind * characteristic_length();
    return widths_behind * 2 * field.half_width;
}

Vec2 Water::current_velocity() const {
    return current * Vec2(std::cos(current_direction), std::sin(current_direction));
}

Vec2 Wind::stress() const {
    return air_density * drag * speed * speed * Vec2(std::cos(direction), std::sin(direction));
}

ContactLaw Scenario::contact_law(const Ice& of) const {
    ContactLaw law = contact;
    if (law.crushing_pressure == 0) law.crushing_pressure = of.compressive_strength;
    return law;
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

namespace {

/// Area of all floes, m². Of drawn sizes in the order of their law, so that it has the same bits for every arrangement.
double area_of_floes(const Scenario& scenario) {
    if (!scenario.arrangement.columns.empty()) return covered_area(floes_of(scenario));
    if (!sizes_may_differ(scenario)) return scenario.field.floes * scenario.floe.length * scenario.floe.breadth;
    double covered = 0;
    for (const FloeShape& shape : floe_sizes(scenario)) covered += shape.area();
    return covered;
}

}  // namespace

double Scenario::field_length() const {
    if (arrangement.level()) return field.endless() ? window_ahead() + window_behind() : floe.length;
    const double covered = area_of_floes(*this);
    return covered / (field.concentration * 2.0 * field.half_width);
}

std::optional<BankGap> Scenario::gap() const {
    if (field.sides == FieldSides::open || path.any() || arrangement.level()) return {};
    const double breadth = field.half_width - structure.shape.waterline_radius();
    if (breadth <= 0) return {};  // a hull as broad as the channel
    return BankGap{breadth, breadth / std::sqrt(area_of_floes(*this) / field.floes)};
}

}  // namespace floes
