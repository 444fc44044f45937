#include "water/floating_plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/contract.hpp"

namespace floes {

namespace {

#include "water/floating_plate_table.inl"

/// Where `value` lies in rising `nodes`: the node before it, and the share of the way to the next. Ends hold.
template <std::size_t count>
std::pair<std::size_t, double> between(const std::array<double, count>& nodes, double value, double (*scale)(double)) {
    const auto next = std::ranges::upper_bound(nodes, value);
    const auto at = static_cast<std::size_t>(
        std::clamp(next - nodes.begin() - 1, std::ptrdiff_t{0}, static_cast<std::ptrdiff_t>(count) - 2));
    const double way = (scale(value) - scale(nodes[at])) / (scale(nodes[at + 1]) - scale(nodes[at]));
    return {at, std::clamp(way, 0.0, 1.0)};
}

PlateWater mixed(const PlateWater& a, const PlateWater& b, double way) {
    const auto mix = [way](double from, double to) { return from + way * (to - from); };
    return {mix(a.added_mass, b.added_mass), mix(a.gyration_across, b.gyration_across),
            mix(a.gyration_along, b.gyration_along), mix(a.damping, b.damping)};
}

/// Moments 0, 1 and 2 of the weight 1 - t + t (15/8) (1 - s²)² from s = a to b, about the middle of that stretch.
std::array<double, 3> moments(double t, double a, double b) {
    std::array<double, 3> about_0{};
    for (int k = 0; k < 3; ++k) {
        const auto integral = [&](int power) {
            return (std::pow(b, power + 1) - std::pow(a, power + 1)) / (power + 1);
        };
        about_0[static_cast<std::size_t>(k)] =
            (1 - t) * integral(k) + t * 1.875 * (integral(k) - 2 * integral(k + 2) + integral(k + 4));
    }
    const auto [m0, m1, m2] = about_0;
    const double middle = 0.5 * (a + b);
    return {m0, m1 - middle * m0, m2 - 2 * middle * m1 + middle * middle * m0};
}

/// The weight's t for a squared radius of gyration over the side's square: 1/12 of an even load has 0, 1/28 has 1.
/// Below 0 the ends carry more than the middle, which down to -1 still carries something.
double weight_for(double gyration) {
    return std::clamp((1.0 / 3 - 4 * gyration) / (1.0 / 3 - 1.0 / 7), -1.0, 1.0);
}

}  // namespace

PlateWater plate_water(double aspect, double draught) {
    FLOES_EXPECTS(aspect >= 1 && draught >= 0);
    const auto [i, along] = between(aspects, aspect, [](double x) { return std::log(x); });
    const auto [k, deep] = between(draughts, draught, [](double x) { return x; });
    const auto at = [&, i = i, k = k](std::size_t one, std::size_t other) {
        return table[(i + one) * draughts.size() + k + other];
    };
    return mixed(mixed(at(0, 0), at(0, 1), deep), mixed(at(1, 0), at(1, 1), deep), along);
}

PlateLoad plate_load(const Vec2& middle, const Vec2& size, double area, double draught, const WaterBody& water) {
    const double aspect = size.maxCoeff() / size.minCoeff();
    const double b = std::sqrt(area / aspect);
    const PlateWater plate = plate_water(aspect, draught / b);
    const bool x_is_short = size.x() <= size.y();
    PlateLoad load;
    load.middle = middle;
    load.half = 0.5 * size;
    load.tx = weight_for(x_is_short ? plate.gyration_across : plate.gyration_along);
    load.tz = weight_for(x_is_short ? plate.gyration_along : plate.gyration_across);
    load.mass = plate.added_mass * water.density * b * b * b * aspect;
    load.damping = plate.damping * std::sqrt(water.gravity / b);
    return load;
}

namespace {

/// By their weights, which add up to `sum`.
void share_out(const PlateLoad& load, double sum, std::vector<ElementWater>& shares) {
    for (auto& [carried, damping] : shares) {
        for (double* moment : {&carried.normal, &carried.x, &carried.z, &carried.xx, &carried.xz, &carried.zz})
            *moment *= load.mass / sum;
        damping = load.damping * carried.normal;
    }
}

}  // namespace

std::vector<ElementWater> water_of_piece(std::span<const Vec2> centres, double side, double draught,
                                         const WaterBody& water) {
    const Box2 box = box_round(centres);
    const Vec2 size = box.sizes().array() + side;
    const Vec2 middle = box.center();
    const double area = static_cast<double>(centres.size()) * side * side;
    const PlateLoad load = plate_load(middle, size, area, draught, water);

    const Vec2& half = load.half;
    std::vector<ElementWater> shares;
    double sum = 0;
    for (const Vec2& centre : centres) {
        const auto over = [&](int axis, double t) {
            const double from = (centre[axis] - middle[axis] - 0.5 * side) / half[axis];
            return moments(t, from, from + side / half[axis]);
        };
        const auto [x0, x1, x2] = over(0, load.tx);
        const auto [z0, z1, z2] = over(1, load.tz);
        shares.push_back({{.normal = x0 * z0,
                           .x = half.x() * x1 * z0,
                           .z = half.y() * x0 * z1,
                           .xx = half.x() * half.x() * x2 * z0,
                           .xz = half.x() * half.y() * x1 * z1,
                           .zz = half.y() * half.y() * x0 * z2}});
        sum += x0 * z0;
    }
    const double ice = water.density * side * side * draught;
    share_out(load, sum, shares);
    for (ElementWater& share : shares) {
        share.carried.in_plane = water.in_plane * ice;
        share.carried.yaw = share.carried.in_plane * side * side / 6;
    }
    return shares;
}

namespace {

/// Gauss-Legendre on (-1, 1), exact to degree 11: weight and moments have degree 10, and a corner takes one more.
struct Node {
    double at, weight;
};
constexpr std::array<Node, 6> nodes{{{-0.9324695142031521, 0.1713244923791704},
                                     {-0.6612093864662645, 0.3607615730481386},
                                     {-0.2386191860831969, 0.4679139345726910},
                                     {0.2386191860831969, 0.4679139345726910},
                                     {0.6612093864662645, 0.3607615730481386},
                                     {0.9324695142031521, 0.1713244923791704}}};

double weight(double t, double s) {
    const double rest = 1 - s * s;
    return 1 - t + t * 1.875 * rest * rest;
}

/// `see(point, area)` at the nodes of the triangles from the first corner; areas sum to the polygon's.
template <class See>
void for_each_node(Corners polygon, const See& see) {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Corner a = polygon[k] - polygon[0];
        const Corner b = polygon[k + 1] - polygon[0];
        const double twice = cross(a, b);
        for (const auto& [along, along_weight] : nodes) {
            const double u = 0.5 * (1 + along);
            for (const auto& [across, across_weight] : nodes) {
                const double v = 0.5 * (1 + across);
                see(polygon[0] + u * (1 - v) * a + u * v * b, 0.25 * along_weight * across_weight * twice * u);
            }
        }
    }
}

}  // namespace

std::vector<ElementWater> water_of_piece(std::span<const CutElement* const> elements, double draught,
                                         const WaterBody& water) {
    const auto in_floe = [](const CutElement& one) { return from_axes(one.corners, one.centre, one.axis); };
    Box2 box;
    double area = 0;
    for (const CutElement* one : elements) {
        area += one->area;
        box.extend(box_round(in_floe(*one)));
    }
    const PlateLoad load = plate_load(box.center(), box.sizes(), area, draught, water);
    std::vector<ElementWater> shares;
    double sum = 0;
    for (const CutElement* one : elements) {
        CarriedWater carried;
        for_each_node(one->corners, [&](const Corner& own, double part) {
            const Corner at = from_axes(std::array{own}, one->centre, one->axis).front();
            const double w = part * weight(load.tx, (at.x - load.middle.x()) / load.half.x()) *
                             weight(load.tz, (at.z - load.middle.y()) / load.half.y());
            carried.normal += w;
            carried.x += w * own.x;
            carried.z += w * own.z;
            carried.xx += w * own.x * own.x;
            carried.xz += w * own.x * own.z;
            carried.zz += w * own.z * own.z;
        });
        sum += carried.normal;
        carried.in_plane = water.in_plane * water.density * draught * one->area;
        carried.yaw = carried.in_plane * (one->xx + one->zz) / one->area;
        shares.push_back({carried});
    }
    share_out(load, sum, shares);
    return shares;
}

}  // namespace floes
