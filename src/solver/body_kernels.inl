// Bodies before the joints: btSequentialImpulseConstraintSolver::convertBodies with the implicit gyroscopic term in
// body axes (Bullet's default), in lanes.

/// x of m x = f by Cramer's rule.
inline V3 solve3(const M3& m, const V3& f) {
    const V3 yz = cross(m.y, m.z);
    const Pack inverse = 1.0 / dot(m.x, yz);
    return {dot(f, yz) * inverse, dot(m.x, cross(f, m.z)) * inverse, dot(m.x, cross(m.y, f)) * inverse};
}

/// Change of spin by the gyroscopic term in one step: one Newton step of the implicit Euler equation in body axes.
inline V3 gyroscopic_change(const M3& turn, const V3& spin, const V3& inertia, double time_step) {
    const V3 w = transposed_times(turn, spin);
    const V3 momentum = {inertia.x * w.x, inertia.y * w.y, inertia.z * w.z};
    const V3 residual = cross(w, momentum) * (w.x * 0.0 + time_step);
    const M3 jacobian = {
        {inertia.x, (w.z * inertia.x - momentum.z) * time_step, (momentum.y - w.y * inertia.x) * time_step},
        {(momentum.z - w.z * inertia.y) * time_step, inertia.y, (w.x * inertia.y - momentum.x) * time_step},
        {(w.y * inertia.z - momentum.y) * time_step, (momentum.x - w.x * inertia.z) * time_step, inertia.z}};
    return turn * (w - solve3(jacobian, residual)) - spin;
}

void prepare_bodies(const LaneArrays& arrays, std::size_t groups, double time_step) {
    for (std::size_t i = 0; i < groups; ++i) {
        double* body = arrays.body + i * static_cast<std::size_t>(body_field::count * lanes);
        double* sweeping = arrays.sweep + i * static_cast<std::size_t>(sweep_field::count * lanes);
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

        const V3 spin = load3(body, body_field::spin);
        const V3 principal = {moves ? 1.0 / inverse.x : zero, moves ? 1.0 / inverse.y : zero,
                              moves ? 1.0 / inverse.z : zero};
        const V3 gyroscopic = gyroscopic_change(turn, spin, principal, time_step);
        const V3 turned = {moves ? gyroscopic.x : zero, moves ? gyroscopic.y : zero, moves ? gyroscopic.z : zero};
        const V3 torque = inertia * load3(body, body_field::torque);
        store3(body, body_field::start_spin, spin + (torque * (zero + time_step) + turned));
        store3(body, body_field::start_velocity,
               load3(body, body_field::velocity) + load3(body, body_field::force) * (inverse_mass * time_step));
        store3(sweeping, sweep_field::velocity, {zero, zero, zero});
        store3(sweeping, sweep_field::spin, {zero, zero, zero});
    }
}

/// Rows become columns, in log2(lanes) exchanges: of neighbours, of neighbouring pairs, of neighbouring fours.
template <int stride, int... lane>
inline void exchange(Pack& a, Pack& b, Sequence<lane...>) {
    const Pack first = __builtin_shufflevector(a, b, ((lane & stride) != 0 ? lane - stride + lanes : lane)...);
    b = __builtin_shufflevector(a, b, ((lane & stride) != 0 ? lane + lanes : lane + stride)...);
    a = first;
}

template <int stride>
inline void transpose(Pack (&rows)[lanes]) {
    if constexpr (stride < lanes) {
#pragma GCC unroll 8
        for (int i = 0; i < lanes; ++i) {
            if ((i & stride) == 0) exchange<stride>(rows[i], rows[i + stride], EveryLane{});
        }
        transpose<2 * stride>(rows);
    }
}

/// Place in `sweep` of the k-th of the 8 doubles that contacts see of a body; -1 for the two that are always 0.
inline constexpr int sweep_place[8] = {sweep_field::velocity, sweep_field::velocity + 1, sweep_field::velocity + 2, -1,
                                       sweep_field::spin,     sweep_field::spin + 1,     sweep_field::spin + 2,     -1};

void to_contacts(const LaneArrays& arrays, const LaneBlock& block) {
    for (std::int32_t body = 0; body < block.bodies; ++body) {
        const double* from = body_group(arrays.sweep, sweep_field::count, block, body);
        double* to = body_group(arrays.delta, 8, block, body);
#pragma GCC unroll 8
        for (int part = 0; part < 8; part += lanes) {
            Pack rows[lanes];
#pragma GCC unroll 8
            for (int i = 0; i < lanes; ++i) {
                const int place = sweep_place[part + i];
                rows[i] = place < 0 ? load(from, 0) * 0.0 : load(from, place);
            }
            transpose<1>(rows);
#pragma GCC unroll 8
            for (int lane = 0; lane < lanes; ++lane) *reinterpret_cast<Pack*>(to + 8 * lane + part) = rows[lane];
        }
    }
}

void from_contacts(const LaneArrays& arrays, const LaneBlock& block) {
    for (std::int32_t body = 0; body < block.bodies; ++body) {
        const double* from = body_group(arrays.delta, 8, block, body);
        double* to = body_group(arrays.sweep, sweep_field::count, block, body);
#pragma GCC unroll 8
        for (int part = 0; part < 8; part += lanes) {
            Pack rows[lanes];
#pragma GCC unroll 8
            for (int lane = 0; lane < lanes; ++lane) {
                rows[lane] = *reinterpret_cast<const Pack*>(from + 8 * lane + part);
            }
            transpose<1>(rows);
#pragma GCC unroll 8
            for (int i = 0; i < lanes; ++i) {
                if (sweep_place[part + i] >= 0) store(to, sweep_place[part + i], rows[i]);
            }
        }
    }
}
