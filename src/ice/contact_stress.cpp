#include "ice/contact_stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ice/felt_patch.hpp"
#include "ice/floe_grid.hpp"
#include "theory/westergaard.hpp"

namespace floes {
namespace {

/// The faces of an element across one of its axes.
struct Faces {
    std::uint8_t plus, minus;
};
constexpr std::array<Faces, 2> faces_along{{{edge_plus_x, edge_minus_x}, {edge_plus_z, edge_minus_z}}};

/// m from the contact to the nearer free face across the axis; infinite where both are joined.
double to_free_face(const PressedElement& element, const Faces& faces, double at) {
    const double none = std::numeric_limits<double>::infinity();
    const double plus = (element.joined & faces.plus) != 0 ? none : element.side / 2 - at;
    const double minus = (element.joined & faces.minus) != 0 ? none : element.side / 2 + at;
    return std::max(0.0, std::min(plus, minus));
}

}  // namespace

std::array<SideStress, 2> contact_stress(const PressedElement& element, const Press& press) {
    const std::array<double, 2> at{press.x, press.z};
    const double crushed = std::sqrt(std::abs(press.down) / (std::numbers::pi * element.crushing_pressure));
    const double contact = felt_radius(crushed, element.thickness);
    const double edge = edge_stress_per_decade(press.down, element.thickness, element.poisson_ratio);
    const double interior = interior_stress_per_decade(press.down, element.thickness, element.poisson_ratio);
    std::array<SideStress, 2> found;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const Faces& faces = faces_along[axis];
        const bool nearer_plus = at[axis] >= 0;
        std::uint8_t face = nearer_plus ? faces.plus : faces.minus;
        if ((element.joined & face) == 0) face = nearer_plus ? faces.minus : faces.plus;
        if ((element.joined & face) == 0) continue;
        const double towards = face == faces.plus ? at[axis] : -at[axis];
        const double beside = to_free_face(element, faces_along[1 - axis], at[1 - axis]);  // an edge along the axis
        const double ahead = to_free_face(element, faces, at[axis]);
        const double inside = std::min({felt_inside.radius(element.side, towards, element.side), beside, ahead});
        const double at_edge = std::min(felt_at_edge.radius(element.side, towards, element.side), ahead);
        found[axis] = {interior * decades(contact, inside) + edge * decades(std::max(contact, beside), at_edge), face};
    }
    return found;
}

double most_contact_stress(const PressedElement& element) {
    const double per_decade = std::max(edge_stress_per_decade(1, element.thickness, element.poisson_ratio),
                                       interior_stress_per_decade(1, element.thickness, element.poisson_ratio));
    return per_decade * decades(felt_radius(0, element.thickness), felt_inside.share * element.side);
}

}  // namespace floes
