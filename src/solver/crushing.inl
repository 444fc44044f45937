// Edges that crush: the normal impulse at which ice yields, for the rows of contact_setup.inl. docs/contact.md has the
// law and its source.

/// One body of each pair, as far as crushing needs it.
struct Block {
    V3 half_extent;
    M3 turn;
};

inline Block block(const LaneArrays& arrays, const std::uint32_t* slots) {
    Pack r[9];
    pick(arrays.body, body_field::count, body_field::rotation, slots, r);
    return {pick3(arrays, body_field::half_extent, slots),
            {{r[0], r[3], r[6]}, {r[1], r[4], r[7]}, {r[2], r[5], r[8]}}};
}

/// Area that a plane cuts from a box at a depth below the box's first vertex, m², and what it gains per depth, m.
struct Section {
    Pack area, growth;
};

inline Pack absolute(Pack x) {
    return x < 0.0 ? -x : x;
}

inline Pack least(Pack x, Pack y) {
    return x < y ? x : y;
}

inline Pack most(Pack x, Pack y) {
    return x > y ? x : y;
}

/// No face lies flatter on another than 0.01 mm in 1 m: a flush face has its whole area after 2 µm.
inline constexpr double flattest = 1e-5;

/// The section is exact for every direction: with c the cosines of the unit normal in the box's axes and e the box's
/// extents along the normal, A(d) = sum of +-(d - sums of e)²₊ / (2 c1 c2 c3) over the eight vertices. Past the middle
/// it stays at its largest. A body without extents is flat and unbounded: its section is infinite.
inline Section section(const Block& body, const V3& normal, Pack depth) {
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

/// Depth from which on an edge's area grows as it will: flattest of the body's least extent.
inline Pack just_touching(const Block& body) {
    return 2.0 * flattest * least(body.half_extent.x, least(body.half_extent.y, body.half_extent.z));
}

/// Upper bound of row i's impulse, both scaled: yield + give * (impulse - relative velocity change). The force is
/// F = p A, with A linear about the depth at the beginning of the step. The velocities that a solve changes are those
/// half a step before and half a step after that moment, because positions move with what it ends with. So F is taken
/// at the mean of the depths there, with the velocity change Δv depth - Δv Δt / 4: Newmark's average acceleration,
/// second order in Δt and stable at any. The area is the smaller of the two bodies' sections, in equal shares for the
/// points that touch.
inline void prepare_yield(const YieldArrays& to, int i, const double* point, const Block& a, const Block& b,
                          Pack points, Pack scale, double pressure, double time_step) {
    const V3 normal = load3(point, point_field::normal);
    const Pack reached = -load(point, point_field::distance);
    // An edge that only just touches has no area yet, but knows how its area will grow.
    const Pack depth = most(reached, most(just_touching(a), just_touching(b)));
    const Section of_a = section(a, normal, depth);
    const Section of_b = section(b, normal, depth);
    const auto smaller = of_a.area < of_b.area;
    const Pack area = smaller ? of_a.area : of_b.area;
    const Pack growth = smaller ? of_a.growth : of_b.growth;
    const Pack share = pressure * time_step / points;
    const Pack impulse = share * (area + growth * (reached - depth));
    const Pack k = share * growth * (0.25 * time_step) / (scale * scale);
    store(to.yield, i, impulse / scale / (1.0 + k));
    store(to.give, i, k / (1.0 + k));
}

void prepare_crushing(const LaneArrays& arrays, const ContactPacks& packs, const double* points,
                      const double* normal_scale, const YieldArrays& to, double pressure, double time_step) {
    const auto point_of = [=](std::uint32_t row) {
        return points + static_cast<std::size_t>(row) * (point_field::count * lanes);
    };
    const Pack one = Pack{} + 1.0;
    for_each_pair(packs, [&](const ContactPack& pack, std::uint32_t turn, const std::uint32_t* slots) {
        const Block a = block(arrays, slots);
        const Block b = block(arrays, slots + lanes);
        Pack touching{};
        for (std::uint32_t row = pack.first_row + turn; row < pack.end_row; row += pack.turns) {
            touching = touching + (load(point_of(row), point_field::distance) < 0.0 ? one : Pack{});
        }
        for (std::uint32_t row = pack.first_row + turn; row < pack.end_row; row += pack.turns) {
            const int i = static_cast<int>(row);
            prepare_yield(to, i, point_of(row), a, b, most(touching, one), load(normal_scale, i), pressure, time_step);
        }
    });
}
