// How far the field reaches: as far as its floes cover it.

#include "scenario/floes.hpp"

namespace floes {

double Scenario::field_length() const {
    const double covered = arrangement.columns.empty() ? field.floes * floe.length * floe.breadth  // all alike
                                                       : covered_area(floes_of(*this));
    return covered / (field.concentration * 2.0 * field.half_width);
}

double Scenario::field_end() const {
    return field.begin + field_length();
}

}  // namespace floes
