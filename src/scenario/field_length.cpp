// How far the field reaches: as far as its floes cover it.

#include "scenario/floes.hpp"

namespace floes {

double Scenario::field_length() const {
    const double covered =
        floes_may_differ(*this) ? covered_area(floes_of(*this)) : field.floes * floe.length * floe.breadth;
    return covered / (field.concentration * 2.0 * field.half_width);
}

double Scenario::field_end() const {
    return field.begin + field_length();
}

}  // namespace floes
