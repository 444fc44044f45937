// Joints by Σ and Γ, in lanes: their rows, the sweeps over these, and the reactions.

// The arc functions of the joint error from exactly rounded operations, so that neither the lane width nor the maths
// library of the machine shows in a result. Coefficients: Cephes atan (S. Moshier), error below 2e-16 relative.

/// atan of |t| <= tan(π/8).
inline Pack arc_tangent_core(Pack t) {
    const Pack z = t * t;
    const Pack p =
        (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
         1.228866684490136173410e2) *
            z -
        6.485021904942025371773e1;
    const Pack q =
        ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2) * z +
         4.853903996359136964868e2) *
            z +
        1.945506571482613964425e2;
    return t + t * (z * p / q);
}

/// atan2(y, x) in [-π, π]; (0, 0) is not allowed.
inline Pack arc_tangent(Pack y, Pack x) {
    constexpr double quarter = 0.78539816339744830962;  // π/4
    constexpr double half = 1.57079632679489661923;
    constexpr double full = 3.14159265358979323846;
    const Pack zero = y * 0.0;
    const Pack up = absolute(y);
    const Pack across = absolute(x);
    const auto steep = up > across;
    const Pack small = steep ? across : up;
    const Pack large = steep ? up : across;
    const auto diagonal = small > 0.41421356237309503 * large;  // tan(π/8): atan t = π/4 + atan((t - 1) / (t + 1))
    const Pack numerator = diagonal ? small - large : small;
    const Pack denominator = diagonal ? small + large : large;
    Pack angle = arc_tangent_core(numerator / denominator) + (diagonal ? zero + quarter : zero);
    angle = steep ? half - angle : angle;
    angle = x < 0.0 ? full - angle : angle;
    return y < 0.0 ? -angle : angle;
}

/// asin, arguments beyond ±1 (rounding of a rotation matrix) taken as ±1.
inline Pack arc_sine(Pack s) {
    const Pack rest = (1.0 - s) * (1.0 + s);
    return arc_tangent(s, square_root(rest < 0.0 ? rest * 0.0 : rest));
}

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

/// `apart`: from the centre of a to that of b.
inline JointGeometry joint_geometry(const double* frame, const M3& turn_a, const M3& turn_b, const V3& apart) {
    const M3 in_a = turn_a * load_matrix(frame, frame_field::rotation_a);
    const M3 in_b = turn_b * load_matrix(frame, frame_field::rotation_b);
    JointGeometry g;
    g.lever_a = turn_a * load3(frame, frame_field::origin_a);
    g.lever_b = turn_b * load3(frame, frame_field::origin_b);
    // The difference of the centres first: it is small and exact where the positions are large.
    g.gap = transposed_times(in_a, apart + (g.lever_b - g.lever_a));
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
    const JointGeometry g =
        joint_geometry(frame, load_matrix(a, body_field::rotation), load_matrix(b, body_field::rotation),
                       load3(b, body_field::position) - load3(a, body_field::position));
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
    return group_of(array, fields, block.first_body_group + static_cast<std::size_t>(body));
}

inline double* joint_group(double* array, int fields, const LaneBlock& block, std::int32_t joint) {
    return group_of(array, fields, block.first_joint_group + static_cast<std::size_t>(joint));
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

// Sweeps over the joints' rows, and the joints' reactions.

/// A joint while its six rows are solved.
struct JointSolve {
    double* row;
    double* a;  ///< of `sweep`, like b
    double* b;
    V3 angular_change_a, angular_change_b;
    V3 relative;     ///< motion of a relative to b, of the kind that the three rows at hand act on
    Pack change[3];  ///< of the impulses of these rows
    V3 push;         ///< what they exert together
};

[[gnu::always_inline]] inline void start_joint(JointSolve& joint) {
    joint.angular_change_a = load3(joint.a, sweep_field::angular_velocity);
    joint.angular_change_b = load3(joint.b, sweep_field::angular_velocity);
    joint.relative = joint.angular_change_a - joint.angular_change_b;
}

/// Row first + i. The coupling gives it the velocity changes by the rows from `first` on.
template <int first, int i>
[[gnu::always_inline]] inline void solve_row(JointSolve& joint) {
    const Pack old = load(joint.row, row_field::impulse + first + i);
    Pack change = (load(joint.row, row_field::target + first + i) - old * load(joint.row, row_field::cfm)) -
                  dot(load3(joint.row, row_field::axis + 3 * (first + i)), joint.relative);
    for (int before = 0; before < i; ++before) {
        const int coupling = row_field::coupling + first + i * (i - 1) / 2 + before;
        change = change - load(joint.row, coupling) * joint.change[before];
    }
    joint.change[i] = change;
    store(joint.row, row_field::impulse + first + i, old + change);
}

template <int first>
[[gnu::always_inline]] inline void add_rows(JointSolve& joint) {
    joint.push = load3(joint.row, row_field::axis + 3 * first) * joint.change[0] +
                 load3(joint.row, row_field::axis + 3 * first + 3) * joint.change[1] +
                 load3(joint.row, row_field::axis + 3 * first + 6) * joint.change[2];
}

[[gnu::always_inline]] inline void turn_bodies(JointSolve& joint) {
    joint.angular_change_a =
        joint.angular_change_a + load_symmetric(joint.a, sweep_field::inverse_inertia) * joint.push;
    joint.angular_change_b =
        joint.angular_change_b - load_symmetric(joint.b, sweep_field::inverse_inertia) * joint.push;
}

[[gnu::always_inline]] inline void slide_pivots(JointSolve& joint) {
    const V3 lever_a = load3(joint.row, row_field::lever_a);
    const V3 lever_b = load3(joint.row, row_field::lever_b);
    joint.relative = (load3(joint.a, sweep_field::velocity) - load3(joint.b, sweep_field::velocity)) +
                     (cross(joint.angular_change_a, lever_a) - cross(joint.angular_change_b, lever_b));
}

[[gnu::always_inline]] inline void push_bodies(JointSolve& joint) {
    const V3 push_a = joint.push * load(joint.a, sweep_field::inverse_mass);
    const V3 push_b = joint.push * load(joint.b, sweep_field::inverse_mass);
    store3(joint.a, sweep_field::velocity, load3(joint.a, sweep_field::velocity) + push_a);
    store3(joint.b, sweep_field::velocity, load3(joint.b, sweep_field::velocity) - push_b);
}

[[gnu::always_inline]] inline void twist_bodies(JointSolve& joint) {
    const V3 couple_a = cross(load3(joint.row, row_field::lever_a), joint.push);
    const V3 couple_b = cross(load3(joint.row, row_field::lever_b), joint.push);
    const S3 inertia_a = load_symmetric(joint.a, sweep_field::inverse_inertia);
    const S3 inertia_b = load_symmetric(joint.b, sweep_field::inverse_inertia);
    store3(joint.a, sweep_field::angular_velocity, joint.angular_change_a + inertia_a * couple_a);
    store3(joint.b, sweep_field::angular_velocity, joint.angular_change_b - inertia_b * couple_b);
}

template <auto stage, int n>
[[gnu::always_inline]] inline void in_turns(JointSolve (&joints)[n]) {
#pragma GCC unroll 2
    for (int i = 0; i < n; ++i) stage(joints[i]);
}

/// Joints that share no body, stage by stage in turns: the latency of one joint's stage is filled with that of another,
/// which must be close by for out-of-order execution.
template <int n>
[[gnu::always_inline]] inline void solve_joints(JointSolve (&joints)[n]) {
    in_turns<start_joint>(joints);
    in_turns<solve_row<0, 0>>(joints);
    in_turns<solve_row<0, 1>>(joints);
    in_turns<solve_row<0, 2>>(joints);
    in_turns<add_rows<0>>(joints);
    in_turns<turn_bodies>(joints);
    in_turns<slide_pivots>(joints);
    in_turns<solve_row<3, 0>>(joints);
    in_turns<solve_row<3, 1>>(joints);
    in_turns<solve_row<3, 2>>(joints);
    in_turns<add_rows<3>>(joints);
    in_turns<push_bodies>(joints);
    in_turns<twist_bodies>(joints);
}

inline JointSolve joint_of(const LaneArrays& arrays, const LaneBlock& block, std::int32_t j) {
    JointSolve joint;
    joint.row = joint_group(arrays.row, row_field::count, block, j);
    joint.a = body_group(arrays.sweep, sweep_field::count, block, block.pairs[2 * j]);
    joint.b = body_group(arrays.sweep, sweep_field::count, block, block.pairs[2 * j + 1]);
    return joint;
}

[[gnu::always_inline]] inline void sweep_rest(const LaneArrays& arrays, const LaneBlock& block, std::int32_t from) {
    for (std::int32_t j = from; j < block.joints; ++j) {
        JointSolve alone[] = {joint_of(arrays, block, j)};
        solve_joints(alone);
    }
}

/// Joint by joint, two blocks at a time.
void sweep(const LaneArrays& arrays, const LaneBlock* blocks, std::size_t count, int sweeps) {
    for (int k = 0; k < sweeps; ++k) {
        for (std::size_t i = 0; i < count; i += 2) {
            const LaneBlock& first = blocks[i];
            if (i + 1 == count) {
                sweep_rest(arrays, first, 0);
                continue;
            }
            const LaneBlock& second = blocks[i + 1];
            const std::int32_t paired = first.joints < second.joints ? first.joints : second.joints;
            for (std::int32_t j = 0; j < paired; ++j) {
                JointSolve both[] = {joint_of(arrays, first, j), joint_of(arrays, second, j)};
                solve_joints(both);
            }
            sweep_rest(arrays, first, paired);
            sweep_rest(arrays, second, paired);
        }
    }
}

void reactions(const LaneArrays& arrays, const LaneBlock& block, double time_step) {
    for (std::int32_t j = 0; j < block.joints; ++j) {
        const double* row = joint_group(arrays.row, row_field::count, block, j);
        double* reaction = joint_group(arrays.reaction, reaction_field::count, block, j);
        V3 couple = load3(row, row_field::axis) * load(row, row_field::impulse);
        couple = couple + load3(row, row_field::axis + 3) * load(row, row_field::impulse + 1);
        couple = couple + load3(row, row_field::axis + 6) * load(row, row_field::impulse + 2);
        for (int i = 0; i < 3; ++i) {
            const Pack s = load(reaction, reaction_field::scale + i);
            const Pack along = dot(load3(row, row_field::axis + 9 + 3 * i), couple) / (s * time_step);
            store(reaction, reaction_field::force + i, load(row, row_field::impulse + 3 + i) * s / time_step);
            store(reaction, reaction_field::moment + i, s > 0.0 ? along : s * 0.0);
        }
    }
}
