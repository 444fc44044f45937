// The motion of a body that contacts read and change: 8 doubles {velocity, inverse mass, angular velocity, 0} in
// `delta`, transposed into lanes and back.

struct Motion {
    V3 velocity;
    Pack inverse_mass;
    V3 angular_velocity;
};

template <int stride, int... lane>
[[gnu::always_inline]] inline void exchange(Pack& a, Pack& b, Sequence<lane...>) {
    const Pack first = __builtin_shufflevector(a, b, ((lane & stride) != 0 ? lane - stride + lanes : lane)...);
    b = __builtin_shufflevector(a, b, ((lane & stride) != 0 ? lane + lanes : lane + stride)...);
    a = first;
}

/// Rows become columns, in log2(lanes) exchanges: of neighbours, of neighbouring pairs, of neighbouring fours.
template <int stride = 1>
[[gnu::always_inline]] inline void transpose(Pack (&rows)[lanes]) {
    if constexpr (stride < lanes) {
#pragma GCC unroll 8
        for (int i = 0; i < lanes; ++i) {
            if ((i & stride) == 0) exchange<stride>(rows[i], rows[i + stride], EveryLane{});
        }
        transpose<2 * stride>(rows);
    }
}

/// at(lane): where the body of that lane begins.
template <class At>
[[gnu::always_inline]] inline Motion gather(const At& at) {
    Pack places[8];
#pragma GCC unroll 8
    for (int part = 0; part < 8; part += lanes) {
        Pack rows[lanes];
#pragma GCC unroll 8
        for (int lane = 0; lane < lanes; ++lane) rows[lane] = *reinterpret_cast<const Pack*>(at(lane) + part);
        transpose(rows);
#pragma GCC unroll 8
        for (int i = 0; i < lanes; ++i) places[part + i] = rows[i];
    }
    return {{places[0], places[1], places[2]}, places[3], {places[4], places[5], places[6]}};
}

template <class At>
[[gnu::always_inline]] inline void scatter(const At& at, const Motion& motion) {
    const auto& [v, inverse_mass, w] = motion;
    const Pack places[8] = {v.x, v.y, v.z, inverse_mass, w.x, w.y, w.z, Pack{}};
#pragma GCC unroll 8
    for (int part = 0; part < 8; part += lanes) {
        Pack rows[lanes];
#pragma GCC unroll 8
        for (int i = 0; i < lanes; ++i) rows[i] = places[part + i];
        transpose(rows);
#pragma GCC unroll 8
        for (int lane = 0; lane < lanes; ++lane) *reinterpret_cast<Pack*>(at(lane) + part) = rows[lane];
    }
}

void to_contacts(const LaneArrays& arrays, const std::uint32_t* groups, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double* from = arrays.sweep + static_cast<std::size_t>(groups[i]) * (sweep_field::count * lanes);
        double* to = arrays.delta + static_cast<std::size_t>(groups[i]) * (8 * lanes);
        scatter([to](int lane) { return to + 8 * lane; },
                {load3(from, sweep_field::velocity), load(from, sweep_field::inverse_mass),
                 load3(from, sweep_field::angular_velocity)});
    }
}

void from_contacts(const LaneArrays& arrays, const std::uint32_t* groups, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double* from = arrays.delta + static_cast<std::size_t>(groups[i]) * (8 * lanes);
        double* to = arrays.sweep + static_cast<std::size_t>(groups[i]) * (sweep_field::count * lanes);
        const Motion motion = gather([from](int lane) { return from + 8 * lane; });
        store3(to, sweep_field::velocity, motion.velocity);
        store3(to, sweep_field::angular_velocity, motion.angular_velocity);
    }
}
