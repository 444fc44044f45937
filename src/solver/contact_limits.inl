// Upper bounds on the impulses of normal rows: the impulse at which ice crushes, and zero at faces inside the ice.
// docs/contact.md has the law and its source.

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
/// middle it stays at its largest. A body without extents is flat and unbounded: its section is infinite.
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
/// average acceleration, second order in Δt and stable at any. The area is the smaller of the two bodies' sections, in
/// equal shares for the points that touch. `share` is p Δt / points.
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
    const auto is_given = given > -0.5;
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
