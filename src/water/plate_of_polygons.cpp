// The water of a piece shared out among elements that are polygons.

#include <array>
#include <cmath>

#include "water/floating_plate.hpp"

namespace floes {
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
    Vec2 low(elements.front()->centre.x, elements.front()->centre.z);
    Vec2 high = low;
    double area = 0;
    for (const CutElement* one : elements) {
        area += one->area;
        for (const Corner& corner : in_floe(*one)) {
            low = low.cwiseMin(Vec2(corner.x, corner.z));
            high = high.cwiseMax(Vec2(corner.x, corner.z));
        }
    }
    const PlateLoad load = plate_load(0.5 * (low + high), high - low, area, draught, water);
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
    for (ElementWater& share : shares) {
        CarriedWater& carried = share.carried;
        for (double* moment : {&carried.normal, &carried.x, &carried.z, &carried.xx, &carried.xz, &carried.zz})
            *moment *= load.mass / sum;
        share.damping = load.damping * carried.normal;
    }
    return shares;
}

}  // namespace floes
