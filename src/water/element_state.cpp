#include "water/element_state.hpp"

#include "water/water_kernels.hpp"

namespace floes {

void put_fields(const ElementState& state, double* fields, std::size_t stride) {
    const auto put = [&](const double* values, std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) fields[(first + i) * stride] = values[i];
    };
    put(state.position.data(), water_field::position, 3);
    put(state.rotation.data(), water_field::rotation, 9);  // by column, as in Eigen
    put(state.velocity.data(), water_field::velocity, 3);
    put(state.angular_velocity.data(), water_field::angular_velocity, 3);
}

Wrench wrench_at(const double* fields, std::size_t stride) {
    const auto field = [&](std::size_t f) { return fields[f * stride]; };
    return {{field(0), field(1), field(2)}, {field(3), field(4), field(5)}};
}

}  // namespace floes
