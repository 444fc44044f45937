#include "shapes/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/contract.hpp"

namespace floes {

namespace {

double length_of(const Corner& a) {
    return std::sqrt(dot(a, a));
}

std::size_t before(Corners polygon, std::size_t k) {
    return k > 0 ? k - 1 : polygon.size() - 1;
}

/// At a corner between its neighbours: how far the way turns there, positive towards z.
double bend(Corners polygon, std::size_t k) {
    const Corner& here = polygon[k];
    return cross(here - polygon[before(polygon, k)], after(polygon, k) - here);
}

double side(const Corner& from, const Corner& to, const Corner& p) {
    return cross(to - from, p - from);
}

bool cross_each_other(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

}  // namespace

Corner outward(Corners polygon, std::size_t k) {
    FLOES_EXPECTS(k < polygon.size());
    const Corner along = after(polygon, k) - polygon[k];
    const double length = length_of(along);
    return {along.z / length, -along.x / length};
}

double edge_length(Corners polygon, std::size_t k) {
    FLOES_EXPECTS(k < polygon.size());
    return length_of(after(polygon, k) - polygon[k]);
}

double area_of(Corners polygon) {
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        twice += cross(polygon[k] - polygon[0], after(polygon, k) - polygon[0]);
    return 0.5 * twice;
}

Measures measures_of(Corners polygon) {
    Measures sum;
    const Corner& origin = polygon[0];
    for (std::size_t k = 0; k < polygon.size(); ++k) {  // triangles from the first corner
        const Corner a = polygon[k] - origin;
        const Corner b = after(polygon, k) - origin;
        const double twice = cross(a, b);
        sum.area += twice / 2;
        sum.centroid = sum.centroid + (twice / 6) * (a + b);
        sum.xx += twice / 12 * (a.x * a.x + a.x * b.x + b.x * b.x);
        sum.zz += twice / 12 * (a.z * a.z + a.z * b.z + b.z * b.z);
        sum.xz += twice / 24 * (2 * a.x * a.z + a.x * b.z + b.x * a.z + 2 * b.x * b.z);
    }
    sum.centroid = (1 / sum.area) * sum.centroid;
    sum.xx -= sum.area * sum.centroid.x * sum.centroid.x;
    sum.zz -= sum.area * sum.centroid.z * sum.centroid.z;
    sum.xz -= sum.area * sum.centroid.x * sum.centroid.z;
    sum.centroid = sum.centroid + origin;
    return sum;
}

Corner long_axis(const Measures& of) {
    // Double angles: (cos 2φ, sin 2φ) is along (xx - zz, 2 xz). Roots only, so that all C libraries agree.
    const Corner twice{of.xx - of.zz, 2 * of.xz};
    const double size = length_of(twice);
    if (size <= 1e-9 * (of.xx + of.zz)) return {1, 0};
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + twice.x / size)));
    const double sine = std::sqrt(std::max(0.0, 0.5 * (1 - twice.x / size)));
    return {cosine, twice.z < 0 ? -sine : sine};
}

Outline clipped(Corners polygon, const HalfPlane& within) {
    Outline kept;
    clip_into(kept, polygon, within);
    return kept;
}

void clip_into(Outline& kept, Corners polygon, const HalfPlane& within) {
    kept.clear();
    kept.reserve(polygon.size() + 1);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Corner& here = polygon[k];
        const Corner& next = after(polygon, k);
        const double room = within.bound - dot(within.normal, here);
        const double room_next = within.bound - dot(within.normal, next);
        if (room >= 0) kept.push_back(here);
        if ((room > 0 && room_next < 0) || (room < 0 && room_next > 0))
            kept.push_back(here + room / (room - room_next) * (next - here));
    }
    if (kept.size() < 3 || !(area_of(kept) > 0)) kept.clear();
}

Outline eroded(Corners polygon, double offset) {
    FLOES_EXPECTS(offset >= 0);
    Outline left(polygon.begin(), polygon.end());
    for (std::size_t k = 0; k < polygon.size() && !left.empty(); ++k) {
        const Corner normal = outward(polygon, k);
        left = clipped(left, {normal, dot(normal, polygon[k]) - offset});
    }
    return left;
}

Outline grown(Corners polygon, double offset) {
    FLOES_EXPECTS(offset >= 0);
    Outline larger;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Corner one = outward(polygon, before(polygon, k));
        const Corner other = outward(polygon, k);
        larger.push_back(polygon[k] + (offset / (1 + dot(one, other))) * (one + other));
    }
    return larger;
}

Outline in_axes(Corners polygon, const Corner& origin, const Corner& axis) {
    Outline turned;
    for (const Corner& one : polygon) turned.push_back({dot(axis, one - origin), cross(axis, one - origin)});
    return turned;
}

Outline from_axes(Corners polygon, const Corner& origin, const Corner& axis) {
    Outline turned;
    for (const Corner& one : polygon)
        turned.push_back({origin.x + one.x * axis.x - one.z * axis.z, origin.z + one.x * axis.z + one.z * axis.x});
    return turned;
}

Outline tidied(Corners polygon, double least) {
    Outline kept(polygon.begin(), polygon.end());
    const double straight = least * least;
    for (std::size_t k = 0; k < kept.size() && kept.size() > 3;) {
        if (edge_length(kept, k) < least || std::abs(bend(kept, k)) < straight)
            kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(k));
        else
            ++k;
    }
    return kept;
}

bool contains(Corners polygon, const Corner& point) {
    for (std::size_t k = 0; k < polygon.size(); ++k)
        if (cross(after(polygon, k) - polygon[k], point - polygon[k]) < 0) return false;
    return true;
}

double separation(Corners a, Corners b) {
    double widest = -std::numeric_limits<double>::infinity();
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        for (std::size_t k = 0; k < one.size(); ++k) {
            const Corner normal = outward(one, k);
            double gap = std::numeric_limits<double>::infinity();
            for (const Corner& corner : other) gap = std::min(gap, dot(normal, corner - one[k]));
            widest = std::max(widest, gap);
        }
    }
    return widest;
}

double inner_radius(Corners polygon) {
    FLOES_EXPECTS(polygon.size() >= 3);
    if (const auto half = half_sides_of(polygon)) return std::min(half->x, half->z);
    double low = 0;
    double high = reach_of(in_axes(polygon, measures_of(polygon).centroid, {1, 0}));
    const double exact = 1e-6 * high;
    while (high - low > exact) {
        const double middle = 0.5 * (low + high);
        (eroded(polygon, middle).empty() ? high : low) = middle;
    }
    return low;
}

double reach_of(Corners polygon) {
    double squared = 0;
    for (const Corner& one : polygon) squared = std::max(squared, dot(one, one));
    return std::sqrt(squared);
}

Outline corners_of(double half_length, double half_breadth) {
    return {{half_length, -half_breadth},
            {half_length, half_breadth},
            {-half_length, half_breadth},
            {-half_length, -half_breadth}};
}

std::optional<Corner> half_sides_of(Corners polygon) {
    if (polygon.size() != 4) return std::nullopt;
    const Corner half = polygon[1];
    if (!(half.x > 0 && half.z > 0) || !std::ranges::equal(polygon, corners_of(half.x, half.z))) return std::nullopt;
    return half;
}

Box2 box_round(Corners points) {
    Box2 box;
    for (const Corner& one : points) box.extend(Vec2(one.x, one.z));
    return box;
}

Corner size_of(Corners polygon) {
    FLOES_EXPECTS(!polygon.empty());
    const Vec2 size = box_round(polygon).sizes();
    return {size.x(), size.y()};
}

Outline convex_hull(Outline points) {
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
    Outline hull;
    const auto add = [&](const Corner& point, std::size_t least) {
        while (hull.size() >= least + 2 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
            hull.pop_back();
        hull.push_back(point);
    };
    for (const Corner& point : points) add(point, 0);
    if (hull.size() < 3 && points.size() < 3) return hull;
    const std::size_t below = hull.size() - 1;
    for (std::size_t k = points.size() - 1; k-- > 0;) add(points[k], below);
    hull.pop_back();
    return hull;
}

std::optional<std::string> fault_of(Corners polygon) {
    if (polygon.size() < 3) return fmt::format("it has {} corners, and a polygon has at least 3", polygon.size());
    double size = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        if (!std::isfinite(polygon[k].x) || !std::isfinite(polygon[k].z))
            return fmt::format("corner {} is not a pair of finite numbers", k + 1);
        size = std::max(size, edge_length(polygon, k));
    }
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t k = i + 2; k < polygon.size(); ++k) {
            if (i == 0 && k + 1 == polygon.size()) continue;
            if (cross_each_other(polygon[i], after(polygon, i), polygon[k], after(polygon, k)))
                return fmt::format("it crosses itself: its edges from corners {} and {} meet", i + 1, k + 1);
        }
    const double area = area_of(polygon);
    const double nothing = 1e-9 * size * size;
    if (!(std::abs(area) > nothing)) return "it has no area";
    double turned = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        if (bend(polygon, k) * area < -nothing * std::abs(area))
            return fmt::format("it is not convex: it bends inwards at corner {}", k + 1);
        const Corner here = after(polygon, k) - polygon[k];
        const Corner next = after(polygon, k + 1 < polygon.size() ? k + 1 : 0) - after(polygon, k);
        turned += std::atan2(cross(here, next), dot(here, next));
    }
    if (std::abs(turned) > 7) return "it runs round itself more than once";
    return std::nullopt;
}

double distance_between(Corners a, Corners b) {
    FLOES_EXPECTS(!a.empty() && !b.empty());
    const double apart = separation(a, b);
    if (apart <= 0) return apart;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        for (std::size_t k = 0; k < one.size(); ++k) {
            const Corner along = after(one, k) - one[k];
            for (const Corner& corner : other) {
                const double share = std::clamp(dot(along, corner - one[k]) / dot(along, along), 0.0, 1.0);
                const Corner left = corner - one[k] - share * along;
                least = std::min(least, std::sqrt(dot(left, left)));
            }
        }
    }
    return least;
}

namespace {

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

Outline with_fewer_corners(Corners ring, std::size_t most) {
    FLOES_EXPECTS(most >= 3);
    Outline kept(ring.begin(), ring.end());
    const auto can_go = [&](std::size_t k) {
        const Corner& from = kept[before(kept, k)];
        const Corner& to = after(kept, k);
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const std::size_t next = i + 1 < kept.size() ? i + 1 : 0;
            const bool touches = i == k || next == k || i == before(kept, k) || next == before(kept, k) ||
                                 kept[i] == to || kept[next] == to;
            if (!touches && meet(from, to, kept[i], kept[next])) return false;
        }
        return true;
    };
    std::vector<bool> stays(kept.size());
    constexpr int most_passes = 8;  // over those that could not go: others have gone since then
    int passes = 0;
    while (kept.size() > most && passes < most_passes) {
        std::size_t least = kept.size();
        double change = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < kept.size(); ++k) {
            const double of = std::abs(side(kept[before(kept, k)], kept[k], after(kept, k)));
            if (stays[k] || of >= change) continue;
            change = of;
            least = k;
        }
        if (least == kept.size()) {
            ++passes;
            stays.assign(kept.size(), false);
        } else if (!can_go(least)) {
            stays[least] = true;
        } else {
            stays[before(kept, least)] = stays[least + 1 < kept.size() ? least + 1 : 0] = false;
            kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(least));
            stays.erase(stays.begin() + static_cast<std::ptrdiff_t>(least));
        }
    }
    if (kept.size() == ring.size()) return kept;
    const Measures left = measures_of(kept);
    const double scale = std::sqrt(area_of(ring) / left.area);
    for (Corner& corner : kept) corner = left.centroid + scale * (corner - left.centroid);
    return kept;
}

bool is_convex(Corners ring) {
    const Corner size = size_of(ring);
    for (std::size_t k = 0; k < ring.size(); ++k)
        if (bend(ring, k) < -1e-9 * (size.x * size.x + size.z * size.z)) return false;
    return true;
}

std::optional<Outline> united(Corners a, Corners b) {
    Outline all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    Outline hull = convex_hull(std::move(all));
    const double sum = area_of(a) + area_of(b);
    return area_of(hull) <= (1 + 1e-6) * sum ? std::optional(std::move(hull)) : std::nullopt;
}

std::vector<Outline> joined(std::vector<Outline> parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t k = i + 1; k < parts.size(); ++k) {
            std::optional<Outline> both = united(parts[i], parts[k]);
            if (!both) continue;
            parts[i] = *std::move(both);
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
            k = i;  // others may fit now
        }
    }
    return parts;
}

namespace {

/// Cuts triangles off until none is left; every ring has an ear.
std::vector<Outline> triangles_of(Outline ring) {
    std::vector<Outline> triangles;
    while (ring.size() > 3) {
        const auto is_ear = [&](std::size_t k) {
            const Corner& from = ring[before(ring, k)];
            const Corner& to = after(ring, k);
            if (side(from, ring[k], to) < 0) return false;
            return std::ranges::none_of(ring, [&](const Corner& p) {
                if (p == from || p == ring[k] || p == to) return false;
                return side(from, ring[k], p) >= 0 && side(ring[k], to, p) >= 0 && side(to, from, p) >= 0;
            });
        };
        std::size_t ear = 0;
        while (ear + 1 < ring.size() && !is_ear(ear)) ++ear;
        triangles.push_back({ring[before(ring, ear)], ring[ear], after(ring, ear)});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back(std::move(ring));
    return triangles;
}

}  // namespace

std::vector<Outline> convex_parts(Corners ring) {
    if (is_convex(ring)) return {Outline(ring.begin(), ring.end())};
    std::vector<Outline> parts = triangles_of(Outline(ring.begin(), ring.end()));
    std::erase_if(parts, [&](const Outline& one) { return area_of(one) <= 1e-12 * area_of(ring); });
    return joined(std::move(parts));
}

double inner_radius_of_parts(Corners ring) {
    double widest = 0;
    for (const Outline& part : convex_parts(ring)) widest = std::max(widest, inner_radius(part));
    return widest;
}

double distance_between_outlines(Corners a, Corners b) {
    double least = std::numeric_limits<double>::infinity();
    const std::vector<Outline> of_b = convex_parts(b);
    for (const Outline& one : convex_parts(a))
        for (const Outline& other : of_b) least = std::min(least, distance_between(one, other));
    return least;
}

}  // namespace floes
