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
