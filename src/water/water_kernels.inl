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

struct Column {
    Pack length;  ///< m along the normal; 0 when dry
    V3 arm;       ///< from the centre of mass to the middle of the submerged part, m
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

/// The submerged part of the column through body point (x, 0, z); the water surface is y = 0. Exact for any tilt,
/// upside down too.
template <class At>
inline Column submerged_column(const Element& e, At x, At z, double thickness) {
    const Pack zero{};
    const V3 foot = e.x * (zero + x) + e.z * (zero + z);
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
    return {0.0 < length ? length : zero, foot + e.normal * (0.5 * (low + high))};
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

/// On the edge at (x, z) in the axes of the element.
template <bool drifts, class At>
inline void add_form_drag(LaneWrench& total, const Element& e, Mask exposed, const Shelter& shelter, const V3& outward,
                          At side, At x, At z, const WaterFactors& factors, double structure_x) {
    const Column column = submerged_column(e, x, z, factors.thickness);
    const Pack flow = dot(relative_velocity<drifts>(e, column.arm, factors, structure_x), outward);
    const Pack ice = dot(e.velocity + cross(e.angular_velocity, column.arm), outward);
    const Pack approach = shelter.open * flow + (shelter.speed - (1.0 - shelter.open) * ice);
    const Pack area = side * column.length;
    total.add(exposed & (column.length != 0.0) & (approach < 0.0),
              outward * (factors.form * area * approach * approach), column.arm);
}

/// Elements side by side that are squares of one size.
struct Squares {
    const double* shelter;
    std::size_t stride;
    const WaterFactors& factors;

    Squares(const WaterArrays& arrays, std::size_t i, const WaterFactors& of)
        : shelter(arrays.shelter + i), stride(arrays.stride), factors(of) {}
    double column_x() const { return factors.side / 3.4641016151377544; }  // √12
    double column_z() const { return column_x(); }
    double quarter() const { return 1; }  // of what the factors hold

    template <bool drifts>
    LaneWrench drag_on_edges(const Element& e, const std::int64_t* exposed_edges, double structure_x) const {
        const Bits exposed = *reinterpret_cast<const Bits*>(exposed_edges);
        std::int64_t any = 0;
        for (int lane = 0; lane < lanes; ++lane) any |= exposed_edges[lane];
        const double half = 0.5 * factors.side;
        LaneWrench total{};
        const auto add = [&](int edge, const V3& axis, double sign, double x, double z) {
            const std::int64_t bit = std::int64_t{1} << edge;
            if (any & bit)
                add_form_drag<drifts>(total, e, (exposed & bit) != 0, {shelter, stride, static_cast<std::size_t>(edge)},
                                      axis * (Pack{} + sign), factors.side, x, z, factors, structure_x);
        };
        add(0, e.x, 1.0, half, 0.0);
        add(2, e.x, -1.0, -half, 0.0);
        add(1, e.z, 1.0, 0.0, half);
        add(3, e.z, -1.0, 0.0, -half);
        return total;
    }
};

/// Elements side by side of any plan.
struct AnyPlans {
    const double* shelter;
    const double* plan;
    std::size_t stride;
    std::size_t edges;
    const WaterFactors& factors;

    AnyPlans(const WaterArrays& arrays, std::size_t i, const WaterFactors& of)
        : shelter(arrays.shelter + i), plan(arrays.plan + i), stride(arrays.stride), edges(arrays.edges), factors(of) {}
    Pack field(std::size_t f) const { return *reinterpret_cast<const Pack*>(plan + f * stride); }
    Pack column_x() const { return field(plan_field::column_x); }
    Pack column_z() const { return field(plan_field::column_z); }
    Pack quarter() const { return field(plan_field::quarter); }

    template <bool drifts>
    LaneWrench drag_on_edges(const Element& e, const std::int64_t* exposed_edges, double structure_x) const {
        const Bits exposed = *reinterpret_cast<const Bits*>(exposed_edges);
        std::int64_t any = 0;
        for (int lane = 0; lane < lanes; ++lane) any |= exposed_edges[lane];
        LaneWrench total{};
        for (std::size_t k = 0; k < edges; ++k) {
            const std::int64_t bit = std::int64_t{1} << k;
            if ((any & bit) == 0) continue;
            const std::size_t f = plan_field::first_edge + plan_field::of_edge * k;
            add_form_drag<drifts>(total, e, (exposed & bit) != 0, {shelter, stride, k},
                                  e.x * field(f + 2) + e.z * field(f + 3), field(f + 4), field(f), field(f + 1),
                                  factors, structure_x);
        }
        return total;
    }
};

/// Turned about the upward normal of the ice.
inline V3 turned_layer(const V3& along, const Element& e, const WaterFactors& factors) {
    const Pack up = e.normal.y >= 0.0 ? Pack{} + factors.turn_sin : Pack{} - factors.turn_sin;
    return along * (Pack{} + factors.turn_cos) + cross(e.normal, along) * up;
}

template <bool drifts, class At>
inline void add_column(LaneWrench& buoyancy, LaneWrench& drag, const Element& e, Pack linear, At x, At z, At quarter,
                       const WaterFactors& factors, double structure_x) {
    const Pack zero{};
    const Column column = submerged_column(e, x, z, factors.thickness);
    const Mask wet = column.length != 0.0;
    buoyancy.add(wet, {zero, factors.buoyancy * quarter * column.length, zero}, column.arm);

    const V3 foot = column.arm - e.normal * dot(e.normal, column.arm);
    const Pack down = e.normal.y >= 0.0 ? zero - 0.5 : zero + 0.5;
    const V3 arm = foot + e.normal * down * (zero + factors.thickness);
    const V3 relative = relative_velocity<drifts>(e, arm, factors, structure_x);
    const Pack through = dot(relative, e.normal);
    const V3 along = relative - e.normal * through;
    const V3 drawn = drifts ? turned_layer(along, e, factors) : along;
    const V3 skin = drawn * (factors.skin * quarter * square_root(dot(along, along)));
    const Pack waves = column.length < factors.waves_below ? linear : zero;
    const Pack heave = (factors.heave * quarter * absolute(through) + waves) * through;
    drag.add(wet, skin + e.normal * heave, arm);
    if constexpr (drifts) {
        const Pack above = factors.thickness * (1 - 1e-9) + zero;
        drag.add(column.length < above, {zero + factors.wind_x * quarter, zero, zero + factors.wind_z * quarter},
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
        LaneWrench total{};
        const Plans plans(arrays, i, factors);
        const auto x = plans.column_x();
        const auto z = plans.column_z();
        const auto quarter = plans.quarter();
        LaneWrench drag = plans.template drag_on_edges<drifts>(e, arrays.exposed_edges + i, structure_x);
        add_column<drifts>(total, drag, e, linear, -x, -z, quarter, factors, structure_x);
        add_column<drifts>(total, drag, e, linear, -x, z, quarter, factors, structure_x);
        add_column<drifts>(total, drag, e, linear, x, -z, quarter, factors, structure_x);
        add_column<drifts>(total, drag, e, linear, x, z, quarter, factors, structure_x);
        const Pack sum[wrench_fields] = {total.force.x + drag.force.x,   total.force.y + drag.force.y,
                                         total.force.z + drag.force.z,   total.moment.x + drag.moment.x,
                                         total.moment.y + drag.moment.y, total.moment.z + drag.moment.z};
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
