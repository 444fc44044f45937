#include "solver/contact_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/lane_slot.hpp"

namespace floes {

void fill_points(AlignedArray<double>& points, std::span<const SolverContact> contacts, const ContactOrder& order,
                 int lanes) {
    const auto width = static_cast<std::size_t>(lanes);
    points.reserve(order.rows() * width * point_field::count);
    std::array<double, point_field::count> none{};
    none[point_field::normal + 2] = 1;
    none[point_field::distance] = std::numeric_limits<double>::infinity();
    none[point_field::section] = -1;
    double* group = points.data();
    for (std::size_t row = 0; row < order.rows(); ++row) {
        for (const double value : none) group = std::fill_n(group, width, value);
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const SolverContact& contact = contacts[i];
        double* at = points.data() + place(order.slot(i), point_field::count, 0, lanes);
        for (std::size_t k = 0; k < 3; ++k) {
            at[(point_field::on_a + k) * width] = contact.on_a[k];
            at[(point_field::on_b + k) * width] = contact.on_b[k];
            at[(point_field::normal + k) * width] = contact.normal[k];
        }
        at[point_field::distance * width] = contact.distance;
        at[point_field::friction * width] = contact.friction;
        at[point_field::impulse * width] = contact.impulse;
        at[point_field::section * width] = contact.section;
        at[point_field::section_growth * width] = contact.section_growth;
    }
}

void fill_friction_start(AlignedArray<double>& start, std::span<const SolverContact> contacts,
                         const ContactOrder& order, int lanes) {
    constexpr int fields = 3;
    const auto width = static_cast<std::size_t>(lanes);
    start.reserve(order.rows() * width * fields);
    std::fill_n(start.data(), order.rows() * width * fields, 0.0);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        double* at = start.data() + place(order.slot(i), fields, 0, lanes);
        for (std::size_t k = 0; k < 3; ++k) at[k * width] = contacts[i].slide[k] * contacts[i].friction_impulse;
    }
}

void set_friction(SolverContact& contact, const std::array<double, 3>& impulse) {
    const double size = std::sqrt(impulse[0] * impulse[0] + impulse[1] * impulse[1] + impulse[2] * impulse[2]);
    contact.friction_impulse = size;
    for (std::size_t k = 0; k < 3; ++k) contact.slide[k] = size > 0 ? impulse[k] / size : 0;
}

}  // namespace floes
