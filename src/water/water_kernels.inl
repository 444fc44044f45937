// The water (water_model.hpp) on a group of elements, one in each lane. A source that CMake writes
// (floes_lane_kernels) defines FLOES_LANES and FLOES_KERNELS and includes this once; its own compiler flags choose the
// instruction set.

#include "water/water_kernels.hpp"

#if FLOES_LANES > 1
#include <immintrin.h>
#endif

namespace floes {
namespace {
#include "solver/pack.inl"

// A lane for which a condition does not hold computes like the others; then its result is left out.
#if FLOES_LANES == 1
using Bits = std::int64_t;
using Mask = bool;
#else
using Bits [[gnu::vector_size(8 * FLOES_LANES)]] = std::int64_t;
using Mask = decltype(Pack{} < Pack{});
#endif

/// One group of lanes in the arrays.
struct Group {
    const double* state;
    std::size_t stride;

    Pack field(std::size_t f) const { return *reinterpret_cast<const Pack*>(state + f * stride); }
    V3 vector(std::size_t f) const { return {field(f), field(f + 1), field(f + 2)}; }
};

struct Element {
    V3 position, x, normal, z, velocity, angular_velocity;
};

struct LaneWrench {
    V3 force, moment;

    void add(Mask where, const V3& f, const V3& arm) {
        const V3 m = cross(arm, f);
        force = {where ? force.x + f.x : force.x, where ? force.y + f.y : force.y, where ? force.z + f.z : force.z};
        moment = {where ? moment.x + m.x : moment.x, where ? moment.y + m.y : moment.y,
                  where ? moment.z + m.z : moment.z};
    }
};

/// How much of the column along the normal through the foot, from the centre of mass, is under water, m.
inline Pack submerged_length(const Element& e, const V3& foot, double thickness) {
    const Pack zero{};
    const Pack height = e.position.y + foot.y;
    // Height along the column is height + s n_y with s in [-T/2, T/2]; the s that lie below the surface are low to
    // high.
    const Pack bottom = zero + -0.5 * thickness;
    const Pack top = zero + 0.5 * thickness;
    const Pack crossing = -height / e.normal.y;
    const Pack high = e.normal.y > 0.0   ? (crossing < top ? crossing : top)
                      : e.normal.y < 0.0 ? top
                                         : (height >= 0.0 ? bottom : top);
    const Pack low = e.normal.y < 0.0 ? (bottom < crossing ? crossing : bottom) : bottom;
    const Pack length = high - low;
    return 0.0 < length ? length : zero;
}

/// Velocity of the water round one ellipse in the structure's own axes, added to `along` and `across`; (x, z) from its
/// middle.
inline void add_flow_round(const FlowEllipse& one, const WaterFactors& factors, Pack x, Pack z, Pack& along,
                           Pack& across) {
    const Pack zero{};
    const double a = one.half_length;
    const double b = one.half_breadth;
    // Within the ellipse the value on its edge in the same direction; in the middle that at the end of its length.
    const Pack depth = square_root(x * x / (a * a) + z * z / (b * b));
    const auto middle = depth == 0.0;
    const Pack out = middle ? zero + 1.0 : (depth < 1.0 ? 1.0 / depth : zero + 1.0);
    const Pack p = middle ? zero + a : x * out;
    const Pack q = middle ? zero : z * out;
    // s = √(ζ² - c²), ζ = p + i q, c² = a² - b², on the branch that goes with ζ.
    const Pack u = p * p - q * q - (a * a - b * b);
    const Pack v = 2.0 * p * q;
    const Pack size = square_root(u * u + v * v);
    const Pack real = square_root(0.5 * (size + absolute(u)));
    const Pack other = real == 0.0 ? zero : 0.5 * v / real;
    Pack s = u >= 0.0 ? real : absolute(other);
    Pack t = u >= 0.0 ? other : (v < 0.0 ? zero - real : real);
    const auto turned = s * p + t * q < 0.0;
    s = turned ? zero - s : s;
    t = turned ? zero - t : t;
    // u - i w = (a + b) (b V_x + i a V_z) / (s (s + ζ))
    const Pack e = s * (s + p) - t * (t + q);
    const Pack f = s * (t + q) + t * (s + p);
    const Pack scale = (a + b) / (e * e + f * f);
    const double g = b * (factors.speed * factors.yaw_cos - factors.speed_across * factors.yaw_sin);
    const double h = a * (factors.speed * factors.yaw_sin + factors.speed_across * factors.yaw_cos);
    along = along + scale * (g * e + h * f);
    across = across - scale * (h * e - g * f);
}

/// Velocity of the water relative to the element's material at `arm`; cos²θ is x²/r², and so on.
template <bool drifts>
inline V3 relative_velocity(const Element& e, const V3& arm, const WaterFactors& factors, double structure_x) {
    const Pack zero{};
    const Pack x = e.position.x + arm.x - structure_x;
    const Pack z = drifts ? e.position.z + arm.z - factors.structure_z : e.position.z + arm.z;
    if (factors.ellipses > 0) {
        // In the structure's own axes, and back.
        const double cos = factors.yaw_cos;
        const double sin = factors.yaw_sin;
        const Pack ahead = x * cos - z * sin;
        const Pack aside = x * sin + z * cos;
        Pack along = zero;
        Pack across = zero;
        for (int k = 0; k < factors.ellipses; ++k)
            add_flow_round(factors.ellipse[k], factors, ahead - factors.ellipse[k].x, aside - factors.ellipse[k].z,
                           along, across);
        const V3 flow{along * cos + across * sin + factors.current_x, zero,
                      across * cos - along * sin + factors.current_z};
        return flow - (e.velocity + cross(e.angular_velocity, arm));
    }
    const Pack r2 = x * x + z * z;
    const double radius2 = factors.radius * factors.radius;
    if constexpr (drifts) {
        const Pack near = r2 > radius2 ? radius2 / r2 : zero + 1.0;
        const auto centre = r2 == 0.0;
        const Pack twice_cos = centre ? zero + 1.0 : x * x / r2 - z * z / r2;
        const Pack twice_sin = centre ? zero : 2.0 * (x * z / r2);
        // At the centre, where the direction has no meaning, the water moves with the structure.
        const Pack along = near * (factors.speed * twice_cos + factors.speed_across * twice_sin);
        const Pack across =
            near * (factors.speed * twice_sin + factors.speed_across * (centre ? zero + 1.0 : -twice_cos));
        return V3{along + factors.current_x, zero, across + factors.current_z} -
               (e.velocity + cross(e.angular_velocity, arm));
    }
    const Pack strength = factors.speed * (r2 > radius2 ? radius2 / r2 : zero + 1.0);
    const Pack along = strength * (x * x / r2 - z * z / r2);
    const Pack across = strength * 2.0 * (x * z / r2);
    const V3 water = {r2 == 0.0 ? zero + factors.speed : along, zero, r2 == 0.0 ? zero : across};
    return water - (e.velocity + cross(e.angular_velocity, arm));
}

/// How edges are sheltered (EdgeShelter).
struct Shelter {
    Pack open, speed;

    Shelter(const double* fields, std::size_t stride, std::size_t edge)
        : open(*reinterpret_cast<const Pack*>(fields + 2 * edge * stride)),
          speed(*reinterpret_cast<const Pack*>(fields + (2 * edge + 1) * stride)) {}
};

/// The part of a flat convex face that is under water, in coordinates u and v on the face, from its edges one after
/// the other; they run from u to v.
struct WetFace {
    Pack twice_area{};
    Pack u{}, v{};                          ///< six times the moments of the area
    Pack out_u{}, out_v{}, in_u{}, in_v{};  ///< where the edges leave the water, and come back into it

    void add_line(Mask where, Pack pu, Pack pv, Pack qu, Pack qv) {
        const Pack zero{};
        const Pack twice = where ? pu * qv - pv * qu : zero;
        twice_area = twice_area + twice;
        u = u + (where ? twice * (pu + qu) : zero);
        v = v + (where ? twice * (pv + qv) : zero);
    }

    /// From p to q; hp and hq: heights above the water.
    void add_edge(Pack pu, Pack pv, Pack hp, Pack qu, Pack qv, Pack hq) {
        const Mask p_wet = hp < 0.0;
        const Mask q_wet = hq < 0.0;
        const Mask leaves = p_wet & (hq >= 0.0);
        const Mask enters = q_wet & (hp >= 0.0);
        // Of ice that floats the edges of its lower and upper face, most of all, do not cross the water.
        if (!any_positive(leaves | enters ? Pack{} + 1.0 : Pack{})) return add_line(p_wet | q_wet, pu, pv, qu, qv);
        const Pack share = hp / (hp - hq);
        const Pack u_there = pu + share * (qu - pu);
        const Pack v_there = pv + share * (qv - pv);
        out_u = leaves ? u_there : out_u;
        out_v = leaves ? v_there : out_v;
        in_u = enters ? u_there : in_u;
        in_v = enters ? v_there : in_v;
        add_line(p_wet | q_wet, enters ? u_there : pu, enters ? v_there : pv, leaves ? u_there : qu,
                 leaves ? v_there : qv);
    }

    /// Along the waterline.
    void close() { add_line(Pack{} == Pack{}, out_u, out_v, in_u, in_v); }

    Pack area() const { return 0.5 * twice_area; }
};

/// What of an element is under water. With O in the water's surface, the pyramids from O to the wet parts of its faces
/// make it up, as the part in the surface has no height: each has the volume h A/3 and its centroid 3/4 of the way from
/// O to that of its face.
struct UnderWater {
    Pack volume{};
    V3 moment{};  ///< of the volume about the centre of mass, in the axes of the element: x, normal, z
    Pack lower;   ///< area of the wet part of the face that looks down
};

/// Form drag on the wet part of an edge face; arm: of its centroid.
template <bool drifts>
inline void add_form_drag(LaneWrench& total, const Element& e, Mask exposed, const Shelter& shelter, const V3& outward,
                          Pack area, const V3& arm, const WaterFactors& factors, double structure_x) {
    const Pack flow = dot(relative_velocity<drifts>(e, arm, factors, structure_x), outward);
    const Pack ice = dot(e.velocity + cross(e.angular_velocity, arm), outward);
    const Pack approach = shelter.open * flow + (shelter.speed - (1.0 - shelter.open) * ice);
    total.add(exposed & (area > 0.0) & (approach < 0.0), outward * (factors.form * area * approach * approach), arm);
}

/// An edge in the axes of the element: its middle, its outward normal and its length.
template <class Number>
struct PlanEdge {
    Number x, z, normal_x, normal_z, length;
};

/// Elements side by side that are squares of one size.
struct Squares {
    const WaterFactors& factors;

    Squares(const WaterArrays&, std::size_t, const WaterFactors& of) : factors(of) {}
    static constexpr std::size_t edges = 4;
    double column_x() const { return factors.side / 3.4641016151377544; }  // √12
    double column_z() const { return column_x(); }
    double quarter() const { return 1; }  // of what the factors hold
    double area() const { return factors.side * factors.side; }
    PlanEdge<double> edge(std::size_t k) const {
        constexpr double x[edges] = {1, 0, -1, 0};
        constexpr double z[edges] = {0, 1, 0, -1};
        return {0.5 * factors.side * x[k], 0.5 * factors.side * z[k], x[k], z[k], factors.side};
    }
};

/// Elements side by side of any plan; edges that one of them has not are 0.
struct AnyPlans {
    const double* plan;
    std::size_t stride;
    std::size_t edges;

    AnyPlans(const WaterArrays& arrays, std::size_t i, const WaterFactors&)
        : plan(arrays.plan + i), stride(arrays.stride), edges(arrays.edges) {}
    Pack field(std::size_t f) const { return *reinterpret_cast<const Pack*>(plan + f * stride); }
    Pack column_x() const { return field(plan_field::column_x); }
    Pack column_z() const { return field(plan_field::column_z); }
    Pack quarter() const { return field(plan_field::quarter); }
    Pack area() const { return 4.0 * quarter(); }
    PlanEdge<Pack> edge(std::size_t k) const {
        const std::size_t f = plan_field::first_edge + plan_field::of_edge * k;
        return {field(f), field(f + 1), field(f + 2), field(f + 3), field(f + 4)};
    }
};

/// Edges that are exposed in any lane.
inline std::int64_t exposed_anywhere(const std::int64_t* exposed_edges) {
    std::int64_t any = 0;
    for (int lane = 0; lane < lanes; ++lane) any |= exposed_edges[lane];
    return any;
}

/// Looks at every face, and adds the form drag on edge faces.
template <bool drifts, class Plans>
inline UnderWater under_water(const Element& e, const Plans& plans, const WaterArrays& arrays, std::size_t i,
                              const WaterFactors& factors, double structure_x, LaneWrench& drag) {
    const Pack zero{};
    const Pack half = zero + 0.5 * factors.thickness;
    const Pack rise = half * e.normal.y;
    const V3 o{-e.position.y * e.x.y, -e.position.y * e.normal.y, -e.position.y * e.z.y};
    const Bits exposed = *reinterpret_cast<const Bits*>(arrays.exposed_edges + i);
    const std::int64_t any = exposed_anywhere(arrays.exposed_edges + i);
    UnderWater found{};
    const auto add_pyramid = [&](Pack height, Pack area, const V3& area_moment) {
        found.volume = found.volume + height * area * (1.0 / 3.0);
        found.moment = found.moment + area_moment * (0.25 * height);
    };
    WetFace bottom;
    WetFace top;
    for (std::size_t k = 0; k < plans.edges; ++k) {
        const auto edge = plans.edge(k);
        const Pack along_x = zero - edge.normal_z;
        const Pack along_z = zero + edge.normal_x;
        const Pack reach = zero + 0.5 * edge.length;
        const Pack px = edge.x - along_x * reach;
        const Pack pz = edge.z - along_z * reach;
        const Pack qx = edge.x + along_x * reach;
        const Pack qz = edge.z + along_z * reach;
        const Pack hp = e.position.y + px * e.x.y + pz * e.z.y;
        const Pack hq = e.position.y + qx * e.x.y + qz * e.z.y;
        bottom.add_edge(px, pz, hp - rise, qx, qz, hq - rise);
        top.add_edge(px, pz, hp + rise, qx, qz, hq + rise);
        WetFace side;
        side.add_edge(-reach, -half, hp - rise, reach, -half, hq - rise);
        side.add_edge(reach, -half, hq - rise, reach, half, hq + rise);
        side.add_edge(reach, half, hq + rise, -reach, half, hp + rise);
        side.add_edge(-reach, half, hp + rise, -reach, -half, hp - rise);
        side.close();
        const Pack area = side.area();
        const Pack u = side.u * (1.0 / 6.0);
        const Pack v = side.v * (1.0 / 6.0);
        add_pyramid(edge.normal_x * (edge.x - o.x) + edge.normal_z * (edge.z - o.z), area,
                    {edge.x * area + along_x * u, v, edge.z * area + along_z * u});
        const std::int64_t bit = std::int64_t{1} << k;
        if ((any & bit) == 0) continue;
        const Pack per_area = area > 0.0 ? 1.0 / area : zero;
        const V3 arm = e.x * (edge.x + along_x * (u * per_area)) + e.normal * (v * per_area) +
                       e.z * (edge.z + along_z * (u * per_area));
        add_form_drag<drifts>(drag, e, (exposed & bit) != 0, {arrays.shelter + i, arrays.stride, k},
                              e.x * (zero + edge.normal_x) + e.z * (zero + edge.normal_z), area, arm, factors,
                              structure_x);
    }
    const auto add_face = [&](WetFace& face, double up) {
        face.close();
        add_pyramid(half - up * o.y, face.area(),
                    {face.u * (1.0 / 6.0), up * half * face.area(), face.v * (1.0 / 6.0)});
    };
    add_face(bottom, -1);
    add_face(top, 1);
    found.moment = found.moment + o * (0.25 * found.volume);
    found.lower = e.normal.y >= 0.0 ? bottom.area() : top.area();
    return found;
}

/// Turned about the upward normal of the ice.
inline V3 turned_layer(const V3& along, const Element& e, const WaterFactors& factors) {
    const Pack up = e.normal.y >= 0.0 ? Pack{} + factors.turn_sin : Pack{} - factors.turn_sin;
    return along * (Pack{} + factors.turn_cos) + cross(e.normal, along) * up;
}

/// Skin drag and drag along the normal on a quarter of the face that looks down, of which the share `wet` is under
/// water; waves where the column above it cuts the surface; wind where its top is dry.
template <bool drifts, class At>
inline void add_column(LaneWrench& drag, const Element& e, Pack linear, Pack wet, At x, At z, At quarter,
                       const WaterFactors& factors, double structure_x) {
    const Pack zero{};
    const V3 foot = e.x * (zero + x) + e.z * (zero + z);
    const Pack column = submerged_length(e, foot, factors.thickness);
    const Pack down = e.normal.y >= 0.0 ? zero - 0.5 : zero + 0.5;
    const V3 arm = foot + e.normal * down * (zero + factors.thickness);
    const V3 relative = relative_velocity<drifts>(e, arm, factors, structure_x);
    const Pack through = dot(relative, e.normal);
    const V3 along = relative - e.normal * through;
    const V3 drawn = drifts ? turned_layer(along, e, factors) : along;
    const V3 skin = drawn * (factors.skin * quarter * wet * square_root(dot(along, along)));
    const Pack waves = (column > 0.0) & (column < factors.waves_below) ? linear : zero;
    const Pack heave = (factors.heave * quarter * wet * absolute(through) + waves) * through;
    drag.add(Pack{} == Pack{}, skin + e.normal * heave, arm);
    if constexpr (drifts) {
        const Pack above = factors.thickness * (1 - 1e-9) + zero;
        drag.add(column < above, {zero + factors.wind_x * quarter, zero, zero + factors.wind_z * quarter},
                 foot - e.normal * down * (zero + factors.thickness));
    }
}

template <bool drifts, class Plans>
void water_on_all(const WaterArrays& arrays, const WaterFactors& factors, std::size_t count, double structure_x) {
    for (std::size_t i = 0; i < count; i += lanes) {
        const Group group{arrays.state + i, arrays.stride};
        const Element e{group.vector(water_field::position),     group.vector(water_field::rotation),
                        group.vector(water_field::rotation + 3), group.vector(water_field::rotation + 6),
                        group.vector(water_field::velocity),     group.vector(water_field::angular_velocity)};
        const Pack linear = *reinterpret_cast<const Pack*>(arrays.linear + i);
        const Plans plans(arrays, i, factors);
        const auto x = plans.column_x();
        const auto z = plans.column_z();
        const auto quarter = plans.quarter();
        LaneWrench drag{};
        const UnderWater under = under_water<drifts>(e, plans, arrays, i, factors, structure_x, drag);
        const Pack wet = under.lower / plans.area();
        add_column<drifts>(drag, e, linear, wet, -x, -z, quarter, factors, structure_x);
        add_column<drifts>(drag, e, linear, wet, -x, z, quarter, factors, structure_x);
        add_column<drifts>(drag, e, linear, wet, x, -z, quarter, factors, structure_x);
        add_column<drifts>(drag, e, linear, wet, x, z, quarter, factors, structure_x);
        const Pack lift = factors.buoyancy * under.volume;
        const V3 arms =
            (e.x * under.moment.x + e.normal * under.moment.y + e.z * under.moment.z) * (Pack{} + factors.buoyancy);
        const Pack sum[wrench_fields] = {drag.force.x,           lift + drag.force.y, drag.force.z,
                                         drag.moment.x - arms.z, drag.moment.y,       arms.x + drag.moment.z};
        for (std::size_t f = 0; f < wrench_fields; ++f) {
            *reinterpret_cast<Pack*>(arrays.wrench + f * arrays.stride + i) = sum[f];
        }
    }
}

void water(const WaterArrays& arrays, const WaterFactors& factors, std::size_t count, double structure_x) {
    const bool squares = factors.side > 0;
    const auto act = factors.drifts ? (squares ? water_on_all<true, Squares> : water_on_all<true, AnyPlans>)
                                    : (squares ? water_on_all<false, Squares> : water_on_all<false, AnyPlans>);
    act(arrays, factors, count, structure_x);
}

}  // namespace

const WaterKernel FLOES_KERNELS = water;

}  // namespace floes
