// How far the field reaches: as far as its floes cover it.

#include "scenario/floes.hpp"
#include "scenario/sizes.hpp"

namespace floes {

namespace {

/// Of all floes, m². Of drawn sizes in the order of their law, so that it has the same bits for every arrangement.
double area_of_floes(const Scenario& scenario) {
    if (!scenario.arrangement.columns.empty()) return covered_area(floes_of(scenario));
    if (!sizes_may_differ(scenario)) return scenario.field.floes * scenario.floe.length * scenario.floe.breadth;
    double covered = 0;
    for (const FloeShape& shape : floe_sizes(scenario)) covered += shape.area();
    return covered;
}

}  // namespace

double Scenario::field_length() const {
    const double covered = area_of_floes(*this);
    return covered / (field.concentration * 2.0 * field.half_width);
}

double Scenario::field_end() const {
    return field.begin + field_length();
}

}  // namespace floes
