#include "shapes/elements.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "core/contract.hpp"

namespace floes {
namespace {

/// A rectangle of cells, i from `i0` up to and without `i1` along x, likewise along z.
struct Block {
    int i0, i1, k0, k1;
    friend bool operator==(const Block&, const Block&) = default;
};

struct Grid {
    int along, across;
    Corner low;
    double dx, dz;

    double x(int i) const { return low.x + i * dx; }
    double z(int k) const { return low.z + k * dz; }
};

Grid grid_over(Corners outline, double side) {
    const Corner size = size_of(outline);
    const auto count = [side](double extent) { return std::max(1, static_cast<int>(std::lround(extent / side))); };
    Grid grid{count(size.x), count(size.z), outline[0], 0, 0};
    for (const Corner& one : outline) grid.low = {std::min(grid.low.x, one.x), std::min(grid.low.z, one.z)};
    grid.dx = size.x / grid.along;
    grid.dz = size.z / grid.across;
    return grid;
}

Outline within(Corners outline, const Grid& grid, const Block& block) {
    Outline left(outline.begin(), outline.end());
    const auto cut = [&](const HalfPlane& half) {
        if (!left.empty()) left = clipped(left, half);
    };
    if (block.i0 > 0) cut({{-1, 0}, -grid.x(block.i0)});
    if (block.i1 < grid.along) cut({{1, 0}, grid.x(block.i1)});
    if (block.k0 > 0) cut({{0, -1}, -grid.z(block.k0)});
    if (block.k1 < grid.across) cut({{0, 1}, grid.z(block.k1)});
    if (left.empty()) return left;
    left = tidied(left, 1e-7 * (grid.dx + grid.dz));
    return left;
}

/// Length that two blocks share, on the line between them, and the middle of it.
struct Shared {
    double length = 0;
    Corner middle, normal;  // from the first to the second
};

/// The part of a line x = at (or z = at) within the outline and between two bounds along it.
std::pair<double, double> chord(Corners outline, bool along_x, double at, double low, double high) {
    double from = high;
    double to = low;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Corner& p = outline[k];
        const Corner& q = after(outline, k);
        const double a = along_x ? p.x : p.z;
        const double b = along_x ? q.x : q.z;
        if ((a < at && b < at) || (a > at && b > at)) continue;
        const double here = along_x ? p.z : p.x;
        const double there = along_x ? q.z : q.x;
        const auto meet = [&](double place) {
            from = std::min(from, place);
            to = std::max(to, place);
        };
        if (a != b) {
            meet(here + (at - a) / (b - a) * (there - here));
            continue;
        }
        meet(here);
        meet(there);
    }
    return {std::max(from, low), std::min(to, high)};
}

Shared shared(Corners outline, const Grid& grid, const Block& a, const Block& b) {
    const auto found = [&](bool along_x, double at, double low, double high, double sign) -> Shared {
        const auto [from, to] = chord(outline, along_x, at, low, high);
        if (!(to > from)) return {};
        const double middle = 0.5 * (from + to);
        return {to - from, along_x ? Corner{at, middle} : Corner{middle, at},
                along_x ? Corner{sign, 0} : Corner{0, sign}};
    };
    const int k0 = std::max(a.k0, b.k0);
    const int k1 = std::min(a.k1, b.k1);
    const int i0 = std::max(a.i0, b.i0);
    const int i1 = std::min(a.i1, b.i1);
    if (k0 < k1 && a.i1 == b.i0) return found(true, grid.x(a.i1), grid.z(k0), grid.z(k1), 1);
    if (k0 < k1 && b.i1 == a.i0) return found(true, grid.x(a.i0), grid.z(k0), grid.z(k1), -1);
    if (i0 < i1 && a.k1 == b.k0) return found(false, grid.z(a.k1), grid.x(i0), grid.x(i1), 1);
    if (i0 < i1 && b.k1 == a.k0) return found(false, grid.z(a.k0), grid.x(i0), grid.x(i1), -1);
    return {};
}

/// Whether two neighbours make a rectangle of cells.
bool make_a_rectangle(const Block& a, const Block& b) {
    return (a.k0 == b.k0 && a.k1 == b.k1 && (a.i1 == b.i0 || b.i1 == a.i0)) ||
           (a.i0 == b.i0 && a.i1 == b.i1 && (a.k1 == b.k0 || b.k1 == a.k0));
}

Block united(const Block& a, const Block& b) {
    return {std::min(a.i0, b.i0), std::max(a.i1, b.i1), std::min(a.k0, b.k0), std::max(a.k1, b.k1)};
}

/// The blocks of all elements, in the order of their first cells, along x first.
std::vector<Block> blocks_of(Corners outline, const Grid& grid) {
    std::vector<Block> blocks;
    std::vector<double> areas;
    for (int k = 0; k < grid.across; ++k)
        for (int i = 0; i < grid.along; ++i) {
            const Block cell{i, i + 1, k, k + 1};
            const Outline left = within(outline, grid, cell);
            if (left.empty()) continue;
            blocks.push_back(cell);
            areas.push_back(area_of(left));
        }
    // The smallest first, so that a sliver joins a whole cell rather than another sliver. One that fits nowhere stays.
    std::vector<Block> small;
    std::vector<std::size_t> order(blocks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t n) { return areas[n]; });
    for (const std::size_t n : order)
        if (areas[n] < least_element_share * grid.dx * grid.dz) small.push_back(blocks[n]);
    for (const Block& sliver : small) {
        const auto own = std::ranges::find(blocks, sliver);
        if (own == blocks.end()) continue;  // another one joined it
        auto best = blocks.end();
        double longest = 0;
        for (auto other = blocks.begin(); other != blocks.end(); ++other) {
            if (other == own || !make_a_rectangle(*own, *other)) continue;
            const double length = shared(outline, grid, *own, *other).length;
            if (length <= longest) continue;
            longest = length;
            best = other;
        }
        if (best == blocks.end()) continue;
        *best = united(*own, *best);
        blocks.erase(own);
    }
    std::ranges::sort(blocks, {}, [](const Block& one) { return std::pair(one.k0, one.i0); });
    return blocks;
}

CutElement element_of(const Outline& corners, Corners outline, double exact) {
    const Measures measures = measures_of(corners);
    CutElement element{.centre = measures.centroid, .axis = long_axis(measures), .corners = {}, .area = measures.area};
    element.corners = in_axes(corners, element.centre, element.axis);
    const Measures own = measures_of(element.corners);
    element.xx = own.xx;
    element.zz = own.zz;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Corner middle = 0.5 * (corners[k] + after(corners, k));
        for (std::size_t edge = 0; edge < outline.size(); ++edge)
            if (std::abs(dot(outward(outline, edge), middle - outline[edge])) < exact) element.rim |= 1U << k;
    }
    return element;
}

/// Bit of the edge that lies on a line; 0 if none does.
unsigned edge_on(Corners corners, const Corner& point, const Corner& normal, double exact) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (std::abs(dot(normal, corners[k] - point)) < exact &&
            std::abs(dot(normal, after(corners, k) - point)) < exact)
            bits |= 1U << k;
    return bits;
}

}  // namespace

CutFloe cut_into_elements(Corners outline, double side) {
    const Grid grid = grid_over(outline, side);
    const double exact = 1e-6 * (grid.dx + grid.dz);
    const std::vector<Block> blocks = blocks_of(outline, grid);
    std::vector<Outline> pieces;
    CutFloe floe;
    for (const Block& block : blocks) {
        pieces.push_back(within(outline, grid, block));
        floe.elements.push_back(element_of(pieces.back(), outline, exact));
    }
    for (std::size_t a = 0; a < blocks.size(); ++a)
        for (std::size_t b = a + 1; b < blocks.size(); ++b) {
            const Shared common = shared(outline, grid, blocks[a], blocks[b]);
            if (!(common.length > 1e-5 * std::min(grid.dx, grid.dz))) continue;
            const Corner& from = floe.elements[a].centre;
            const Corner& to = floe.elements[b].centre;
            const double span = dot(common.normal, to - from);
            const double shift = dot(common.normal, 0.5 * (from + to) - common.middle);
            floe.joints.push_back({static_cast<int>(a), static_cast<int>(b), common.normal,
                                   common.middle + shift * common.normal, common.length, span,
                                   edge_on(pieces[a], common.middle, common.normal, exact),
                                   edge_on(pieces[b], common.middle, common.normal, exact)});
        }
    return floe;
}

namespace {

/// The square ring around the floe's centre on which a joint lies, in half elements: integers, so that ties are exact.
int ring(const CutJoint& joint, int along, int across) {
    const int x = 2 * (joint.a % along) - (along - 1) + static_cast<int>(joint.normal.x);
    const int z = 2 * (joint.a / along) - (across - 1) + static_cast<int>(joint.normal.z);
    return std::max(std::abs(x), std::abs(z));
}

}  // namespace

CutFloe cut_into_squares(int along, int across, double side) {
    FLOES_EXPECTS(along > 0 && across > 0 && side > 0);
    CutFloe floe;
    floe.squares = true;
    const double moment = side * side * side * side / 12;
    const auto join = [&](int a, int b, const Corner& normal, unsigned edge_a, unsigned edge_b) {
        const Corner from = floe.elements[static_cast<std::size_t>(a)].centre;
        const Corner to = floe.elements[static_cast<std::size_t>(b)].centre;
        floe.joints.push_back({a, b, normal, 0.5 * (from + to), side, side, edge_a, edge_b});
    };
    for (int k = 0; k < across; ++k)
        for (int i = 0; i < along; ++i) {
            unsigned rim = 0;
            if (i == along - 1) rim |= edge_plus_x;
            if (k == across - 1) rim |= edge_plus_z;
            if (i == 0) rim |= edge_minus_x;
            if (k == 0) rim |= edge_minus_z;
            floe.elements.push_back({.centre = {(i - 0.5 * (along - 1)) * side, (k - 0.5 * (across - 1)) * side},
                                     .axis = {1, 0},
                                     .corners = corners_of(side / 2, side / 2),
                                     .area = side * side,
                                     .xx = moment,
                                     .zz = moment,
                                     .rim = rim});
        }
    for (int k = 0; k < across; ++k)
        for (int i = 0; i < along; ++i) {
            const int at = i + k * along;
            if (i + 1 < along) join(at, at + 1, {1, 0}, edge_plus_x, edge_minus_x);
            if (k + 1 < across) join(at, at + along, {0, 1}, edge_plus_z, edge_minus_z);
        }
    std::ranges::stable_sort(floe.joints, {}, [&](const CutJoint& joint) { return ring(joint, along, across); });
    return floe;
}

int count_elements(Corners outline, double side) {
    return static_cast<int>(blocks_of(outline, grid_over(outline, side)).size());
}

Quat turned_to(const Corner& axis) {
    // By half the angle φ of (x, z) = (cos φ, -sin φ), from roots only.
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + axis.x)));
    const double sine = std::sqrt(std::max(0.0, 0.5 * (1 - axis.x)));
    return Quat(cosine, 0, axis.z > 0 ? -sine : sine, 0).normalized();
}

}  // namespace floes
