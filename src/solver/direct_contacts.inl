// Contacts between pieces that move as a whole. A row has, for each of its two bodies, the impulse on it and the
// velocity change of that body; the other bodies of the piece are moved once per visit of the pair.

inline Flat load_flat(const double* row, int field) {
    return {load3(row, field), load3(row, field + 3)};
}

inline void store_flat(double* row, int field, const Flat& v) {
    store3(row, field, v.within);
    store3(row, field + 3, v.out);
}

inline Pack dot(const Flat& a, const Flat& b) {
    return dot(a.within, b.within) + dot(a.out, b.out);
}

inline Flat operator*(const Flat& a, Pack s) {
    return {a.within * s, a.out * s};
}

inline Flat operator+(const Flat& a, const Flat& b) {
    return {a.within + b.within, a.out + b.out};
}

inline Flat operator-(const Flat& a, const Flat& b) {
    return {a.within - b.within, a.out - b.out};
}

/// One body of each pair: its motion, the axes of its piece, and its own block of the piece's compliance.
struct CompliantBody {
    V3 position, start_velocity, start_angular_velocity;
    M3 frame;
    M3 within, out;  ///< its own Delassus block
};

inline CompliantBody compliant_body(const LaneArrays& arrays, const DirectArrays& direct,
                                    const ComplianceColumn* columns, const std::uint32_t* slots) {
    CompliantBody body;
    body.position = pick3(arrays, body_field::position, slots);
    body.start_velocity = pick3(arrays, body_field::start_velocity, slots);
    body.start_angular_velocity = pick3(arrays, body_field::start_angular_velocity, slots);
    body.frame = gather_frame(direct, slots);
    alignas(64) static constexpr double none[compliance_block]{};
    Flat column[3];
    for (int k = 0; k < 3; ++k) {
        column[k] = gather_flat([&](int lane) {
            const double* self = columns[slots[lane]].self;
            return (self == nullptr ? none : self) + 8 * k;
        });
    }
    body.within = {column[0].within, column[1].within, column[2].within};
    body.out = {column[0].out, column[1].out, column[2].out};
    return body;
}

/// Change of the body's own velocity by an impulse on it.
inline Flat moved_by(const CompliantBody& body, const Flat& impulse) {
    return {body.within * impulse.within, body.out * impulse.out};
}

/// A unit impulse along a direction: the impulse on each body, and the velocity changes of the two.
struct DirectArm {
    Flat on_a, on_b, moves_a, moves_b;
};

inline DirectArm direct_arm(const V3& axis, const V3& lever_a, const V3& lever_b, const CompliantBody& a,
                            const CompliantBody& b) {
    DirectArm arm;
    arm.on_a = flat(transposed_times(a.frame, axis), transposed_times(a.frame, cross(lever_a, axis)));
    arm.on_b = flat(transposed_times(b.frame, axis), transposed_times(b.frame, cross(lever_b, axis)));
    arm.moves_a = moved_by(a, arm.on_a);
    arm.moves_b = moved_by(b, arm.on_b);
    return arm;
}

inline Pack coupling(const DirectArm& one, const DirectArm& other) {
    return dot(one.on_a, other.moves_a) + dot(one.on_b, other.moves_b);
}

inline void store_arm(double* row, int i, const DirectArm& arm, Pack s) {
    store_flat(row, direct_field::on_a + 6 * i, arm.on_a * s);
    store_flat(row, direct_field::on_b + 6 * i, arm.on_b * s);
    store_flat(row, direct_field::moves_a + 6 * i, arm.moves_a * s);
    store_flat(row, direct_field::moves_b + 6 * i, arm.moves_b * s);
}

inline void prepare_direct_contact(const double* point, const double* friction_start, int i, const CompliantBody& a,
                                   const CompliantBody& b, const DirectRowArrays& to, const ContactStep& step) {
    double* row = to.row + static_cast<std::size_t>(i) * (direct_field::count * lanes);
    const V3 n = load3(point, point_field::normal);
    const Pack distance = load(point, point_field::distance);
    const V3 lever_a = load3(point, point_field::on_a) - a.position;
    const V3 lever_b = load3(point, point_field::on_b) - b.position;
    const V3 velocity = (a.start_velocity + cross(a.start_angular_velocity, lever_a)) -
                        (b.start_velocity + cross(b.start_angular_velocity, lever_b));
    const Pack approach = dot(n, velocity);
    // A gap may close within the step; a penetration is opened by erp.
    const auto apart = distance > 0.0;
    const Pack gap = apart ? -distance * step.inverse_step : -distance * step.erp * step.inverse_step;
    const DirectArm normal = direct_arm(n, lever_a, lever_b, a, b);
    const Pack s = 1.0 / square_root(coupling(normal, normal));
    store_arm(row, 0, normal, s);
    store(to.target[0], i, (gap - approach) * s);
    store(to.impulse[0], i, load(point, point_field::impulse) / s);
    store(to.scale[0], i, s);

    const TangentPlane plane = tangents(n);
    const DirectArm first = direct_arm(plane.first, lever_a, lever_b, a, b);
    const DirectArm second = direct_arm(plane.second, lever_a, lever_b, a, b);
    const Pack stiffest =
        stiffest_direction(Pack{}, coupling(first, first), coupling(second, second), coupling(first, second));
    const Pack t = 1.0 / square_root(stiffest);
    store_arm(row, 1, first, t);
    store_arm(row, 2, second, t);
    store(row, direct_field::coupling, coupling(normal, first) * (s * t));
    store(row, direct_field::coupling + 1, coupling(normal, second) * (s * t));
    const Pack friction = load(point, point_field::friction);
    store(row, direct_field::friction_coefficient, friction * s / t);
    store(to.target[1], i, -dot(plane.first, velocity) * t);
    store(to.target[2], i, -dot(plane.second, velocity) * t);
    start_friction(to.impulse[1], to.impulse[2], i, plane, load3(friction_start, 3 * i),
                   friction * load(point, point_field::impulse), t);
    store(to.scale[1], i, t);
    store3(row, direct_field::first, plane.first);
    store3(row, direct_field::second, plane.second);
    store(row, direct_field::change, 1.0 / s);
    store(row, direct_field::change + 1, 1.0 / t);
}

void prepare_direct_contacts(const LaneArrays& arrays, const DirectArrays& direct, const ComplianceColumn* columns,
                             const ContactPacks& packs, const double* points, const double* friction_start,
                             const DirectRowArrays& to, const ContactStep& step) {
    for_each_pair(packs, [&](const ContactPack& pack, std::uint32_t turn, const std::uint32_t* slots) {
        const CompliantBody a = compliant_body(arrays, direct, columns, slots);
        const CompliantBody b = compliant_body(arrays, direct, columns, slots + lanes);
        for (std::uint32_t row = pack.first_row + turn; row < pack.end_row; row += pack.turns) {
            prepare_direct_contact(points + static_cast<std::size_t>(row) * (point_field::count * lanes),
                                   friction_start, static_cast<int>(row), a, b, to, step);
        }
    });
}

/// A pair while its rows are solved: the motions after the impulses so far, and the sums of these impulses; what
/// SweepChange sums.
struct DirectPair {
    Flat a, b;
    Flat on_a, on_b;
    Pack square, onwards;
};

[[gnu::always_inline]] inline Pack along(const double* row, int i, const DirectPair& pair) {
    return dot(load_flat(row, direct_field::on_a + 6 * i), pair.a) -
           dot(load_flat(row, direct_field::on_b + 6 * i), pair.b);
}

[[gnu::always_inline]] inline void push(const double* row, int i, DirectPair& pair, Pack impulse) {
    pair.a = pair.a + load_flat(row, direct_field::moves_a + 6 * i) * impulse;
    pair.b = pair.b - load_flat(row, direct_field::moves_b + 6 * i) * impulse;
    pair.on_a = pair.on_a + load_flat(row, direct_field::on_a + 6 * i) * impulse;
    pair.on_b = pair.on_b - load_flat(row, direct_field::on_b + 6 * i) * impulse;
}

[[gnu::always_inline]] inline bool is_nothing(const double* impulse) {
    Pack size{};
#pragma GCC unroll 8
    for (int part = 0; part < 8; part += lanes) size = size + absolute(load(impulse + part, 0));
    return !any_positive(size);
}

/// Applies the impulse in each lane to the piece of the lane's body.
[[gnu::always_inline]] inline void pass_to_piece(double* delta, const ComplianceColumn* columns,
                                                 const std::uint32_t* slots, const Flat& on) {
    alignas(64) double by_lane[lanes][8];
    scatter_flat([&](int lane) { return by_lane[lane]; }, on);
    for (int lane = 0; lane < lanes; ++lane) {
        const ComplianceColumn& column = columns[slots[lane]];
        if (column.blocks == nullptr || is_nothing(by_lane[lane])) continue;
        add_velocity_changes(delta, column, by_lane[lane]);
    }
}

template <class Solve, class Visited>
[[gnu::always_inline]] inline void for_each_direct_row(double* delta, const ComplianceColumn* columns,
                                                       const ContactPacks& packs, const double* rows,
                                                       const Solve& solve, const Visited& visited) {
    const std::uint32_t* slots = packs.slots;
    for (std::size_t k = 0; k < packs.count; ++k, slots += 2 * lanes) {
        const auto motion = [=](const std::uint32_t* at) {
            return gather_flat([=](int lane) { return delta + 8 * static_cast<std::size_t>(at[lane]); });
        };
        DirectPair pair{motion(slots), motion(slots + lanes), {}, {}, {}, {}};
        for (std::uint32_t i = packs.packs[k].first_row; i < packs.packs[k].end_row; ++i) {
            solve(static_cast<int>(i), rows + static_cast<std::size_t>(i) * (direct_field::count * lanes), pair);
        }
        pass_to_piece(delta, columns, slots, pair.on_a);
        pass_to_piece(delta, columns, slots + lanes, pair.on_b);
        visited(packs.packs[k], pair);
    }
}

void start_direct_contacts(double* delta, const ComplianceColumn* columns, const ContactPacks& packs,
                           const DirectRowArrays& all) {
    const auto start = [&](int i, const double* row, DirectPair& pair) __attribute__((always_inline)) {
        for (int k = 0; k < 3; ++k) push(row, k, pair, load(all.impulse[k], i));
    };
    for_each_direct_row(delta, columns, packs, all.row, start, [](const ContactPack&, const DirectPair&) {});
}

/// One contact while its three rows are solved.
struct PieceContact {
    const DirectRowArrays& all;
    int i;
    const double* row;
    DirectPair& pair;
    Pack& largest;  ///< change of velocity so far; an empty lane's is not a number and left out

    [[gnu::always_inline]] Pack approach() const { return along(row, 0, pair); }

    [[gnu::always_inline]] Sliding sliding(Pack pressed) const {
        return {along(row, 1, pair) + load(row, direct_field::coupling) * pressed,
                along(row, 2, pair) + load(row, direct_field::coupling + 1) * pressed};
    }

    [[gnu::always_inline]] Pack bound(Pack normal) const {
        return load(row, direct_field::friction_coefficient) * normal;
    }

    [[gnu::always_inline]] void press(Pack pressed) const {
        if (!any_positive(absolute(pressed))) return;
        ::floes::push(row, 0, pair, pressed);
        largest = most(absolute(pressed) * load(row, direct_field::change), largest);
        count(0, pressed);
    }

    /// The impulse of row k of the contact, which has changed.
    [[gnu::always_inline]] void count(int k, Pack change) const {
        pair.square = pair.square + change * change;
        pair.onwards = pair.onwards + change * (load(all.impulse[k], i) - load(all.ended[k], i));
    }

    [[gnu::always_inline]] void push(Pack pressed, Pack one, Pack two) const {
        ::floes::push(row, 0, pair, pressed);
        ::floes::push(row, 1, pair, one);
        ::floes::push(row, 2, pair, two);
        largest = most(absolute(pressed) * load(row, direct_field::change), largest);
        largest = most(most(absolute(one), absolute(two)) * load(row, direct_field::change + 1), largest);
        count(0, pressed);
        count(1, one);
        count(2, two);
    }
};

/// Sums by column.
class ColumnSums {
  public:
    /// The lanes of a pack; what is not a number, as of an empty lane, is left out.
    [[gnu::always_inline]] void add(const ContactPack& pack, Pack x) {
        Pack& sum = sums_[pack.column / lanes];
        sum = sum + (absolute(x) >= 0.0 ? x : Pack{});
    }

    double total() const {
        alignas(Pack) double columns[sum_columns];
        for (int k = 0; k < static_cast<int>(sum_columns) / lanes; ++k) store(columns, k, sums_[k]);
        double sum = 0;
        for (const double column : columns) sum += column;
        return sum;
    }

  private:
    Pack sums_[sum_columns / lanes]{};
};

inline double largest_of(Pack x) {
    alignas(Pack) double values[lanes];
    store(values, 0, x);
    double largest = 0;
    for (const double value : values) largest = value > largest ? value : largest;
    return largest;
}

template <bool limited>
SweepChange solve_all_direct(double* delta, const ComplianceColumn* columns, const ContactPacks& packs,
                             const DirectRowArrays& all, const LimitArrays& limits) {
    const ConeArrays cones{{all.target[0], all.target[1], all.target[2]},
                           {all.impulse[0], all.impulse[1], all.impulse[2]}};
    Pack largest{};
    ColumnSums square;
    ColumnSums onwards;
    const auto solve = [&](int i, const double* row, DirectPair& pair) __attribute__((always_inline)) {
        solve_cone<limited>(cones, limits, i, PieceContact{all, i, row, pair, largest});
    };
    const auto visited = [&](const ContactPack& pack, const DirectPair& pair) __attribute__((always_inline)) {
        square.add(pack, pair.square);
        onwards.add(pack, pair.onwards);
    };
    for_each_direct_row(delta, columns, packs, all.row, solve, visited);
    return {largest_of(largest), square.total(), onwards.total()};
}

SweepChange solve_direct_contacts(double* delta, const ComplianceColumn* columns, const ContactPacks& packs,
                                  const DirectRowArrays& all, const LimitArrays& limits) {
    const auto solve = limits.yield == nullptr ? solve_all_direct<false> : solve_all_direct<true>;
    return solve(delta, columns, packs, all, limits);
}

[[gnu::always_inline]] inline void move_pack_ahead(double* now, double* ended, Pack ahead) {
    const Pack here = load(now, 0);
    store(now, 0, here + ahead * (here - load(ended, 0)));
    store(ended, 0, here);
}

void move_contacts_ahead(const MovedAhead& moved, const DirectRowArrays& all, double ahead) {
    const Pack by = Pack{} + ahead;
    for (int k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < moved.places; i += lanes) move_pack_ahead(all.impulse[k] + i, all.ended[k] + i, by);
    }
    for (std::size_t i = 0; i < moved.count; ++i) {
        double* delta = moved.delta + 8 * static_cast<std::size_t>(moved.slots[i]);
        for (int part = 0; part < 8; part += lanes) move_pack_ahead(delta + part, moved.ended + 8 * i + part, by);
    }
}

void sum_direct_contacts(double* impulse, const ComplianceColumn* columns, const ContactPacks& packs,
                         const DirectRowArrays& all) {
    const std::uint32_t* slots = packs.slots;
    for (std::size_t k = 0; k < packs.count; ++k, slots += 2 * lanes) {
        Flat on_a{}, on_b{};
        for (std::uint32_t i = packs.packs[k].first_row; i < packs.packs[k].end_row; ++i) {
            const double* row = all.row + static_cast<std::size_t>(i) * (direct_field::count * lanes);
            for (int j = 0; j < 3; ++j) {
                const Pack pressed = load(all.impulse[j], static_cast<int>(i));
                on_a = on_a + load_flat(row, direct_field::on_a + 6 * j) * pressed;
                on_b = on_b - load_flat(row, direct_field::on_b + 6 * j) * pressed;
            }
        }
        add_to_bodies(impulse, slots, on_a, on_b, [=](std::uint32_t body) { return columns[body].blocks != nullptr; });
    }
}
