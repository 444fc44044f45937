#include "theory/westergaard.hpp"

#include <cmath>

namespace floes {
namespace {

/// log10(E T³ / (k b⁴))
double decades(const FloatingPlate& plate, double elastic_modulus, double b) {
    return std::log10(elastic_modulus * std::pow(plate.thickness, 3) / (plate.foundation() * std::pow(b, 4)));
}

}  // namespace

double edge_stress_per_decade(double load, double thickness, double poisson_ratio) {
    return 4 * 0.529 * (1 + 0.54 * poisson_ratio) * load / (thickness * thickness);
}

double interior_stress_per_decade(double load, double thickness, double poisson_ratio) {
    return 4 * 0.275 * (1 + poisson_ratio) * load / (thickness * thickness);
}

double edge_load_stress(const FloatingPlate& plate, double elastic_modulus, double load, double b) {
    return edge_stress_per_decade(load, plate.thickness, plate.poisson_ratio) / 4 *
           (decades(plate, elastic_modulus, b) - 0.71);
}

double interior_load_stress(const FloatingPlate& plate, double elastic_modulus, double load, double b) {
    return interior_stress_per_decade(load, plate.thickness, plate.poisson_ratio) / 4 *
           decades(plate, elastic_modulus, b);
}

double felt_radius(double a, double thickness) {
    constexpr double thick_plate = 1.724;
    if (a >= thick_plate * thickness) return a;
    return std::sqrt(1.6 * a * a + thickness * thickness) - 0.675 * thickness;
}

}  // namespace floes
