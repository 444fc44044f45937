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

void to_contacts(const LaneArrays& arrays, const LaneBlock& block) {
    for (std::int32_t body = 0; body < block.bodies; ++body) {
        const double* from = body_group(arrays.sweep, sweep_field::count, block, body);
        double* to = body_group(arrays.delta, 8, block, body);
        for (int lane = 0; lane < lanes; ++lane) {
            for (int i = 0; i < 3; ++i) {
                to[8 * lane + i] = from[(sweep_field::velocity + i) * lanes + lane];
                to[8 * lane + 4 + i] = from[(sweep_field::spin + i) * lanes + lane];
            }
        }
    }
}

void from_contacts(const LaneArrays& arrays, const LaneBlock& block) {
    for (std::int32_t body = 0; body < block.bodies; ++body) {
        const double* from = body_group(arrays.delta, 8, block, body);
        double* to = body_group(arrays.sweep, sweep_field::count, block, body);
        for (int lane = 0; lane < lanes; ++lane) {
            for (int i = 0; i < 3; ++i) {
                to[(sweep_field::velocity + i) * lanes + lane] = from[8 * lane + i];
                to[(sweep_field::spin + i) * lanes + lane] = from[8 * lane + 4 + i];
            }
        }
    }
}
