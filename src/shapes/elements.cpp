#include "shapes/elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "core/contract.hpp"

namespace floes {
namespace {

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

/// What lies within all of these.
using Area = std::vector<HalfPlane>;

/// A cell at the edge of the grid has no end there.
Area area_of_cell(const Grid& grid, int i, int k) {
    Area area;
    if (i > 0) area.push_back({{-1, 0}, -grid.x(i)});
    if (i + 1 < grid.along) area.push_back({{1, 0}, grid.x(i + 1)});
    if (k > 0) area.push_back({{0, -1}, -grid.z(k)});
    if (k + 1 < grid.across) area.push_back({{0, 1}, grid.z(k + 1)});
    return area;
}

Area with(Area area, const Corner& normal, double bound) {
    area.push_back({normal, bound});
    return area;
}

Outline within(Corners convex, const Area& area, double least) {
    Outline left(convex.begin(), convex.end());
    for (const HalfPlane& half : area)
        if (!left.empty()) left = clipped(left, half);
    return left.empty() ? left : tidied(left, least);
}

/// The edges on which two convex polygons touch, and the line that they share.
struct Shared {
    double length = 0;
    Corner middle, normal;  ///< from the first to the second
    unsigned edge_a = 0, edge_b = 0;
};

/// Exactly along the grid where it is so but for rounding.
Corner on_grid(const Corner& normal) {
    if (std::abs(normal.x) < 1e-9) return {0, normal.z > 0 ? 1.0 : -1.0};
    if (std::abs(normal.z) < 1e-9) return {normal.x > 0 ? 1.0 : -1.0, 0};
    return normal;
}

Shared shared(Corners a, Corners b, double exact) {
    Shared found;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Corner normal = on_grid(outward(a, i));
        const Corner along{-normal.z, normal.x};
        const double end = dot(along, after(a, i) - a[i]);
        for (std::size_t k = 0; k < b.size(); ++k) {
            const Corner& p = b[k];
            const Corner& q = after(b, k);
            if (std::abs(dot(normal, p - a[i])) > exact || std::abs(dot(normal, q - a[i])) > exact) continue;
            const double from = dot(along, p - a[i]);
            const double to = dot(along, q - a[i]);
            const double low = std::max(std::min(0.0, end), std::min(from, to));
            const double high = std::min(std::max(0.0, end), std::max(from, to));
            if (!(high - low > found.length)) continue;
            found = {high - low, a[i] + 0.5 * (low + high) * along, normal, 1U << i, 1U << k};
        }
    }
    return found;
}

/// Less of a cell is too little mass for its joints.
constexpr double least_share_beside_bays = 0.1;

/// A rectangle of cells, i from `i0` up to and without `i1` along x, likewise along z.
struct Block {
    int i0, i1, k0, k1;
};

bool make_a_rectangle(const Block& a, const Block& b) {
    return (a.k0 == b.k0 && a.k1 == b.k1 && (a.i1 == b.i0 || b.i1 == a.i0)) ||
           (a.i0 == b.i0 && a.i1 == b.i1 && (a.k1 == b.k0 || b.k1 == a.k0));
}

Block united(const Block& a, const Block& b) {
    return {std::min(a.i0, b.i0), std::max(a.i1, b.i1), std::min(a.k0, b.k0), std::max(a.k1, b.k1)};
}

/// A convex piece of an outline, and the cells of the grid that it has a part of.
struct Piece {
    Block block;
    Outline corners;
};

class Cutter {
  public:
    Cutter(Corners outline, double side)
        : grid_(grid_over(outline, side)),
          least_(1e-7 * (grid_.dx + grid_.dz)),
          exact_(10 * least_),
          parts_(convex_parts(outline)) {
        for (std::size_t k = 0; parts_.size() > 1 && k < outline.size(); ++k) {
            const std::size_t before = k > 0 ? k - 1 : outline.size() - 1;
            if (cross(outline[k] - outline[before], after(outline, k) - outline[k]) < 0)
                bays_.push_back(
                    Bay{outline[k], {Corner{1, 0}, Corner{0, 1}, outward(outline, before), outward(outline, k)}});
        }
    }

    double exact() const { return exact_; }
    double shortest_joint() const { return 1e-5 * std::min(grid_.dx, grid_.dz); }

    /// In the order of their first cells, along x first.
    std::vector<Piece> pieces() const {
        std::vector<Piece> pieces;
        for (int k = 0; k < grid_.across; ++k)
            for (int i = 0; i < grid_.along; ++i)
                for (Outline& one : cut(area_of_cell(grid_, i, k)))
                    pieces.push_back({{i, i + 1, k, k + 1}, std::move(one)});
        merge_small(pieces);
        for (std::size_t n = 0; n < pieces.size(); ++n)
            if (!bays_.empty() && area_of(pieces[n].corners) < least_share_beside_bays * grid_.dx * grid_.dz)
                enlarge(pieces, n);
        std::ranges::stable_sort(pieces, {}, [](const Piece& one) { return std::pair(one.block.k0, one.block.i0); });
        return pieces;
    }

  private:
    /// Where the outline bends inwards, and normals of lines through there that may part its two sides: the grid's, and
    /// those of its edges.
    struct Bay {
        Corner at;
        std::array<Corner, 4> normals;
    };

    /// What lies within, with as few pieces as pairs allow.
    std::vector<Outline> joined_parts(const Area& area) const {
        std::vector<Outline> found;
        for (const Outline& part : parts_)
            if (Outline left = within(part, area, least_); left.size() >= 3 && area_of(left) > least_ * grid_.dx)
                found.push_back(std::move(left));
        found = joined(std::move(found));
        for (Outline& one : found) one = tidied(one, least_);
        return found;
    }

    bool hang_together(const std::vector<Outline>& pieces) const {
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (std::size_t k = i + 1; k < pieces.size(); ++k)
                if (shared(pieces[i], pieces[k], exact_).length > shortest_joint()) return true;
        return false;
    }

    /// The pieces on both sides of a line: cut until they are convex, or as they lie.
    std::vector<Outline> on_both_sides(const Area& area, const Corner& at, const Corner& normal, bool convex) const {
        const double bound = dot(normal, at);
        std::vector<Outline> found;
        for (const Area& half : {with(area, normal, bound), with(area, -1.0 * normal, -bound)})
            for (Outline& one : convex ? cut(half) : joined_parts(half)) found.push_back(std::move(one));
        return found;
    }

    /// Convex pieces of what lies within. Where the outline bends inwards in it, it is cut along the line that leaves
    /// the largest smallest piece: in the end, or at once where there are so many bays that to try all lines of all of
    /// them would not end.
    std::vector<Outline> cut(const Area& area) const {
        constexpr std::ptrdiff_t few = 3;
        std::vector<Outline> whole = joined_parts(area);
        if (whole.size() < 2 || !hang_together(whole)) return whole;
        const auto is_in = [&](const Bay& bay) {
            return std::ranges::all_of(
                area, [&](const HalfPlane& half) { return dot(half.normal, bay.at) < half.bound - exact_; });
        };
        const auto bay = std::ranges::find_if(bays_, is_in);
        if (bay == bays_.end()) return whole;
        const bool to_the_end = std::ranges::count_if(bays_, is_in) <= few;
        std::vector<Outline> best;
        Corner along{};
        double largest = 0;
        for (const Corner& normal : bay->normals) {
            std::vector<Outline> found = on_both_sides(area, bay->at, normal, to_the_end);
            if (found.empty()) continue;
            const auto by_area = [](const Outline& one) { return area_of(one); };
            const double smallest = area_of(*std::ranges::min_element(found, {}, by_area));
            if (!(smallest > 1.001 * largest)) continue;  // those along the grid come first
            largest = smallest;
            along = normal;
            best = std::move(found);
        }
        if (best.empty()) return whole;
        return to_the_end ? best : on_both_sides(area, bay->at, along, true);
    }

    /// To make a rectangle of cells, by which stress below contacts on a rim is right (docs/fracture.md); of an outline
    /// with bays whatever is convex.
    bool may_join(const Block& a, const Block& b) const { return !bays_.empty() || make_a_rectangle(a, b); }

    /// The smallest first, so that a sliver joins a whole cell rather than another sliver. One that fits nowhere stays.
    void merge_small(std::vector<Piece>& pieces) const {
        std::vector<std::pair<double, Outline>> small;
        for (const Piece& one : pieces)
            if (const double area = area_of(one.corners); area < least_element_share * grid_.dx * grid_.dz)
                small.emplace_back(area, one.corners);
        std::ranges::stable_sort(small, {}, [](const auto& one) { return one.first; });
        for (const auto& [area, corners] : small) {
            const auto own = std::ranges::find(pieces, corners, &Piece::corners);
            if (own == pieces.end()) continue;  // another one joined it
            auto best = pieces.end();
            Outline together;
            double longest = 0;
            for (auto other = pieces.begin(); other != pieces.end(); ++other) {
                if (other == own || !may_join(own->block, other->block)) continue;
                const double length = shared(own->corners, other->corners, exact_).length;
                if (length <= (1 + 1e-9) * longest) continue;
                std::optional<Outline> both = united(own->corners, other->corners);
                if (!both || both->size() > most_corners) continue;
                longest = length;
                best = other;
                together = tidied(*both, least_);
            }
            if (best == pieces.end()) continue;
            *best = {united(best->block, own->block), std::move(together)};
            pieces.erase(own);
        }
    }

    /// A sliver beside a bay that fits nowhere takes what a neighbour has on its side of one of its edges' lines, so
    /// that the smaller of the two is as large as can be.
    void enlarge(std::vector<Piece>& pieces, std::size_t small) const {
        Outline larger;
        Outline left;
        std::size_t from = small;
        double smallest = area_of(pieces[small].corners);
        for (std::size_t n = 0; n < pieces.size(); ++n) {
            if (n == small || shared(pieces[small].corners, pieces[n].corners, exact_).length == 0) continue;
            for (std::size_t k = 0; k < pieces[small].corners.size(); ++k) {
                const Corner normal = outward(pieces[small].corners, k);
                const double bound = dot(normal, pieces[small].corners[k]);
                const Outline near = within(pieces[n].corners, {{normal, bound}}, least_);
                Outline beyond = within(pieces[n].corners, {{-1.0 * normal, -bound}}, least_);
                if (near.size() < 3 || beyond.size() < 3) continue;
                std::optional<Outline> both = united(pieces[small].corners, near);
                if (!both || both->size() > most_corners) continue;
                const double of = std::min(area_of(*both), area_of(beyond));
                if (of <= smallest) continue;
                smallest = of;
                larger = tidied(*both, least_);
                left = std::move(beyond);
                from = n;
            }
        }
        if (from == small) return;
        pieces[small].corners = std::move(larger);
        pieces[from].corners = std::move(left);
    }

    Grid grid_;
    double least_, exact_;  ///< m: shorter edges go; what is nearer is the same
    std::vector<Outline> parts_;
    std::vector<Bay> bays_;
};

bool lies_on(Corners outline, std::size_t edge, const Corner& point, double exact) {
    const Corner normal = outward(outline, edge);
    const Corner from = point - outline[edge];
    const double along = cross(normal, from);
    return std::abs(dot(normal, from)) < exact && along > -exact && along < edge_length(outline, edge) + exact;
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
            if (lies_on(outline, edge, middle, exact)) element.rim |= 1U << k;
    }
    return element;
}

}  // namespace

CutFloe cut_into_elements(Corners outline, double side) {
    const Cutter cutter(outline, side);
    const std::vector<Piece> pieces = cutter.pieces();
    CutFloe floe;
    for (const Piece& one : pieces) floe.elements.push_back(element_of(one.corners, outline, cutter.exact()));
    for (std::size_t a = 0; a < pieces.size(); ++a)
        for (std::size_t b = a + 1; b < pieces.size(); ++b) {
            const Shared common = shared(pieces[a].corners, pieces[b].corners, cutter.exact());
            if (!(common.length > cutter.shortest_joint())) continue;
            const Corner& from = floe.elements[a].centre;
            const Corner& to = floe.elements[b].centre;
            const double span = dot(common.normal, to - from);
            const double shift = dot(common.normal, 0.5 * (from + to) - common.middle);
            floe.joints.push_back({static_cast<int>(a), static_cast<int>(b), common.normal,
                                   common.middle + shift * common.normal, common.length, span, common.edge_a,
                                   common.edge_b});
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
    return static_cast<int>(Cutter(outline, side).pieces().size());
}

Quat turned_to(const Corner& axis) {
    // By half the angle φ of (x, z) = (cos φ, -sin φ), from roots only.
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + axis.x)));
    const double sine = std::sqrt(std::max(0.0, 0.5 * (1 - axis.x)));
    return Quat(cosine, 0, axis.z > 0 ? -sine : sine, 0).normalized();
}

}  // namespace floes
