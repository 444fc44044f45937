#include "collision/prism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {
namespace {

/// As of boxes (solver/contact_setup.inl): flush faces reach their whole area within micrometres.
constexpr double flattest = 1e-5;

/// For the part of a polygon whose height n . p lies below a bound: its area and the chord at the bound over |n|.
struct Below {
    double area = 0;
    double chord = 0;
};

Below below(const Outline& corners, const Corner& normal, double bound) {
    const std::size_t count = corners.size();
    Below found;
    double low = std::numeric_limits<double>::infinity();  // ends of the chord
    double high = -low;
    const Corner along{-normal.z, normal.x};
    const Corner& origin = corners[0];
    Corner last{};
    Corner first{};
    bool any = false;
    const auto add = [&](const Corner& point) {
        if (any)
            found.area += 0.5 * cross(last - origin, point - origin);
        else
            first = point;
        last = point;
        any = true;
    };
    for (std::size_t k = 0; k < count; ++k) {
        const Corner& here = corners[k];
        const Corner& next = corners[k + 1 < count ? k + 1 : 0];
        const double room = bound - dot(normal, here);
        const double room_next = bound - dot(normal, next);
        if (room >= 0) add(here);
        if ((room >= 0) == (room_next >= 0)) continue;
        const Corner at = here + room / (room - room_next) * (next - here);
        add(at);
        low = std::min(low, dot(along, at));
        high = std::max(high, dot(along, at));
    }
    if (any) add(first);
    const double squared = dot(normal, normal);
    if (high > low) found.chord = (high - low) / squared;  // along is as long as the normal
    return found;
}

}  // namespace

PrismShape::PrismShape(Outline of, double half)
    : corners(std::move(of)), half_thickness(half), half_extent{0, half, 0}, is_box(is_rectangle(corners)) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        normals.push_back(outward(corners, k));
        ahead.push_back(dot(normals[k], corners[k]));
        back.push_back(-ahead[k]);
        for (const Corner& one : corners) back[k] = std::max(back[k], -dot(normals[k], one));
    }
    if (!empty()) inner_radius = std::max(0.0, *std::ranges::min_element(ahead));
    for (const Corner& one : corners) {
        half_extent[0] = std::max(half_extent[0], std::abs(one.x));
        half_extent[2] = std::max(half_extent[2], std::abs(one.z));
    }
}

PrismSection section_of(const PrismShape& prism, const Triple& normal, double depth) {
    Corner flat{normal[0], normal[2]};
    const double size = std::sqrt(dot(flat, flat));
    if (size < flattest) flat = size > 0 ? (flattest / size) * flat : Corner{flattest, 0};
    const double c = std::max(std::abs(normal[1]), flattest);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Corner& one : prism.corners) {
        low = std::min(low, dot(flat, one));
        high = std::max(high, dot(flat, one));
    }
    const double rise = 2 * prism.half_thickness * c;
    const double middle = 0.5 * (high - low + rise);
    const double d = std::min(depth, middle);
    const Below whole = below(prism.corners, flat, low + d);
    const Below past = d > rise ? below(prism.corners, flat, low + d - rise) : Below{};
    return {std::max(0.0, (whole.area - past.area) / c),
            depth < middle ? std::max(0.0, (whole.chord - past.chord) / c) : 0};
}

PrismSection crushed_section(const PrismShape& prism, const Triple& normal, double depth) {
    const Triple& half = prism.half_extent;
    const double touching = 2 * flattest * std::min({half[0], half[1], half[2]});
    const double taken = std::max(depth, touching);
    const PrismSection at = section_of(prism, normal, taken);
    return {std::max(0.0, at.area + at.growth * (depth - taken)), at.growth};
}

int edge_towards(const PrismShape& prism, const Triple& direction) {
    int edge = -1;
    double most = std::abs(direction[1]);
    for (std::size_t k = 0; k < prism.normals.size(); ++k) {
        const double along = prism.normals[k].x * direction[0] + prism.normals[k].z * direction[2];
        if (along <= most) continue;
        most = along;
        edge = static_cast<int>(k);
    }
    return edge;
}

}  // namespace floes
