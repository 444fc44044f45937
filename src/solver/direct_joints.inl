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

inline double* body_group(double* array, int fields, std::size_t group) {
    return array + group * static_cast<std::size_t>(fields * lanes);
}

inline const double* body_group(const double* array, int fields, std::size_t group) {
    return array + group * static_cast<std::size_t>(fields * lanes);
}

void begin_local(const LaneArrays& arrays, const DirectArrays& direct, std::size_t groups) {
    for (std::size_t i = 0; i < groups; ++i) {
        const double* body = body_group(arrays.body, body_field::count, i);
        double* local = body_group(direct.local, local_field::count, i);
        const M3 frame = load_matrix(local, local_field::frame);
        store3(local, local_field::velocity, transposed_times(frame, load3(body, body_field::start_velocity)));
        store3(local, local_field::angular_velocity,
               transposed_times(frame, load3(body, body_field::start_angular_velocity)));
        store3(local, local_field::impulse, V3{});
        store3(local, local_field::impulse + 3, V3{});
    }
}

inline V3 times(const V3& a, const V3& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// The motion that a joint resists: that of a relative to b, along the joint's axes.
struct JointMotion {
    V3 sliding, turning;
};

inline JointMotion joint_motion(const double* spring, const double* a, const double* b) {
    const M3 axes = load_matrix(spring, spring_field::axes);
    const V3 angular_change_a = load3(a, local_field::angular_velocity);
    const V3 angular_change_b = load3(b, local_field::angular_velocity);
    const V3 sliding = (load3(a, local_field::velocity) - load3(b, local_field::velocity)) +
                       (cross(angular_change_a, load3(spring, spring_field::lever_a)) -
                        cross(angular_change_b, load3(spring, spring_field::lever_b)));
    return {transposed_times(axes, sliding), transposed_times(axes, angular_change_a - angular_change_b)};
}

inline void add3(double* group, int field, const V3& v) {
    store3(group, field, load3(group, field) + v);
}

inline void press_joint(const double* frame, double* spring, const double* reaction, const double* body_a,
                        const double* body_b, double* a, double* b, double time_step) {
    const JointGeometry g = joint_geometry(frame, body_a, body_b);
    const M3 axes = load_matrix(spring, spring_field::axes);
    const V3 lever_a = load3(spring, spring_field::lever_a);
    const V3 lever_b = load3(spring, spring_field::lever_b);
    const JointMotion motion = joint_motion(spring, a, b);
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
    const V3 apart = transposed_times(load_matrix(a, local_field::frame),
                                      load3(body_b, body_field::position) - load3(body_a, body_field::position)) +
                     (lever_b - lever_a);
    const V3 couple = cross(apart, axes * load3(reaction, reaction_field::force)) * (Pack{} + 0.5 * time_step);
    add3(a, local_field::impulse, force);
    add3(a, local_field::impulse + 3, (cross(lever_a, force) + moment) + couple);
    add3(b, local_field::impulse, force * (Pack{} - 1.0));
    add3(b, local_field::impulse + 3, couple - (cross(lever_b, force) + moment));
}

void press_joints(const LaneArrays& arrays, const DirectArrays& direct, const LaneBlock& block, double time_step) {
    for (std::int32_t j = 0; j < block.joints; ++j) {
        const std::int32_t a = block.pairs[2 * j];
        const std::int32_t b = block.pairs[2 * j + 1];
        press_joint(joint_group(arrays.frame, frame_field::count, block, j),
                    joint_group(direct.spring, spring_field::count, block, j),
                    joint_group(arrays.reaction, reaction_field::count, block, j),
                    body_group(arrays.body, body_field::count, block, a),
                    body_group(arrays.body, body_field::count, block, b),
                    body_group(direct.local, local_field::count, block, a),
                    body_group(direct.local, local_field::count, block, b), time_step);
    }
}

void to_pieces(const LaneArrays&, const DirectArrays& direct, std::size_t groups) {
    for (std::size_t i = 0; i < groups; ++i) {
        const double* local = body_group(direct.local, local_field::count, i);
        double* to = direct.impulse + i * static_cast<std::size_t>(8 * lanes);
        scatter_flat([to](int lane) { return to + 8 * lane; },
                     flat(load3(local, local_field::impulse), load3(local, local_field::impulse + 3)));
    }
}

void from_pieces(const LaneArrays& arrays, const DirectArrays& direct, std::size_t groups) {
    for (std::size_t i = 0; i < groups; ++i) {
        const double* from = arrays.delta + i * static_cast<std::size_t>(8 * lanes);
        double* local = body_group(direct.local, local_field::count, i);
        double* to = body_group(arrays.sweep, sweep_field::count, i);
        const Flat change = gather_flat([from](int lane) { return from + 8 * lane; });
        const M3 frame = load_matrix(local, local_field::frame);
        store3(local, local_field::velocity, linear(change));
        store3(local, local_field::angular_velocity, angular(change));
        store3(to, sweep_field::velocity, frame * linear(change));
        store3(to, sweep_field::angular_velocity, frame * angular(change));
    }
}

void direct_reactions(const LaneArrays& arrays, const DirectArrays& direct, const LaneBlock& block, double time_step) {
    const Pack per_step = Pack{} + 1.0 / time_step;
    for (std::int32_t j = 0; j < block.joints; ++j) {
        const double* spring = joint_group(direct.spring, spring_field::count, block, j);
        double* reaction = joint_group(arrays.reaction, reaction_field::count, block, j);
        const JointMotion change =
            joint_motion(spring, body_group(direct.local, local_field::count, block, block.pairs[2 * j]),
                         body_group(direct.local, local_field::count, block, block.pairs[2 * j + 1]));
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
