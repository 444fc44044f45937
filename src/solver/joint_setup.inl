// Six rows of a fixed joint, in lanes: btGeneric6DofSpring2Constraint locked in all six axes, as
// btSequentialImpulseConstraintSolver 3.24 sets it up and solves it, in the same order of rows.

/// The joint's error and its row axes as the Spring2 constraint has them.
struct JointGeometry {
    V3 angle;  ///< Euler XYZ of the frame in b relative to the frame in a
    V3 gap;    ///< of the pivots, in the frame in a
    V3 angular[3];
    V3 linear[3];
    V3 lever_a, lever_b;
};

inline JointGeometry joint_geometry(const double* frame, const double* a, const double* b) {
    const M3 turn_a = load_matrix(a, body_field::rotation);
    const M3 turn_b = load_matrix(b, body_field::rotation);
    const M3 in_a = turn_a * load_matrix(frame, frame_field::rotation_a);
    const M3 in_b = turn_b * load_matrix(frame, frame_field::rotation_b);
    JointGeometry g;
    g.lever_a = turn_a * load3(frame, frame_field::origin_a);
    g.lever_b = turn_b * load3(frame, frame_field::origin_b);
    // The difference of the centres first: it is small and exact where the positions are large.
    const V3 apart = (load3(b, body_field::position) - load3(a, body_field::position)) + (g.lever_b - g.lever_a);
    g.gap = transposed_times(in_a, apart);
    g.angle = {arc_tangent(-dot(in_a.z, in_b.y), dot(in_a.z, in_b.z)), arc_sine(dot(in_a.z, in_b.x)),
               arc_tangent(-dot(in_a.y, in_b.x), dot(in_a.x, in_b.x))};
    const V3 node = cross(in_a.z, in_b.x);
    g.angular[0] = unit(cross(node, in_a.z));
    g.angular[1] = unit(node);
    g.angular[2] = unit(cross(in_b.x, node));
    g.linear[0] = in_a.x;
    g.linear[1] = in_a.y;
    g.linear[2] = in_a.z;
    return g;
}

/// s = A^-1/2 of a row; 0, which switches the row off, where the joint is broken or both bodies are fixed.
inline Pack row_scale(Pack a, Pack alive) {
    const Pack s = 1.0 / square_root(a);
    const Pack off = alive * 0.0;
    return alive > 0.5 ? (a > 0.0 ? s : off) : off;
}

inline void prepare_joint(const double* frame, double* row, double* reaction, const double* a, const double* b,
                          const double* sweep_a, const double* sweep_b, double inverse_step) {
    const JointGeometry g = joint_geometry(frame, a, b);
    const Pack alive = load(frame, frame_field::alive);
    const Pack correction = load(frame, frame_field::erp) * inverse_step;
    const S3 inertia_a = load_symmetric(sweep_a, sweep_field::inverse_inertia);
    const S3 inertia_b = load_symmetric(sweep_b, sweep_field::inverse_inertia);
    const Pack mass = load(sweep_a, sweep_field::inverse_mass) + load(sweep_b, sweep_field::inverse_mass);
    const V3 angular_change_a = load3(a, body_field::start_angular_velocity);
    const V3 angular_change_b = load3(b, body_field::start_angular_velocity);
    const V3 turning = angular_change_a - angular_change_b;
    const V3 sliding = (load3(a, body_field::start_velocity) - load3(b, body_field::start_velocity)) +
                       (cross(angular_change_a, g.lever_a) - cross(angular_change_b, g.lever_b));
    const S3 inertia = inertia_a + inertia_b;
    const Pack angle[3] = {g.angle.x, g.angle.y, g.angle.z};
    const Pack gap[3] = {g.gap.x, g.gap.y, g.gap.z};

    V3 axis[3], compliance[3];
    for (int i = 0; i < 3; ++i) {
        const Pack s = row_scale(dot(g.angular[i], inertia * g.angular[i]), alive);
        axis[i] = g.angular[i] * s;
        compliance[i] = inertia * axis[i];
        store3(row, row_field::axis + 3 * i, axis[i]);
        store(row, row_field::target + i, (-(correction * angle[i]) - dot(g.angular[i], turning)) * s);
        store(row, row_field::impulse + i, s * 0.0);
    }
    store(row, row_field::coupling, dot(axis[1], compliance[0]));
    store(row, row_field::coupling + 1, dot(axis[2], compliance[0]));
    store(row, row_field::coupling + 2, dot(axis[2], compliance[1]));

    V3 torque_a[3], torque_b[3], response_a[3], response_b[3];
    for (int i = 0; i < 3; ++i) {
        const V3 arm_a = cross(g.lever_a, g.linear[i]);
        const V3 arm_b = cross(g.lever_b, g.linear[i]);
        const Pack s = row_scale(mass + dot(arm_a, inertia_a * arm_a) + dot(arm_b, inertia_b * arm_b), alive);
        torque_a[i] = arm_a * s;
        torque_b[i] = arm_b * s;
        response_a[i] = inertia_a * torque_a[i];
        response_b[i] = inertia_b * torque_b[i];
        store3(row, row_field::axis + 9 + 3 * i, g.linear[i] * s);
        store(row, row_field::target + 3 + i, (correction * gap[i] - dot(g.linear[i], sliding)) * s);
        store(row, row_field::impulse + 3 + i, s * 0.0);
        store(reaction, reaction_field::scale + i, s);
    }
    // The axes are at right angles, so masses do not couple the linear rows; levers do.
    store(row, row_field::coupling + 3, dot(torque_a[1], response_a[0]) + dot(torque_b[1], response_b[0]));
    store(row, row_field::coupling + 4, dot(torque_a[2], response_a[0]) + dot(torque_b[2], response_b[0]));
    store(row, row_field::coupling + 5, dot(torque_a[2], response_a[1]) + dot(torque_b[2], response_b[1]));
    store3(row, row_field::lever_a, g.lever_a);
    store3(row, row_field::lever_b, g.lever_b);
}

inline double* body_group(double* array, int fields, const LaneBlock& block, std::int32_t body) {
    return array + (block.first_body_group + static_cast<std::size_t>(body)) * static_cast<std::size_t>(fields * lanes);
}

inline double* joint_group(double* array, int fields, const LaneBlock& block, std::int32_t joint) {
    return array +
           (block.first_joint_group + static_cast<std::size_t>(joint)) * static_cast<std::size_t>(fields * lanes);
}

void prepare_joints(const LaneArrays& arrays, const LaneBlock& block, double time_step) {
    const double inverse_step = 1.0 / time_step;
    for (std::int32_t j = 0; j < block.joints; ++j) {
        const std::int32_t a = block.pairs[2 * j];
        const std::int32_t b = block.pairs[2 * j + 1];
        prepare_joint(joint_group(arrays.frame, frame_field::count, block, j),
                      joint_group(arrays.row, row_field::count, block, j),
                      joint_group(arrays.reaction, reaction_field::count, block, j),
                      body_group(arrays.body, body_field::count, block, a),
                      body_group(arrays.body, body_field::count, block, b),
                      body_group(arrays.sweep, sweep_field::count, block, a),
                      body_group(arrays.sweep, sweep_field::count, block, b), inverse_step);
    }
}
