// Rows of contacts, as btSequentialImpulseConstraintSolver 3.24 sets them up, in the lanes in which they are solved.

/// One body of each pair.
struct Touching {
    V3 position, start_velocity, start_spin, spin;
    S3 inverse_inertia;
    Pack inverse_mass;
};

/// `count` neighbouring fields of the slots of an array.
template <int count>
inline void pick(const double* array, int fields, int first, const std::uint32_t* slots, Pack (&to)[count]) {
    alignas(Pack) double values[count][lanes];
    for (int lane = 0; lane < lanes; ++lane) {
        const double* group = array + slots[lane] / lanes * static_cast<std::size_t>(fields * lanes);
        for (int i = 0; i < count; ++i)
            values[i][lane] = group[(first + i) * lanes + static_cast<int>(slots[lane] % lanes)];
    }
    for (int i = 0; i < count; ++i) to[i] = load(values[i], 0);
}

inline V3 pick3(const LaneArrays& arrays, int first, const std::uint32_t* slots) {
    Pack v[3];
    pick(arrays.body, body_field::count, first, slots, v);
    return {v[0], v[1], v[2]};
}

inline Touching touching(const LaneArrays& arrays, const std::uint32_t* slots) {
    Pack m[7];
    static_assert(sweep_field::inverse_mass == sweep_field::inverse_inertia + 6);
    pick(arrays.sweep, sweep_field::count, sweep_field::inverse_inertia, slots, m);
    return {pick3(arrays, body_field::position, slots),   pick3(arrays, body_field::start_velocity, slots),
            pick3(arrays, body_field::start_spin, slots), pick3(arrays, body_field::spin, slots),
            {m[0], m[1], m[2], m[3], m[4], m[5]},         m[6]};
}

/// A row along `axis` at the given levers. Returns its scale s = A^-1/2.
inline Pack make_row(double* row, const V3& axis, const V3& lever_a, const V3& lever_b, const Touching& a,
                     const Touching& b) {
    const V3 torque_a = cross(lever_a, axis);
    const V3 torque_b = cross(lever_b, axis);
    const V3 spin_a = a.inverse_inertia * torque_a;
    const V3 spin_b = b.inverse_inertia * torque_b;
    const Pack s = 1.0 / square_root(a.inverse_mass + b.inverse_mass + (dot(torque_a, spin_a) + dot(torque_b, spin_b)));
    store3(row, contact_field::axis, axis * s);
    store3(row, contact_field::torque_a, torque_a * s);
    store3(row, contact_field::torque_b, torque_b * s);
    store3(row, contact_field::spin_a, spin_a * s);
    store3(row, contact_field::spin_b, spin_b * s);
    return s;
}

/// Bullet's btPlaneSpace1: some direction at right angles to the unit vector n.
inline V3 any_tangent(const V3& n) {
    constexpr double edge = 0.7071067811865475244008443621048490;
    const Pack none{};
    const auto upright = (n.z < 0.0 ? -n.z : n.z) > edge;
    const Pack k = 1.0 / square_root(upright ? n.y * n.y + n.z * n.z : n.x * n.x + n.y * n.y);
    return {upright ? none : -n.y * k, upright ? -n.z * k : n.x * k, upright ? n.y * k : none};
}

/// Unit vector of the sliding velocity; any tangent where nothing slides.
inline V3 slide_direction(const V3& velocity, const V3& normal) {
    constexpr double epsilon = 2.220446049250313e-16;  // as in Bullet, SIMD_EPSILON
    const V3 sliding = velocity - normal * dot(normal, velocity);
    const Pack square = dot(sliding, sliding);
    const V3 along = sliding * (1.0 / square_root(square));
    const V3 any = any_tangent(normal);
    const auto slides = square > epsilon;
    return {slides ? along.x : any.x, slides ? along.y : any.y, slides ? along.z : any.z};
}

/// Row i of both kinds.
inline void prepare_contact(const double* point, int i, const Touching& a, const Touching& b,
                            const ContactRowArrays& normals, const ContactRowArrays& frictions, double* split_target,
                            const ContactStep& step) {
    const std::size_t row = static_cast<std::size_t>(i) * (contact_field::count * lanes);
    const V3 direction = load3(point, point_field::normal);
    const Pack distance = load(point, point_field::distance);
    const V3 lever_a = load3(point, point_field::on_a) - a.position;
    const V3 lever_b = load3(point, point_field::on_b) - b.position;
    const V3 velocity =
        (a.start_velocity + cross(a.start_spin, lever_a)) - (b.start_velocity + cross(b.start_spin, lever_b));
    const Pack approach = dot(direction, velocity);
    const Pack none{};
    const Pack never = none - __builtin_inf();

    // A gap may close within the step; a penetration is opened by erp, deep ones outside the impulse.
    const auto apart = distance > 0.0;
    const Pack stop = apart ? -approach - distance * step.inverse_step : -approach;
    const Pack correction = apart ? none : -distance * step.law.erp * step.inverse_step;
    const auto split = distance <= -step.split_depth;
    const Pack s = make_row(normals.row + row, direction, lever_a, lever_b, a, b);
    store(normals.target, i, (split ? stop : stop + correction) * s);
    store(normals.impulse, i, load(point, point_field::impulse) / s);
    store(normals.scale, i, s);
    store(split_target, i, split ? (correction > 0.0 ? correction * s : never) : never);

    // Bullet leaves the torque of this step out of the sliding velocity that the row stops.
    const V3 slide = slide_direction(velocity, direction);
    const Pack t = make_row(frictions.row + row, slide, lever_a, lever_b, a, b);
    const V3 sliding = (a.start_velocity + cross(a.spin, lever_a)) - (b.start_velocity + cross(b.spin, lever_b));
    store(frictions.row + row, contact_field::grip, load(point, point_field::friction) * s / t);
    store(frictions.target, i, -dot(slide, sliding) * t);
    store(frictions.impulse, i, none);
    store(frictions.scale, i, t);
}

void prepare_contacts(const LaneArrays& arrays, const ContactPacks& packs, const double* points,
                      const ContactRowArrays& normals, const ContactRowArrays& frictions, double* split_target,
                      const ContactStep& step) {
    const std::uint32_t* slots = packs.slots;
    for (std::size_t k = 0; k < packs.count; ++k) {
        const ContactPack& pack = packs.packs[k];
        for (std::uint32_t turn = 0; turn < pack.turns; ++turn, slots += 2 * lanes) {
            // An empty lane is computed like the first one: nothing in it is infinite or slow.
            std::uint32_t real[2 * lanes];
            for (int i = 0; i < 2 * lanes; ++i) real[i] = slots[i] == packs.spare ? slots[i / lanes * lanes] : slots[i];
            const Touching a = touching(arrays, real);
            const Touching b = touching(arrays, real + lanes);
            for (std::uint32_t row = pack.first_row + turn; row < pack.end_row; row += pack.turns) {
                prepare_contact(points + static_cast<std::size_t>(row) * (point_field::count * lanes),
                                static_cast<int>(row), a, b, normals, frictions, split_target, step);
            }
        }
    }
}
