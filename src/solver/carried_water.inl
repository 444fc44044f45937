// Start velocities of bodies that carry water (carried_water.hpp): the force and torque of the step, the ice's
// gyroscopic term and what the moving water exerts, over the inertia of body and water together.

void carry_water(const LaneArrays& arrays, const double* carried, std::size_t groups, double time_step) {
    for (std::size_t i = 0; i < groups; ++i) {
        double* body = arrays.body + i * static_cast<std::size_t>(body_field::count * lanes);
        const double* water = carried + i * static_cast<std::size_t>(carried_field::count * lanes);
        const M3 turn = load_matrix(body, body_field::rotation);
        const V3 v = transposed_times(turn, load3(body, body_field::velocity));
        const V3 w = transposed_times(turn, load3(body, body_field::angular_velocity));
        const Pack in_plane = load(water, carried_field::in_plane);
        const Pack normal = load(water, carried_field::normal);
        const Pack mx = load(water, carried_field::x);
        const Pack mz = load(water, carried_field::z);
        const Pack xz = load(water, carried_field::xz);
        const V3 p = {in_plane * v.x, normal * v.y - mz * w.x + mx * w.z, in_plane * v.z};
        const V3 l = {load(water, carried_field::zz) * w.x - mz * v.y - xz * w.z, load(water, carried_field::yaw) * w.y,
                      mx * v.y - xz * w.x + load(water, carried_field::xx) * w.z};
        // Velocities change in world axes: those along the body's own change by as much less as these turn.
        const V3 turning = cross(w, v);
        const V3 ice = load3(water, carried_field::ice);
        const V3 spin = {ice.x * w.x, ice.y * w.y, ice.z * w.z};
        const V3 force = transposed_times(turn, load3(body, body_field::force)) - cross(w, p) +
                         V3{in_plane * turning.x, normal * turning.y, in_plane * turning.z};
        const V3 torque = transposed_times(turn, load3(body, body_field::torque)) - cross(w, l + spin) - cross(v, p) +
                          V3{Pack{} - mz * turning.y, Pack{}, mx * turning.y};

        const Pack inverse = load(water, carried_field::inverse_in_plane);
        const V3 out = load_symmetric(water, carried_field::inverse_out) * V3{force.y, torque.x, torque.z};
        const V3 faster = {inverse * force.x, out.x, inverse * force.z};
        const V3 spinning = {out.y, load(water, carried_field::inverse_yaw) * torque.y, out.z};
        const Pack step = Pack{} + time_step;
        store3(body, body_field::start_velocity, load3(body, body_field::velocity) + turn * (faster * step));
        store3(body, body_field::start_angular_velocity,
               load3(body, body_field::angular_velocity) + turn * (spinning * step));
    }
}
