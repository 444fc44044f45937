// Joints that are solved exactly: their impulses before velocities change, and their reactions at the end of the step.
// All in the axes of each piece.

/// A motion or an impulse of one body: its part in the plane of the floe {x, z, about y} and its part out of the plane
/// {y, about x, about z}. The two do not couple.
struct Flat {
    V3 within, out;
};

inline Flat flat(const V3& linear, const V3& angular) {
    return {{linear.x, linear.z, angular.y}, {linear.y, angular.x, angular.z}};
}

inline V3 linear(const Flat& f) {
    return {f.within.x, f.out.x, f.within.y};
}

inline V3 angular(const Flat& f) {
    return {f.out.y, f.within.z, f.out.z};
}

/// at(lane): where the 8 numbers of that lane's body begin.
template <class At>
[[gnu::always_inline]] inline Flat gather_flat(const At& at) {
    const Motion places = gather(at);
    return {places.velocity, places.angular_velocity};
}

template <class At>
[[gnu::always_inline]] inline void scatter_flat(const At& at, const Flat& f) {
    scatter(at, {f.within, Pack{}, f.out});
}

/// Of row-by-row numbers.
inline M3 matrix(const Pack* m) {
    return {{m[0], m[3], m[6]}, {m[1], m[4], m[7]}, {m[2], m[5], m[8]}};
}

/// Axes of the pieces of the bodies in a pack.
[[gnu::always_inline]] inline M3 gather_frame(const DirectArrays& direct, const std::uint32_t* bodies) {
    Pack frame[9];
    gather([&](int lane) { return direct.frame + direct.piece[bodies[lane]] * frame_stride; }, frame);
    return matrix(frame);
}

void begin_local(const LaneArrays& arrays, const DirectArrays& direct, std::size_t groups) {
    for (std::size_t i = 0; i < groups; ++i) {
        const double* body = group_of(arrays.body, body_field::count, i);
        const M3 frame = gather_frame(direct, arrays.body_of_slot + i * lanes);
        scatter_flat([&](int lane) { return group_of(direct.start, 8, i) + 8 * lane; },
                     flat(transposed_times(frame, load3(body, body_field::start_velocity)),
                          transposed_times(frame, load3(body, body_field::start_angular_velocity))));
        for (int part = 0; part < 8; ++part) store(group_of(direct.impulse, 8, i), part, Pack{});
    }
}

void from_pieces(const LaneArrays& arrays, const DirectArrays& direct, std::size_t groups) {
    for (std::size_t i = 0; i < groups; ++i) {
        double* to = group_of(arrays.sweep, sweep_field::count, i);
        const Flat change = gather_flat([&](int lane) { return group_of(arrays.delta, 8, i) + 8 * lane; });
        const M3 frame = gather_frame(direct, arrays.body_of_slot + i * lanes);
        store3(to, sweep_field::velocity, frame * linear(change));
        store3(to, sweep_field::angular_velocity, frame * angular(change));
    }
}

inline V3 times(const V3& a, const V3& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// The motion that a joint resists: that of a relative to b, along the joint's axes.
struct JointMotion {
    V3 sliding, turning;
};

/// velocities: 8 numbers of each body.
[[gnu::always_inline]] inline JointMotion joint_motion(const double* spring, const double* velocities,
                                                       const std::uint32_t* joined) {
    const M3 axes = load_matrix(spring, spring_field::axes);
    const auto of = [=](int i) { return velocities + 8 * static_cast<std::size_t>(joined[i]); };
    const Flat a = gather_flat(of);
    const Flat b = gather_flat([=](int lane) { return of(lanes + lane); });
    const V3 sliding = (linear(a) - linear(b)) + (cross(angular(a), load3(spring, spring_field::lever_a)) -
                                                  cross(angular(b), load3(spring, spring_field::lever_b)));
    return {transposed_times(axes, sliding), transposed_times(axes, angular(a) - angular(b))};
}

/// Adds the impulses in each lane to those of the lane's bodies a and b where moves(body): lane by lane, so that those on
/// a body are summed in their order at every width.
template <class Moves>
[[gnu::always_inline]] inline void add_to_bodies(double* impulse, const std::uint32_t* bodies, const Flat& on_a,
                                                 const Flat& on_b, const Moves& moves) {
    alignas(64) double by_lane[2 * lanes][8];
    scatter_flat([&](int lane) { return by_lane[lane]; }, on_a);
    scatter_flat([&](int lane) { return by_lane[lanes + lane]; }, on_b);
    for (int i = 0; i < 2 * lanes; ++i) {
        const int at = i / 2 + i % 2 * lanes;
        if (!moves(bodies[at])) continue;
        double* total = impulse + static_cast<std::size_t>(bodies[at]) * 8;
#pragma GCC unroll 8
        for (int part = 0; part < 8; part += lanes)
            store(total + part, 0, load(total + part, 0) + load(by_lane[at] + part, 0));
    }
}

inline void press_group(const LaneArrays& arrays, const DirectArrays& direct, std::size_t i, double time_step) {
    double* spring = group_of(direct.spring, spring_field::count, i);
    const std::uint32_t* joined = direct.joined + i * (2 * lanes);
    Pack a[12], b[12];  // position and rotation
    gather([=](int lane) { return arrays.motion[joined[lane]].position; }, a);
    gather([=](int lane) { return arrays.motion[joined[lanes + lane]].position; }, b);
    const V3 between = V3{b[0], b[1], b[2]} - V3{a[0], a[1], a[2]};
    const JointGeometry g =
        joint_geometry(group_of(arrays.frame, frame_field::count, i), matrix(a + 3), matrix(b + 3), between);
    const M3 axes = load_matrix(spring, spring_field::axes);
    const V3 lever_a = load3(spring, spring_field::lever_a);
    const V3 lever_b = load3(spring, spring_field::lever_b);
    const JointMotion motion = joint_motion(spring, direct.start, joined);
    // The angles are those by which a is turned ahead of b, the gap that by which b is ahead of a.
    const V3 pull =
        times(load3(spring, spring_field::stiffness), g.gap) - times(load3(spring, spring_field::hold), motion.sliding);
    const V3 twist = (times(load3(spring, spring_field::stiffness + 3), g.angle) +
                      times(load3(spring, spring_field::hold + 3), motion.turning)) *
                     (Pack{} - 1.0);
    store3(spring, spring_field::impulse, pull);
    store3(spring, spring_field::impulse + 3, twist);
    const V3 force = axes * pull;
    const V3 moment = axes * twist;

    // The levers are those of the unstrained piece. In a strained one the two pivots differ slightly, so that equal and
    // opposite forces would leave a couple. It is computed from the last step's reaction, and each body gets half of
    // its opposite.
    const M3 frame = gather_frame(direct, joined);
    const V3 apart = transposed_times(frame, between) + (lever_b - lever_a);
    const V3 reaction = load3(group_of(arrays.reaction, reaction_field::count, i), reaction_field::force);
    const V3 couple = cross(apart, axes * reaction) * (Pack{} + 0.5 * time_step);
    add_to_bodies(direct.impulse, joined, flat(force, (cross(lever_a, force) + moment) + couple),
                  flat(force * (Pack{} - 1.0), couple - (cross(lever_b, force) + moment)),
                  [](std::uint32_t) { return true; });
}

void press_joints(const LaneArrays& arrays, const DirectArrays& direct, std::size_t groups, double time_step) {
    for (std::size_t i = 0; i < groups; ++i) press_group(arrays, direct, i, time_step);
}

void direct_reactions(const LaneArrays& arrays, const DirectArrays& direct, std::size_t groups, double time_step) {
    const Pack per_step = Pack{} + 1.0 / time_step;
    for (std::size_t i = 0; i < groups; ++i) {
        const double* spring = group_of(direct.spring, spring_field::count, i);
        double* reaction = group_of(arrays.reaction, reaction_field::count, i);
        const JointMotion change = joint_motion(spring, arrays.delta, direct.joined + i * (2 * lanes));
        const V3 pull = load3(spring, spring_field::impulse) - times(load3(spring, spring_field::hold), change.sliding);
        const V3 twist =
            load3(spring, spring_field::impulse + 3) - times(load3(spring, spring_field::hold + 3), change.turning);
        store3(reaction, reaction_field::force, pull * per_step);
        store3(reaction, reaction_field::moment, twist * per_step);
    }
}

/// 8 numbers in packs.
inline constexpr int parts_of_8 = 8 / lanes;

template <int... lane>
[[gnu::always_inline]] inline Pack lower_and_upper(Pack low, Pack high, Sequence<lane...>) {
    return __builtin_shufflevector(low, high, (lane < 4 ? lane : lane + lanes)...);
}

/// Number k four times, then number 4 + k four times.
[[gnu::always_inline]] inline void spread_halves(const double* numbers, int k, Pack (&to)[parts_of_8]) {
#pragma GCC unroll 8
    for (int part = 0; part < parts_of_8; ++part) {
        if constexpr (lanes == 8) {
            const Pack low = Pack{} + numbers[k];
            const Pack high = Pack{} + numbers[4 + k];
            to[part] = lower_and_upper(low, high, EveryLane{});
        } else {
            to[part] = Pack{} + numbers[part * lanes < 4 ? k : 4 + k];
        }
    }
}

void add_velocity_changes(double* delta, const ComplianceColumn& column, const double* impulse) {
    // In-plane impulses in the lower half, out-of-plane ones in the upper half, like the columns of a block.
    Pack factor[3][parts_of_8];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) spread_halves(impulse, k, factor[k]);
    for (std::size_t i = 0; i < column.count; ++i) {
        const double* block = column.blocks + static_cast<std::size_t>(column.within[i]) * compliance_block;
        double* to = delta + static_cast<std::size_t>(column.slots[i]) * 8;
#pragma GCC unroll 8
        for (int part = 0; part < 8; part += lanes) {
            Pack sum = load(to + part, 0);
#pragma GCC unroll 3
            for (int k = 0; k < 3; ++k) sum = sum + load(block + 8 * k + part, 0) * factor[k][part / lanes];
            store(to + part, 0, sum);
        }
    }
}
