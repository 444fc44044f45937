// Rows of contacts, as btSequentialImpulseConstraintSolver 3.24 sets them up, in the lanes in which they are solved.

/// One body of each pair.
struct Touching {
    V3 position, start_velocity, start_angular_velocity, angular_velocity;
    S3 inverse_inertia;
    Pack inverse_mass;
};

/// `count` neighbouring fields of the slots of an array.
template <int count>
inline void pick(const double* array, int fields, int first, const std::uint32_t* slots, Pack (&to)[count]) {
    alignas(Pack) double values[count][lanes];
    for (int lane = 0; lane < lanes; ++lane) {
        const double* from = group_of(array, fields, slots[lane] / lanes) + first * lanes + slots[lane] % lanes;
        for (int i = 0; i < count; ++i) values[i][lane] = from[i * lanes];
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
    return {pick3(arrays, body_field::position, slots),
            pick3(arrays, body_field::start_velocity, slots),
            pick3(arrays, body_field::start_angular_velocity, slots),
            pick3(arrays, body_field::angular_velocity, slots),
            {m[0], m[1], m[2], m[3], m[4], m[5]},
            m[6]};
}

/// A unit impulse along `axis`: its torques, and the angular velocities that these cause.
struct Arm {
    V3 axis, torque_a, torque_b, angular_change_a, angular_change_b;
};

inline Arm make_arm(const V3& axis, const V3& lever_a, const V3& lever_b, const Touching& a, const Touching& b) {
    const V3 torque_a = cross(lever_a, axis);
    const V3 torque_b = cross(lever_b, axis);
    return {axis, torque_a, torque_b, a.inverse_inertia * torque_a, b.inverse_inertia * torque_b};
}

/// Velocity change along one by a unit impulse along the other, through angular velocity.
inline Pack coupling(const Arm& one, const Arm& other) {
    return dot(one.torque_a, other.angular_change_a) + dot(one.torque_b, other.angular_change_b);
}

inline void store_row(double* row, const Arm& arm, Pack s) {
    store3(row, contact_field::axis, arm.axis * s);
    store3(row, contact_field::angular_change_a, arm.angular_change_a * s);
    store3(row, contact_field::angular_change_b, arm.angular_change_b * s);
}

/// A row by itself, along `axis` at the given levers. Returns its scale s = A^-1/2.
inline Pack make_row(double* row, const V3& axis, const V3& lever_a, const V3& lever_b, const Touching& a,
                     const Touching& b) {
    const Arm arm = make_arm(axis, lever_a, lever_b, a, b);
    const Pack s = 1.0 / square_root(a.inverse_mass + b.inverse_mass + coupling(arm, arm));
    store_row(row, arm, s);
    store3(row, single_field::torque_a, arm.torque_a * s);
    store3(row, single_field::torque_b, arm.torque_b * s);
    return s;
}

/// Bullet's btPlaneSpace1: some direction at right angles to the unit vector n.
inline V3 any_tangent(const V3& n) {
    constexpr double edge = 0.7071067811865475244008443621048490;
    const Pack none{};
    const auto upright = absolute(n.z) > edge;
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

/// Two directions at right angles in the contact plane. They follow from the normal alone (Duff et al. 2017, Building
/// an orthonormal basis, revisited): what is carried from step to step is a vector in world axes.
struct TangentPlane {
    V3 first, second;
};

inline TangentPlane tangents(const V3& n) {
    const Pack none{};
    const Pack sign = n.z < 0.0 ? none - 1.0 : none + 1.0;
    const Pack k = -1.0 / (sign + n.z);
    const Pack xy = n.x * n.y * k;
    return {{1.0 + sign * n.x * n.x * k, sign * xy, -sign * n.x}, {xy, sign + n.y * n.y * k, -n.y}};
}

/// The larger eigenvalue of the 2 x 2 block of two friction rows, `mass` added to both.
inline Pack stiffest_direction(Pack mass, Pack one_one, Pack two_two, Pack one_two) {
    const Pack half = 0.5 * (one_one - two_two);
    return mass + 0.5 * (one_one + two_two) + square_root(half * half + one_two * one_two);
}

/// The impulses that two friction rows start from, over their scale: `start`, in world axes, brought into the cone.
inline void start_friction(double* first, double* second, int i, const TangentPlane& plane, const V3& start, Pack bound,
                           Pack scale) {
    const Pack along_first = dot(plane.first, start);
    const Pack along_second = dot(plane.second, start);
    const Pack held = in_circle(along_first, along_second, bound);
    store(first, i, along_first * held / scale);
    store(second, i, along_second * held / scale);
}

/// The two rows of the cone, which stop `velocity`, and their impulses to start from. The scale is that of the stiffest
/// direction in the plane, which keeps the sweeps stable.
inline void prepare_cone(const FrictionArrays& frictions, int i, const V3& n, const V3& velocity, const V3& lever_a,
                         const V3& lever_b, const Touching& a, const Touching& b, Pack friction, Pack normal_impulse,
                         Pack normal_scale) {
    const TangentPlane plane = tangents(n);
    const Arm first = make_arm(plane.first, lever_a, lever_b, a, b);
    const Arm second = make_arm(plane.second, lever_a, lever_b, a, b);
    const Pack stiffest = stiffest_direction(a.inverse_mass + b.inverse_mass, coupling(first, first),
                                             coupling(second, second), coupling(first, second));
    const Pack s = 1.0 / square_root(stiffest);

    const std::size_t row = static_cast<std::size_t>(i) * (contact_field::count * lanes);
    store_row(frictions.first.row + row, first, s);
    store_row(frictions.second.row + row, second, s);
    const Arm normal = make_arm(n, lever_a, lever_b, a, b);
    store(frictions.second.row + row, cone_second_field::coupling, coupling(normal, first) * (normal_scale * s));
    store(frictions.second.row + row, cone_second_field::coupling + 1, coupling(normal, second) * (normal_scale * s));
    store3(frictions.first.row + row, cone_first_field::lever_a, lever_a);
    store3(frictions.first.row + row, cone_first_field::lever_b, lever_b);
    store(frictions.first.row + row, cone_first_field::friction_coefficient, friction * normal_scale / s);
    store(frictions.first.target, i, -dot(first.axis, velocity) * s);
    store(frictions.second.target, i, -dot(second.axis, velocity) * s);
    start_friction(frictions.first.impulse, frictions.second.impulse, i, plane, load3(frictions.start, 3 * i),
                   friction * normal_impulse, s);
}

/// Row i of all kinds.
template <Friction law>
inline void prepare_contact(const double* point, int i, const Touching& a, const Touching& b,
                            const ContactRowArrays& normals, const FrictionArrays& frictions, double* split_target,
                            const ContactStep& step) {
    const std::size_t row = static_cast<std::size_t>(i) * (contact_field::count * lanes);
    const V3 direction = load3(point, point_field::normal);
    const Pack distance = load(point, point_field::distance);
    const V3 lever_a = load3(point, point_field::on_a) - a.position;
    const V3 lever_b = load3(point, point_field::on_b) - b.position;
    const V3 velocity = (a.start_velocity + cross(a.start_angular_velocity, lever_a)) -
                        (b.start_velocity + cross(b.start_angular_velocity, lever_b));
    const Pack approach = dot(direction, velocity);
    const Pack none{};
    const Pack never = none - __builtin_inf();

    // A gap may close within the step; a penetration is opened by erp, deep ones outside the impulse.
    const auto apart = distance > 0.0;
    const Pack stop = apart ? -approach - distance * step.inverse_step : -approach;
    const Pack correction = apart ? none : -distance * step.erp * step.inverse_step;
    const auto split = distance <= -step.split_depth;
    const Pack s = make_row(normals.row + row, direction, lever_a, lever_b, a, b);
    store(normals.target, i, (split ? stop : stop + correction) * s);
    store(normals.impulse, i, load(point, point_field::impulse) / s);
    store(normals.scale, i, s);
    store(split_target, i, split ? (correction > 0.0 ? correction * s : never) : never);

    const Pack friction = load(point, point_field::friction);
    if constexpr (law == Friction::cone) {
        const Pack impulse = load(point, point_field::impulse);
        prepare_cone(frictions, i, direction, velocity, lever_a, lever_b, a, b, friction, impulse, s);
        return;
    }
    // As in Bullet, the sliding velocity that the row stops does not contain the torque of this step.
    const V3 slide = slide_direction(velocity, direction);
    const Pack t = make_row(frictions.first.row + row, slide, lever_a, lever_b, a, b);
    const V3 sliding = (a.start_velocity + cross(a.angular_velocity, lever_a)) -
                       (b.start_velocity + cross(b.angular_velocity, lever_b));
    store(frictions.first.row + row, single_field::friction_coefficient, friction * s / t);
    store(frictions.first.target, i, -dot(slide, sliding) * t);
    store(frictions.first.impulse, i, none);
    store(frictions.first.scale, i, t);
}

/// `prepare(pack, turn, slots of the bodies a, then b)` for every `lanes` pairs. An empty lane repeats the first pair,
/// so that it has no infinities, which would be slow.
template <class Prepare>
inline void for_each_pair(const ContactPacks& packs, const Prepare& prepare) {
    const std::uint32_t* slots = packs.slots;
    for (std::size_t k = 0; k < packs.count; ++k) {
        for (std::uint32_t turn = 0; turn < packs.packs[k].turns; ++turn, slots += 2 * lanes) {
            std::uint32_t real[2 * lanes];
            for (int i = 0; i < 2 * lanes; ++i) real[i] = slots[i] == packs.spare ? slots[i / lanes * lanes] : slots[i];
            prepare(packs.packs[k], turn, real);
        }
    }
}

template <Friction law>
void prepare_all(const LaneArrays& arrays, const ContactPacks& packs, const double* points,
                 const ContactRowArrays& normals, const FrictionArrays& frictions, double* split_target,
                 const ContactStep& step) {
    for_each_pair(packs, [&](const ContactPack& pack, std::uint32_t turn, const std::uint32_t* slots) {
        const Touching a = touching(arrays, slots);
        const Touching b = touching(arrays, slots + lanes);
        for (std::uint32_t row = pack.first_row + turn; row < pack.end_row; row += pack.turns) {
            prepare_contact<law>(points + static_cast<std::size_t>(row) * (point_field::count * lanes),
                                 static_cast<int>(row), a, b, normals, frictions, split_target, step);
        }
    });
}

void prepare_contacts(const LaneArrays& arrays, const ContactPacks& packs, const double* points,
                      const ContactRowArrays& normals, const FrictionArrays& frictions, double* split_target,
                      const ContactStep& step) {
    const auto prepare =
        step.friction == Friction::cone ? prepare_all<Friction::cone> : prepare_all<Friction::one_direction>;
    prepare(arrays, packs, points, normals, frictions, split_target, step);
}

// Upper bounds on the impulses of normal rows: the impulse at which ice crushes, and zero at faces inside the ice.
// docs/convergence.md has the law and its source.

/// One body of each pair, as far as crushing needs it.
struct Box {
    V3 half_extent, covered_above, covered_below;
    M3 turn;
};

/// Crushing pressure of the weaker of two bodies, Pa. `of_law`: that of bodies without a pressure of their own.
inline Pack crushing_pressure(const LaneArrays& arrays, const std::uint32_t* slots, double of_law) {
    Pack a[1], b[1];
    pick(arrays.body, body_field::count, body_field::crushing_pressure, slots, a);
    pick(arrays.body, body_field::count, body_field::crushing_pressure, slots + lanes, b);
    const Pack law = Pack{} + of_law;
    return least(a[0] > 0.0 ? a[0] : law, b[0] > 0.0 ? b[0] : law);
}

inline Box box_of(const LaneArrays& arrays, const std::uint32_t* slots) {
    Pack r[9];
    pick(arrays.body, body_field::count, body_field::rotation, slots, r);
    return {pick3(arrays, body_field::half_extent, slots),
            pick3(arrays, body_field::covered, slots),
            pick3(arrays, body_field::covered + 3, slots),
            {{r[0], r[3], r[6]}, {r[1], r[4], r[7]}, {r[2], r[5], r[8]}}};
}

/// Area that a plane cuts from a box at a depth below the box's first vertex, m², and what it gains per depth, m.
struct Section {
    Pack area, growth;
};

/// Least slope of one face against another, 0.01 mm in 1 m: flush faces reach their whole area within 2 µm.
inline constexpr double flattest = 1e-5;

/// Whether the face through which an outward direction leaves is covered by another element of the floe: such a face
/// is inside the ice.
inline auto leaves_through_covered_face(const Box& body, const V3& outward) {
    const V3 along = transposed_times(body.turn, outward);
    const V3 size = {absolute(along.x), absolute(along.y), absolute(along.z)};
    const Pack x = along.x > 0.0 ? body.covered_above.x : body.covered_below.x;
    const Pack y = along.y > 0.0 ? body.covered_above.y : body.covered_below.y;
    const Pack z = along.z > 0.0 ? body.covered_above.z : body.covered_below.z;
    const Pack of_others = size.y > size.z ? y : z;
    return (size.x > most(size.y, size.z) ? x : of_others) > 0.0;
}

/// The section of a box, exact for every direction: with c the cosines of the unit normal in the box's axes and e the
/// box's extents along the normal, A(d) = sum of +-(d - sums of e)²₊ / (2 c1 c2 c3) over the eight vertices. Past the
/// middle it stays as it is there. A body without extents is flat and unbounded: its section is infinite.
inline Section section(const Box& body, const V3& normal, Pack depth) {
    const Pack none{};
    const V3& half_extent = body.half_extent;
    const V3 along = transposed_times(body.turn, normal);
    const Pack floor = none + flattest;
    const V3 c = {most(absolute(along.x), floor), most(absolute(along.y), floor), most(absolute(along.z), floor)};
    const V3 e = {2.0 * half_extent.x * c.x, 2.0 * half_extent.y * c.y, 2.0 * half_extent.z * c.z};
    const Pack middle = 0.5 * (e.x + e.y + e.z);
    const Pack d = least(depth, middle);
    Pack squares = d * d;
    Pack firsts = d;
    const auto vertex = [&](Pack below, double sign) {
        const Pack over = most(d - below, none);
        squares = squares + sign * (over * over);
        firsts = firsts + sign * over;
    };
    vertex(e.x, -1.0);
    vertex(e.y, -1.0);
    vertex(e.z, -1.0);
    vertex(e.x + e.y, 1.0);
    vertex(e.x + e.z, 1.0);
    vertex(e.y + e.z, 1.0);
    const Pack k = 1.0 / (c.x * c.y * c.z);
    const auto flat = !(half_extent.x > 0.0);
    return {flat ? none + __builtin_inf() : most(0.5 * k * squares, none),
            flat || !(depth < middle) ? none : most(k * firsts, none)};
}

/// Least depth at which the growth of an edge's area is taken.
inline Pack just_touching(const Box& body) {
    return 2.0 * flattest * least(body.half_extent.x, least(body.half_extent.y, body.half_extent.z));
}

/// Whether a normal leaves through a face inside the ice.
inline auto is_internal(const V3& normal, const Box& a, const Box& b) {
    return leaves_through_covered_face(a, normal * (Pack{} - 1.0)) || leaves_through_covered_face(b, normal);
}

/// Upper bound of an impulse, scaled: yield + give * (impulse - relative velocity change).
struct Limit {
    Pack yield, give;
};

/// The force is F = p A, with A linear about the depth at the beginning of the step. The velocities that a solve
/// changes are those half a step before and half a step after that moment, because positions move with what it ends
/// with. So F is taken at the mean of the depths there, with the velocity change Δv depth - Δv Δt / 4: Newmark's
/// average acceleration, second order in Δt and stable at any. The area is the smaller of the two bodies' sections at
/// the point's own depth, of which each point that touches has an equal share: together their mean. `share` is
/// p Δt / points.
inline Limit crushing_limit(const V3& normal, const double* point, const Box& a, const Box& b, Pack share, Pack scale,
                            double time_step) {
    const Pack reached = -load(point, point_field::distance);
    // An edge that only just touches has no area yet, but a growth of area.
    const Pack depth = most(reached, most(just_touching(a), just_touching(b)));
    const Section of_a = section(a, normal, depth);
    const Section of_b = section(b, normal, depth);
    const auto smaller = of_a.area < of_b.area;
    const Pack area = smaller ? of_a.area : of_b.area;
    const Pack of_boxes = smaller ? of_a.growth : of_b.growth;
    const Pack given = load(point, point_field::section);
    const auto is_given = given >= 0.0;
    const Pack growth = is_given ? load(point, point_field::section_growth) : of_boxes;
    const Pack impulse = share * (is_given ? given : area + of_boxes * (reached - depth));
    const Pack k = share * growth * (0.25 * time_step) / (scale * scale);
    return {impulse / scale / (1.0 + k), k / (1.0 + k)};
}

template <NormalLaw law>
void prepare_all_limits(const LaneArrays& arrays, const ContactPacks& packs, const double* points,
                        const double* normal_scale, const LimitArrays& to, const ContactLaw& contact,
                        double time_step) {
    const Pack none{};
    const Pack one = none + 1.0;
    const auto point_of = [=](std::uint32_t row) {
        return points + static_cast<std::size_t>(row) * (point_field::count * lanes);
    };
    for_each_pair(packs, [&](const ContactPack& pack, std::uint32_t turn, const std::uint32_t* slots) {
        const Box a = box_of(arrays, slots);
        const Box b = box_of(arrays, slots + lanes);
        Pack touching = none;
        for (std::uint32_t row = pack.first_row + turn; row < pack.end_row; row += pack.turns) {
            const auto internal = is_internal(load3(point_of(row), point_field::normal), a, b);
            const Pack acts = contact.internal_edges ? one : internal ? none : one;
            store(to.give, static_cast<int>(row), acts);  // until the row has its limit
            touching = touching + (load(point_of(row), point_field::distance) < 0.0 ? acts : none);
        }
        const Pack share =
            crushing_pressure(arrays, slots, contact.crushing_pressure) * time_step / most(touching, one);
        for (std::uint32_t row = pack.first_row + turn; row < pack.end_row; row += pack.turns) {
            const int i = static_cast<int>(row);
            const double* point = point_of(row);
            Limit limit{none + __builtin_inf(), none};
            if constexpr (law == NormalLaw::crushing) {
                limit = crushing_limit(load3(point, point_field::normal), point, a, b, share, load(normal_scale, i),
                                       time_step);
            }
            const auto on = load(to.give, i) > 0.0;
            store(to.yield, i, on ? limit.yield : none);
            store(to.give, i, on ? limit.give : none);
        }
    });
}

void prepare_limits(const LaneArrays& arrays, const ContactPacks& packs, const double* points,
                    const double* normal_scale, const LimitArrays& to, const ContactLaw& law, double time_step) {
    const auto prepare = law.normal == NormalLaw::crushing ? prepare_all_limits<NormalLaw::crushing>
                                                           : prepare_all_limits<NormalLaw::rigid>;
    prepare(arrays, packs, points, normal_scale, to, law, time_step);
}
