#include "outline/rings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace floes {
namespace {

double side(const Corner& from, const Corner& to, const Corner& p) {
    return cross(to - from, p - from);
}

bool is_between(const Corner& a, const Corner& b, const Corner& p) {
    return dot(p - a, p - b) <= 0;
}

/// Whether two edges have a point in common, their ends included.
bool meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    const double from_c = side(a, b, c);
    const double from_d = side(a, b, d);
    const double from_a = side(c, d, a);
    const double from_b = side(c, d, b);
    if (from_c * from_d < 0 && from_a * from_b < 0) return true;
    return (from_c == 0 && is_between(a, b, c)) || (from_d == 0 && is_between(a, b, d)) ||
           (from_a == 0 && is_between(c, d, a)) || (from_b == 0 && is_between(c, d, b));
}

}  // namespace

std::optional<std::string> ring_fault_of(Corners ring) {
    if (ring.size() < 3) return fmt::format("it has {} different corners, and a floe has at least 3", ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t k = i + 2; k < ring.size(); ++k) {
            if (i == 0 && k + 1 == ring.size()) continue;
            if (meet(ring[i], after(ring, i), ring[k], after(ring, k)))
                return fmt::format("it crosses or touches itself: its edges from corners {} and {} meet", i + 1, k + 1);
        }
    const Corner size = size_of(ring);
    if (!(std::abs(area_of(ring)) > 1e-9 * (size.x * size.x + size.z * size.z))) return "it has no area";
    return std::nullopt;
}

Outline with_fewer_corners(Corners convex, std::size_t most) {
    Outline kept(convex.begin(), convex.end());
    if (kept.size() <= most) return kept;
    while (kept.size() > most) {
        const auto cut_off = [&](const Corner& corner) {
            const auto k = static_cast<std::size_t>(&corner - kept.data());
            return side(kept[k > 0 ? k - 1 : kept.size() - 1], corner, after(kept, k));
        };
        kept.erase(std::ranges::min_element(kept, {}, cut_off));
    }
    const Measures left = measures_of(kept);
    const double scale = std::sqrt(area_of(convex) / left.area);
    for (Corner& corner : kept) corner = left.centroid + scale * (corner - left.centroid);
    return kept;
}

}  // namespace floes
