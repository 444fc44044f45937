// Bodies in lanes: how they move before, between and after the sweeps.

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

/// at(lane): where that lane's numbers begin, together in memory; as many as whole packs hold are read.
template <int count, class At>
[[gnu::always_inline]] inline void gather(const At& at, Pack (&to)[count]) {
#pragma GCC unroll 12
    for (int part = 0; part < count; part += lanes) {
        Pack rows[lanes];
#pragma GCC unroll 8
        for (int lane = 0; lane < lanes; ++lane) rows[lane] = *reinterpret_cast<const Pack*>(at(lane) + part);
        transpose(rows);
#pragma GCC unroll 8
        for (int i = 0; i < lanes; ++i) {
            if (part + i < count) to[part + i] = rows[i];
        }
    }
}

/// at(lane): where the body of that lane begins.
template <class At>
[[gnu::always_inline]] inline Motion gather(const At& at) {
    Pack places[8];
    gather(at, places);
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
        const double* from = group_of(arrays.sweep, sweep_field::count, groups[i]);
        double* to = group_of(arrays.delta, 8, groups[i]);
        scatter([to](int lane) { return to + 8 * lane; },
                {load3(from, sweep_field::velocity), load(from, sweep_field::inverse_mass),
                 load3(from, sweep_field::angular_velocity)});
    }
}

void from_contacts(const LaneArrays& arrays, const std::uint32_t* groups, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double* from = group_of(arrays.delta, 8, groups[i]);
        double* to = group_of(arrays.sweep, sweep_field::count, groups[i]);
        const Motion motion = gather([from](int lane) { return from + 8 * lane; });
        store3(to, sweep_field::velocity, motion.velocity);
        store3(to, sweep_field::angular_velocity, motion.angular_velocity);
    }
}

// Bodies before the joints: btSequentialImpulseConstraintSolver::convertBodies with the implicit gyroscopic term in
// body axes (Bullet's default), in lanes.

/// x of m x = f by Cramer's rule.
inline V3 solve3(const M3& m, const V3& f) {
    const V3 yz = cross(m.y, m.z);
    const Pack inverse = 1.0 / dot(m.x, yz);
    return {dot(f, yz) * inverse, dot(m.x, cross(f, m.z)) * inverse, dot(m.x, cross(m.y, f)) * inverse};
}

/// Change of angular velocity by the gyroscopic term in one step: one Newton step of the implicit Euler equation in
/// body axes.
inline V3 gyroscopic_change(const M3& turn, const V3& angular_velocity, const V3& inertia, double time_step) {
    const V3 w = transposed_times(turn, angular_velocity);
    const V3 momentum = {inertia.x * w.x, inertia.y * w.y, inertia.z * w.z};
    const V3 residual = cross(w, momentum) * (w.x * 0.0 + time_step);
    const M3 jacobian = {
        {inertia.x, (w.z * inertia.x - momentum.z) * time_step, (momentum.y - w.y * inertia.x) * time_step},
        {(momentum.z - w.z * inertia.y) * time_step, inertia.y, (w.x * inertia.y - momentum.x) * time_step},
        {(w.y * inertia.z - momentum.y) * time_step, (momentum.x - w.x * inertia.z) * time_step, inertia.z}};
    return turn * (w - solve3(jacobian, residual)) - angular_velocity;
}

/// Force and torque on the bodies of a group; they are zero from then on.
inline Motion forces_on(const LaneArrays& arrays, std::size_t group) {
    const std::uint32_t* body = arrays.body_of_slot + group * lanes;
    const auto at = [&](int lane) { return arrays.force + force_field::count * static_cast<std::size_t>(body[lane]); };
    const Motion given = gather(at);
    const Pack none{};
    scatter(at, {{none, none, none}, given.inverse_mass, {none, none, none}});
    const V3& f = given.velocity;
    return {{f.x + none, f.y + given.inverse_mass, f.z + none}, none, given.angular_velocity};
}

void prepare_bodies(const LaneArrays& arrays, std::size_t groups, double time_step) {
    for (std::size_t i = 0; i < groups; ++i) {
        double* body = group_of(arrays.body, body_field::count, i);
        double* sweeping = group_of(arrays.sweep, sweep_field::count, i);
        const M3 turn = load_matrix(body, body_field::rotation);
        const V3 inverse = load3(body, body_field::inverse_inertia);
        const Pack inverse_mass = load(sweeping, sweep_field::inverse_mass);
        const Pack zero = inverse_mass * 0.0;
        const auto moves = inverse_mass > 0.0;

        const M3 scaled = {turn.x * inverse.x, turn.y * inverse.y, turn.z * inverse.z};
        const S3 inertia = {scaled.x.x * turn.x.x + scaled.y.x * turn.y.x + scaled.z.x * turn.z.x,
                            scaled.x.x * turn.x.y + scaled.y.x * turn.y.y + scaled.z.x * turn.z.y,
                            scaled.x.x * turn.x.z + scaled.y.x * turn.y.z + scaled.z.x * turn.z.z,
                            scaled.x.y * turn.x.y + scaled.y.y * turn.y.y + scaled.z.y * turn.z.y,
                            scaled.x.y * turn.x.z + scaled.y.y * turn.y.z + scaled.z.y * turn.z.z,
                            scaled.x.z * turn.x.z + scaled.y.z * turn.y.z + scaled.z.z * turn.z.z};
        const int at = sweep_field::inverse_inertia;
        store3(sweeping, at, {inertia.xx, inertia.xy, inertia.xz});
        store3(sweeping, at + 3, {inertia.yy, inertia.yz, inertia.zz});

        const V3 angular_velocity = load3(body, body_field::angular_velocity);
        const V3 principal = {moves ? 1.0 / inverse.x : zero, moves ? 1.0 / inverse.y : zero,
                              moves ? 1.0 / inverse.z : zero};
        const V3 gyroscopic = gyroscopic_change(turn, angular_velocity, principal, time_step);
        const V3 turned = {moves ? gyroscopic.x : zero, moves ? gyroscopic.y : zero, moves ? gyroscopic.z : zero};
        const Motion acting = forces_on(arrays, i);
        store3(body, body_field::force, acting.velocity);
        store3(body, body_field::torque, acting.angular_velocity);
        const V3 torque = inertia * acting.angular_velocity;
        store3(body, body_field::start_angular_velocity, angular_velocity + (torque * (zero + time_step) + turned));
        store3(body, body_field::start_velocity,
               load3(body, body_field::velocity) + acting.velocity * (inverse_mass * time_step));
        store3(sweeping, sweep_field::velocity, {zero, zero, zero});
        store3(sweeping, sweep_field::angular_velocity, {zero, zero, zero});
    }
}

/// Unit quaternion {x, y, z, w} of a rotation matrix, from its largest component.
struct Turn {
    V3 v;
    Pack w;
};

inline Turn turn_of(const M3& m) {
    const Pack xx = m.x.x, yy = m.y.y, zz = m.z.z;
    const V3 odd = {m.y.z - m.z.y, m.z.x - m.x.z, m.x.y - m.y.x};
    const V3 even = {m.y.z + m.z.y, m.z.x + m.x.z, m.x.y + m.y.x};
    const auto by_w = xx + yy + zz > 0.0;
    const auto by_z = xx < yy ? yy < zz : xx < zz;
    const auto by_y = xx < yy;
    const Pack square =
        by_w ? xx + yy + zz + 1.0 : (by_z ? zz - xx - yy + 1.0 : (by_y ? yy - zz - xx + 1.0 : xx - yy - zz + 1.0));
    const Pack scale = 0.5 / square_root(square);
    const Pack x = by_w ? odd.x : (by_z ? even.y : (by_y ? even.z : square));
    const Pack y = by_w ? odd.y : (by_z ? even.x : (by_y ? square : even.z));
    const Pack z = by_w ? odd.z : (by_z ? square : (by_y ? even.x : even.y));
    const Pack w = by_w ? square : (by_z ? odd.z : (by_y ? odd.y : odd.x));
    return {{x * scale, y * scale, z * scale}, w * scale};
}

inline M3 matrix_of(const Turn& q) {
    const Pack s = 2.0 / (dot(q.v, q.v) + q.w * q.w);
    const V3 scaled = q.v * s;
    const V3 w = scaled * q.w;
    const Pack xx = q.v.x * scaled.x, xy = q.v.x * scaled.y, xz = q.v.x * scaled.z;
    const Pack yy = q.v.y * scaled.y, yz = q.v.y * scaled.z, zz = q.v.z * scaled.z;
    return {{1.0 - (yy + zz), xy + w.z, xz - w.y},
            {xy - w.z, 1.0 - (xx + zz), yz + w.x},
            {xz + w.y, yz - w.x, 1.0 - (xx + yy)}};
}

/// sin(h) / h and cos(h) from h², to the last bit but one or two for 0 <= h <= π/8.
inline Pack sine_ratio(Pack s) {
    return 1.0 - s * (1.0 / 6) *
                     (1.0 - s * (1.0 / 20) *
                                (1.0 - s * (1.0 / 42) *
                                           (1.0 - s * (1.0 / 72) * (1.0 - s * (1.0 / 110) * (1.0 - s * (1.0 / 156))))));
}

inline Pack cosine(Pack s) {
    return 1.0 -
           s * (1.0 / 2) *
               (1.0 -
                s * (1.0 / 12) *
                    (1.0 - s * (1.0 / 30) *
                               (1.0 - s * (1.0 / 56) *
                                          (1.0 - s * (1.0 / 90) * (1.0 - s * (1.0 / 132) * (1.0 - s * (1.0 / 182)))))));
}

/// btTransformUtil::integrateTransform: at most π/4 in a step.
inline M3 turned(const M3& turn, const V3& angular_velocity, double time_step) {
    constexpr double limit = 0.39269908169872414;  // π/8
    const Pack square = dot(angular_velocity, angular_velocity) * (0.25 * time_step * time_step);
    const Pack half = square > limit * limit ? square * 0.0 + limit * limit : square;
    const V3 axis = angular_velocity * (sine_ratio(half) * (0.5 * time_step));
    const Pack w = cosine(half);
    const Turn now = turn_of(turn);
    return matrix_of({axis * now.w + now.v * w + cross(axis, now.v), w * now.w - dot(axis, now.v)});
}

template <class Mask>
inline V3 chosen(const Mask& mask, const V3& a, const V3& b) {
    return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

template <class Mask>
inline M3 chosen(const Mask& mask, const M3& a, const M3& b) {
    return {chosen(mask, a.x, b.x), chosen(mask, a.y, b.y), chosen(mask, a.z, b.z)};
}

/// The motion of a group's bodies, each body's together.
inline void write_motion(const LaneArrays& arrays, std::size_t group, const double* body, Pack way, Pack turn) {
    const std::uint32_t* number = arrays.body_of_slot + group * lanes;
    constexpr int known = body_field::angular_velocity + 3;
#pragma GCC unroll 24
    for (int part = 0; part < motion_numbers; part += lanes) {
        Pack rows[lanes];
#pragma GCC unroll 8
        for (int i = 0; i < lanes; ++i) {
            const int field = part + i;
            rows[i] = field < known ? load(body, field) : field == known ? way : field == known + 1 ? turn : Pack{};
        }
        transpose(rows);
#pragma GCC unroll 8
        for (int lane = 0; lane < lanes; ++lane)
            store(reinterpret_cast<double*>(arrays.motion + number[lane]) + part, 0, rows[lane]);
    }
}

void advance_bodies(const LaneArrays& arrays, std::size_t groups, double time_step) {
    for (std::size_t i = 0; i < groups; ++i) {
        double* body = group_of(arrays.body, body_field::count, i);
        const double* sweeping = group_of(arrays.sweep, sweep_field::count, i);
        const V3 velocity = load3(body, body_field::start_velocity) + load3(sweeping, sweep_field::velocity);
        const V3 angular_velocity =
            load3(body, body_field::start_angular_velocity) + load3(sweeping, sweep_field::angular_velocity);
        const V3 step = velocity * (velocity.x * 0.0 + time_step);
        const M3 before = load_matrix(body, body_field::rotation);
        const auto moves = load(sweeping, sweep_field::inverse_mass) > 0.0;
        const M3 turn = chosen(moves, turned(before, angular_velocity, time_step), before);  // not even rounded anew
        store3(body, body_field::velocity, velocity);
        store3(body, body_field::angular_velocity, angular_velocity);
        store3(body, body_field::position, load3(body, body_field::position) + step);
        store3(body, body_field::rotation, {turn.x.x, turn.y.x, turn.z.x});
        store3(body, body_field::rotation + 3, {turn.x.y, turn.y.y, turn.z.y});
        store3(body, body_field::rotation + 6, {turn.x.z, turn.y.z, turn.z.z});
        write_motion(arrays, i, body, square_root(dot(velocity, velocity)) * time_step,
                     square_root(dot(angular_velocity, angular_velocity)) * time_step);
    }
}

// Start velocities of bodies that carry water (carried_water.hpp): the force and torque of the step, the ice's
// gyroscopic term and what the moving water exerts, over the inertia of body and water together.

/// A body and the water that it carries, in its own axes: v, and w by which it turns.
struct Carrier {
    const double* water;
    V3 ice = load3(water, carried_field::ice);
    Pack in_plane = load(water, carried_field::in_plane);
    Pack normal = load(water, carried_field::normal);
    Pack mx = load(water, carried_field::x);
    Pack mz = load(water, carried_field::z);
    Pack xz = load(water, carried_field::xz);
    Pack inverse = load(water, carried_field::inverse_in_plane);
    Pack mass_of_ice = 1.0 / inverse - in_plane;

    V3 momentum(const V3& v, const V3& w) const {
        return {in_plane * v.x, normal * v.y - mz * w.x + mx * w.z, in_plane * v.z};
    }
    V3 moment(const V3& v, const V3& w) const {
        return {load(water, carried_field::zz) * w.x - mz * v.y - xz * w.z, load(water, carried_field::yaw) * w.y,
                mx * v.y - xz * w.x + load(water, carried_field::xx) * w.z};
    }
    V3 spin(const V3& w) const { return {ice.x * w.x, ice.y * w.y, ice.z * w.z}; }
    /// What they become faster by, along and about its axes.
    void accelerate(const V3& force, const V3& torque, V3& faster, V3& spinning) const {
        const V3 out = load_symmetric(water, carried_field::inverse_out) * V3{force.y, torque.x, torque.z};
        faster = {inverse * force.x, out.x, inverse * force.z};
        spinning = {out.y, load(water, carried_field::inverse_yaw) * torque.y, out.z};
    }
    Pack energy(const V3& v, const V3& w) const {  // twice
        return mass_of_ice * dot(v, v) + dot(v, momentum(v, w)) + dot(w, moment(v, w) + spin(w));
    }
};

/// Moving by itself a body keeps its energy. One that turns fast, by a few degrees a step and more, would gain some by
/// a step that looks ahead, and run away; by what it is to be slowed, 1 where it gains less than a hundredth.
inline Pack kept_of_motion(const Carrier& of, const V3& v, const V3& w, double time_step) {
    constexpr double most_gain = 1e-2;
    const V3 momentum = of.momentum(v, w) + v * of.mass_of_ice;
    V3 faster, spinning;
    of.accelerate(cross(momentum, w), cross(of.moment(v, w) + of.spin(w), w) + cross(momentum, v), faster, spinning);
    const Pack step = Pack{} + time_step;
    const Pack before = of.energy(v, w);
    const Pack after = of.energy(v + faster * step, w + spinning * step);
    return after > (1 + most_gain) * before ? square_root(before / after) : Pack{} + 1.0;
}

void carry_water(const LaneArrays& arrays, const double* carried, std::size_t groups, double time_step) {
    for (std::size_t i = 0; i < groups; ++i) {
        double* body = group_of(arrays.body, body_field::count, i);
        const Carrier of{group_of(carried, carried_field::count, i)};
        const M3 turn = load_matrix(body, body_field::rotation);
        const V3 v = transposed_times(turn, load3(body, body_field::velocity));
        const V3 w = transposed_times(turn, load3(body, body_field::angular_velocity));
        const V3 p = of.momentum(v, w);
        // Velocities change in world axes: those along the body's own change by as much less as these turn.
        const V3 turning = cross(w, v);
        const V3 force = transposed_times(turn, load3(body, body_field::force)) - cross(w, p) +
                         V3{of.in_plane * turning.x, of.normal * turning.y, of.in_plane * turning.z};
        const V3 torque = transposed_times(turn, load3(body, body_field::torque)) -
                          cross(w, of.moment(v, w) + of.spin(w)) - cross(v, p) +
                          V3{Pack{} - of.mz * turning.y, Pack{}, of.mx * turning.y};
        V3 faster, spinning;
        of.accelerate(force, torque, faster, spinning);
        const Pack step = Pack{} + time_step;
        const Pack kept = kept_of_motion(of, v, w, time_step);
        store3(body, body_field::start_velocity, (load3(body, body_field::velocity) + turn * (faster * step)) * kept);
        store3(body, body_field::start_angular_velocity,
               (load3(body, body_field::angular_velocity) + turn * (spinning * step)) * kept);
    }
}
