// Contact rows in lanes. No two pairs of a pack share a moving body, so its lanes are independent. The motion of a pair
// is loaded once for all its contact points.

/// Relative velocity change along the scaled rows.
[[gnu::always_inline]] inline Pack along(const double* row, const Motion& a, const Motion& b) {
    const V3 axis = load3(row, contact_field::axis);
    const V3 torque_a = load3(row, single_field::torque_a);
    const V3 torque_b = load3(row, single_field::torque_b);
    const V3 sliding = a.velocity - b.velocity;
    const Pack x = axis.x * sliding.x + (torque_a.x * a.angular_velocity.x - torque_b.x * b.angular_velocity.x);
    const Pack y = axis.y * sliding.y + (torque_a.y * a.angular_velocity.y - torque_b.y * b.angular_velocity.y);
    const Pack z = axis.z * sliding.z + (torque_a.z * a.angular_velocity.z - torque_b.z * b.angular_velocity.z);
    return (x + z) + y;
}

[[gnu::always_inline]] inline void push(const double* row, Motion& a, Motion& b, Pack impulse) {
    const V3 axis = load3(row, contact_field::axis);
    a.velocity = a.velocity + axis * (a.inverse_mass * impulse);
    a.angular_velocity = a.angular_velocity + load3(row, contact_field::angular_change_a) * impulse;
    b.velocity = b.velocity - axis * (b.inverse_mass * impulse);
    b.angular_velocity = b.angular_velocity - load3(row, contact_field::angular_change_b) * impulse;
}

/// Packs whose rows are interleaved: the latency of one row's sum is filled with the row of another pack, which is too
/// far away for out-of-order execution. The motion of two packs takes 24 vectors; only AVX-512 has the registers.
inline constexpr int turns = lanes == 8 ? 2 : 1;

/// `solve(row number, row, a, b)` for every row of a pack.
template <int at_once, class Solve>
[[gnu::always_inline]] inline void for_each_row(double* delta, const ContactPack& pack, const std::uint32_t* slots,
                                                const double* rows, const Solve& solve) {
    const auto body = [=](int i) { return delta + 8 * static_cast<std::size_t>(slots[i]); };
    Motion a[at_once], b[at_once];
#pragma GCC unroll 2
    for (int turn = 0; turn < at_once; ++turn) {
        a[turn] = gather([=](int lane) { return body(2 * turn * lanes + lane); });
        b[turn] = gather([=](int lane) { return body((2 * turn + 1) * lanes + lane); });
    }
    for (std::uint32_t row = pack.first_row; row < pack.end_row; row += at_once) {
#pragma GCC unroll 2
        for (int turn = 0; turn < at_once; ++turn) {
            const int i = static_cast<int>(row) + turn;
            solve(i, rows + static_cast<std::size_t>(i) * (contact_field::count * lanes), a[turn], b[turn]);
        }
    }
    // A fixed body may be in several lanes, which all write its zeros back.
#pragma GCC unroll 2
    for (int turn = 0; turn < at_once; ++turn) {
        scatter([=](int lane) { return body(2 * turn * lanes + lane); }, a[turn]);
        scatter([=](int lane) { return body((2 * turn + 1) * lanes + lane); }, b[turn]);
    }
}

/// For all packs, except those for which `idle(pack)` holds.
template <class Solve, class Idle>
[[gnu::always_inline]] inline void for_each_row(double* delta, const ContactPacks& packs, const double* rows,
                                                const Solve& solve, const Idle& idle) {
    const std::uint32_t* slots = packs.slots;
    for (std::size_t i = 0; i < packs.count; ++i) {
        const ContactPack& pack = packs.packs[i];
        if (!idle(pack)) {
            if (pack.turns == turns) {
                for_each_row<turns>(delta, pack, slots, rows, solve);
            } else {
                for_each_row<1>(delta, pack, slots, rows, solve);
            }
        }
        slots += 2 * lanes * pack.turns;
    }
}

inline bool never_idle(const ContactPack&) {
    return false;
}

/// Applies the impulses that rows start from.
void start_contacts(double* delta, const ContactPacks& packs, const ContactRowArrays& all) {
    const auto start = [&](int i, const double* row, Motion& a, Motion& b) { push(row, a, b, load(all.impulse, i)); };
    for_each_row(delta, packs, all.row, start, never_idle);
}

// The applied impulse is the difference of the accumulated ones, clamped or not: no branch, and the same rounding.

template <bool limited>
void solve_all_normals(double* delta, const ContactPacks& packs, const ContactRowArrays& all,
                       const LimitArrays& limits) {
    const auto solve = [&](int i, const double* row, Motion& a, Motion& b) __attribute__((always_inline)) {
        const Pack old = load(all.impulse, i);
        const Pack next = normal_impulse<limited>(all.target, limits, i, old, along(row, a, b));
        store(all.impulse, i, next);
        push(row, a, b, next - old);
    };
    for_each_row(delta, packs, all.row, solve, never_idle);
}

void solve_normals(double* delta, const ContactPacks& packs, const ContactRowArrays& all, const LimitArrays& limits) {
    const auto solve = limits.yield == nullptr ? solve_all_normals<false> : solve_all_normals<true>;
    solve(delta, packs, all, limits);
}

/// As in Bullet, friction keeps its impulse while the normal row has none.
void solve_frictions(double* delta, const ContactPacks& packs, const ContactRowArrays& all,
                     const double* normal_impulse) {
    const auto solve = [&](int i, const double* row, Motion& a, Motion& b) __attribute__((always_inline)) {
        const Pack normal = load(normal_impulse, i);
        const Pack bound = load(row, single_field::friction_coefficient) * normal;
        const Pack old = load(all.impulse, i);
        const Pack total = old + (load(all.target, i) - along(row, a, b));
        const Pack capped = total < bound ? total : bound;
        const Pack held = capped > -bound ? capped : -bound;
        const Pack next = normal > 0.0 ? held : old;
        store(all.impulse, i, next);
        push(row, a, b, next - old);
    };
    const auto idle = [=](const ContactPack& pack) {
        for (std::uint32_t i = pack.first_row; i < pack.end_row; ++i) {
            if (any_positive(load(normal_impulse, static_cast<int>(i)))) return false;
        }
        return true;
    };
    for_each_row(delta, packs, all.row, solve, idle);
}

/// One contact while its three rows are solved.
struct BodyContact {
    const double* row;
    const double* first;
    const double* second;
    Motion& a;
    Motion& b;
    V3 velocity{};  ///< of a relative to b where they touch
    V3 axis{}, first_axis{}, second_axis{};

    [[gnu::always_inline]] Pack approach() {
        velocity = (a.velocity - b.velocity) + (cross(a.angular_velocity, load3(first, cone_first_field::lever_a)) -
                                                cross(b.angular_velocity, load3(first, cone_first_field::lever_b)));
        axis = load3(row, contact_field::axis);
        return dot(axis, velocity);
    }

    [[gnu::always_inline]] Sliding sliding(Pack pressed) {
        first_axis = load3(first, contact_field::axis);
        second_axis = load3(second, contact_field::axis);
        return {dot(first_axis, velocity) + load(second, cone_second_field::coupling) * pressed,
                dot(second_axis, velocity) + load(second, cone_second_field::coupling + 1) * pressed};
    }

    [[gnu::always_inline]] Pack bound(Pack normal) const {
        return load(first, cone_first_field::friction_coefficient) * normal;
    }

    /// Rounded as push() without friction, which other lanes of a pack may need.
    [[gnu::always_inline]] void press(Pack pressed) const {
        const V3 impulse = axis * pressed;
        a.velocity = a.velocity + impulse * a.inverse_mass;
        b.velocity = b.velocity - impulse * b.inverse_mass;
        a.angular_velocity = a.angular_velocity + load3(row, contact_field::angular_change_a) * pressed;
        b.angular_velocity = b.angular_velocity - load3(row, contact_field::angular_change_b) * pressed;
    }

    [[gnu::always_inline]] void push(Pack pressed, Pack one, Pack two) const {
        const V3 impulse = axis * pressed + first_axis * one + second_axis * two;
        a.velocity = a.velocity + impulse * a.inverse_mass;
        b.velocity = b.velocity - impulse * b.inverse_mass;
        a.angular_velocity = a.angular_velocity + turned(contact_field::angular_change_a, pressed, one, two);
        b.angular_velocity = b.angular_velocity - turned(contact_field::angular_change_b, pressed, one, two);
    }

    [[gnu::always_inline]] V3 turned(int angular_change, Pack pressed, Pack one, Pack two) const {
        return load3(row, angular_change) * pressed + load3(first, angular_change) * one +
               load3(second, angular_change) * two;
    }
};

template <bool limited>
void solve_all_cones(double* delta, const ContactPacks& packs, const ContactRowArrays& normals,
                     const FrictionArrays& frictions, const LimitArrays& limits) {
    const ConeArrays all{{normals.target, frictions.first.target, frictions.second.target},
                         {normals.impulse, frictions.first.impulse, frictions.second.impulse}};
    const auto solve = [&](int i, const double* row, Motion& a, Motion& b) __attribute__((always_inline)) {
        const std::size_t at = static_cast<std::size_t>(i) * (contact_field::count * lanes);
        solve_cone<limited>(all, limits, i,
                            BodyContact{row, frictions.first.row + at, frictions.second.row + at, a, b});
    };
    for_each_row(delta, packs, normals.row, solve, never_idle);
}

void solve_cones(double* delta, const ContactPacks& packs, const ContactRowArrays& normals, const FrictionArrays& all,
                 const LimitArrays& limits) {
    const auto solve = limits.yield == nullptr ? solve_all_cones<false> : solve_all_cones<true>;
    solve(delta, packs, normals, all, limits);
}
