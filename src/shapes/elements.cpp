#include "shapes/elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "shapes/drawn.hpp"

namespace floes {
namespace {

/// What lies within all of these.
using Area = std::vector<HalfPlane>;

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

Shared shared(Corners a, Corners b, double exact) {
    Shared found;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Corner normal = outward(a, i);
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

/// Points relax by steps of Lloyd's until cells are much alike: no corner is below 60 degrees, and no area beyond these
/// shares of the mean. Six steps are enough as a rule; fifty turn nine cells in a square into a grid along its sides.
constexpr int most_relaxations = 50;
constexpr int relaxations_with_bays = 6;
constexpr double cosine_of_most_turn = -0.5;
constexpr double least_area_share = 0.6;
constexpr double most_area_share = 1.5;

std::size_t cell_count(double area, double side) {
    return static_cast<std::size_t>(std::max(1L, std::lround(area / (side * side))));
}

WaterArea box_of(Corners outline) {
    const Box2 box = box_round(outline);
    return {box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y()};
}

/// Faces shorter than this share of an element's side carry no joint.
constexpr double least_joint_share = 0.05;

/// m: shorter edges go; what is nearer than the second is the same.
double least_of(double side) {
    return 2e-7 * side;
}
double exact_of(double side) {
    return 10 * least_of(side);
}

class Cutter {
  public:
    Cutter(Corners outline, double side)
        : side_(side),
          least_(least_of(side)),
          exact_(exact_of(side)),
          area_(area_of(outline)),
          box_(box_of(outline)),
          parts_(convex_parts(outline)) {
        for (std::size_t k = 0; parts_.size() > 1 && k < outline.size(); ++k) {
            const std::size_t before = k > 0 ? k - 1 : outline.size() - 1;
            if (!(cross(outline[k] - outline[before], after(outline, k) - outline[k]) < 0)) continue;
            const Corner one = outward(outline, before);
            const Corner other = outward(outline, k);
            const Corner between = other - one;
            bays_.push_back(Bay{outline[k], {(1 / std::sqrt(dot(between, between))) * between, one, other}});
        }
    }

    double exact() const { return exact_; }

    /// Convex pieces of the Voronoi cells of points that relaxed in the outline, row after row.
    std::vector<Outline> pieces(std::uint32_t pattern) const {
        std::vector<Outline> pieces;
        for (const Area& cell : cells(pattern))
            for (Outline& one : cut(cell)) pieces.push_back(std::move(one));
        merge_small(pieces);
        for (std::size_t n = 0; n < pieces.size(); ++n)
            if (!bays_.empty() && area_of(pieces[n]) < least_share_beside_bays * side_ * side_) enlarge(pieces, n);
        const double low = box_.low_z;
        const auto place = [&](const Outline& one) {
            const Corner middle = measures_of(one).centroid;
            return std::pair(std::floor((middle.z - low) / side_), middle.x);
        };
        std::ranges::stable_sort(pieces, {}, place);
        return pieces;
    }

  private:
    /// Where the outline bends inwards, and normals of lines through there that may part its two sides: halfway between
    /// its edges, and those of either.
    struct Bay {
        Corner at;
        std::array<Corner, 3> normals;
    };

    /// The parts of the outline within, without those that are nothing but rounding.
    std::vector<Outline> parts_in(const Area& area) const {
        std::vector<Outline> found;
        for (const Outline& part : parts_)
            if (Outline left = within(part, area, least_); left.size() >= 3 && area_of(left) > least_ * side_)
                found.push_back(std::move(left));
        return found;
    }

    Corner middle_of(const Area& area, const Corner& otherwise) const {
        double sum = 0;
        Corner middle{};
        for (const Outline& part : parts_in(area)) {
            const Measures measures = measures_of(part);
            sum += measures.area;
            middle = middle + measures.area * measures.centroid;
        }
        return sum > 0 ? (1 / sum) * middle : otherwise;
    }

    /// By areas, and by corners where the outline itself has none.
    bool are_alike(const std::vector<Area>& cells, int step) const {
        if (!bays_.empty()) return step == relaxations_with_bays;
        const Outline& outline = parts_.front();
        const double mean = area_ / static_cast<double>(cells.size());
        return std::ranges::all_of(cells, [&](const Area& area) {
            const Outline cell = within(outline, area, least_);
            const double share = area_of(cell) / mean;
            if (share < least_area_share || share > most_area_share) return false;
            for (std::size_t k = 0; k < cell.size(); ++k) {
                const auto is_own = [&](const Corner& one) {
                    return dot(one - cell[k], one - cell[k]) < least_ * least_;
                };
                const std::size_t before = k > 0 ? k - 1 : cell.size() - 1;
                if (dot(outward(cell, before), outward(cell, k)) < cosine_of_most_turn &&
                    std::ranges::none_of(outline, is_own))
                    return false;
            }
            return true;
        });
    }

    /// Cells of a relaxed Voronoi diagram of as many points as the outline has elements (Lloyd).
    std::vector<Area> cells(std::uint32_t pattern) const {
        RandomStream random(0, pattern, StreamId::elements, 0);
        std::vector<Corner> points;
        while (points.size() < cell_count(area_, side_)) {
            const Corner point = thrown_points(box_, 1, random).front();
            if (std::ranges::any_of(parts_, [&](const Outline& part) { return contains(part, point); }))
                points.push_back(point);
        }
        // Beyond the outline, so that no cell ends at the box.
        const WaterArea box{box_.low_x - side_, box_.low_z - side_, box_.length + 2 * side_, box_.breadth + 2 * side_};
        for (int step = 0;; ++step) {
            std::vector<Area> found;
            for (const Outline& cell : voronoi_cells(box, points)) {
                Area& area_of_cell = found.emplace_back();
                for (std::size_t k = 0; k < cell.size(); ++k) {
                    const Corner normal = outward(cell, k);
                    area_of_cell.push_back({normal, dot(normal, cell[k])});
                }
            }
            if (step == most_relaxations || (step > 0 && are_alike(found, step))) return found;
            for (std::size_t n = 0; n < points.size(); ++n) points[n] = middle_of(found[n], points[n]);
        }
    }

    /// What lies within, with as few pieces as pairs allow.
    std::vector<Outline> joined_parts(const Area& area) const {
        std::vector<Outline> found = joined(parts_in(area));
        for (Outline& one : found) one = tidied(one, least_);
        return found;
    }

    bool hang_together(const std::vector<Outline>& pieces) const {
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (std::size_t k = i + 1; k < pieces.size(); ++k)
                if (shared(pieces[i], pieces[k], exact_).length > exact_) return true;
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
            if (!(smallest > 1.001 * largest)) continue;
            largest = smallest;
            along = normal;
            best = std::move(found);
        }
        if (best.empty()) return whole;
        return to_the_end ? best : on_both_sides(area, bay->at, along, true);
    }

    /// The smallest first, so that a sliver joins a whole cell rather than another sliver. One that fits nowhere stays.
    void merge_small(std::vector<Outline>& pieces) const {
        std::vector<std::pair<double, Outline>> small;
        for (const Outline& one : pieces)
            if (const double area = area_of(one); area < least_element_share * side_ * side_)
                small.emplace_back(area, one);
        std::ranges::stable_sort(small, {}, [](const auto& one) { return one.first; });
        for (const auto& [area, corners] : small) {
            const auto own = std::ranges::find(pieces, corners);
            if (own == pieces.end()) continue;  // another one joined it
            auto best = pieces.end();
            Outline together;
            double longest = 0;
            for (auto other = pieces.begin(); other != pieces.end(); ++other) {
                if (other == own) continue;
                const double length = shared(*own, *other, exact_).length;
                if (length <= (1 + 1e-9) * longest) continue;
                std::optional<Outline> both = united(*own, *other);
                if (!both || both->size() > most_corners) continue;
                longest = length;
                best = other;
                together = tidied(*both, least_);
            }
            if (best == pieces.end()) continue;
            *best = std::move(together);
            pieces.erase(own);
        }
    }

    /// A sliver beside a bay that fits nowhere takes what a neighbour has on its side of one of its edges' lines, so
    /// that the smaller of the two is as large as can be.
    void enlarge(std::vector<Outline>& pieces, std::size_t small) const {
        Outline larger;
        Outline left;
        std::size_t from = small;
        double smallest = area_of(pieces[small]);
        for (std::size_t n = 0; n < pieces.size(); ++n) {
            if (n == small || shared(pieces[small], pieces[n], exact_).length == 0) continue;
            for (std::size_t k = 0; k < pieces[small].size(); ++k) {
                const Corner normal = outward(pieces[small], k);
                const double bound = dot(normal, pieces[small][k]);
                const Outline near = within(pieces[n], {{normal, bound}}, least_);
                Outline beyond = within(pieces[n], {{-1.0 * normal, -bound}}, least_);
                if (near.size() < 3 || beyond.size() < 3) continue;
                std::optional<Outline> both = united(pieces[small], near);
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
        pieces[small] = std::move(larger);
        pieces[from] = std::move(left);
    }

    double side_;
    double least_, exact_;
    double area_;
    WaterArea box_;
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

bool are_apart(const Box2& a, const Box2& b, double gap) {
    return (a.min().array() > b.max().array() + gap).any() || (b.min().array() > a.max().array() + gap).any();
}

}  // namespace

double least_joint(double side) {
    return least_joint_share * side;
}

std::optional<CutJoint> joint_between(Corners a, const Corner& centre_a, Corners b, const Corner& centre_b,
                                      double side) {
    const Shared common = shared(a, b, exact_of(side));
    if (!(common.length > least_joint(side))) return {};
    const double span = dot(common.normal, centre_b - centre_a);
    const double shift = dot(common.normal, 0.5 * (centre_a + centre_b) - common.middle);
    return CutJoint{.normal = common.normal,
                    .pivot = common.middle + shift * common.normal,
                    .length = common.length,
                    .span = span,
                    .edge_a = common.edge_a,
                    .edge_b = common.edge_b};
}

CutFloe cut_into_cells(Corners outline, double side, std::uint32_t pattern) {
    const Cutter cutter(outline, side);
    const std::vector<Outline> pieces = cutter.pieces(pattern);
    CutFloe floe;
    std::vector<Box2> boxes;
    for (const Outline& one : pieces) boxes.push_back(box_round(one));
    for (const Outline& one : pieces) floe.elements.push_back(element_of(one, outline, cutter.exact()));
    for (std::size_t a = 0; a < pieces.size(); ++a)
        for (std::size_t b = a + 1; b < pieces.size(); ++b) {
            if (are_apart(boxes[a], boxes[b], 2 * cutter.exact())) continue;  // most are, and sharing edges costs
            std::optional<CutJoint> joint =
                joint_between(pieces[a], floe.elements[a].centre, pieces[b], floe.elements[b].centre, side);
            if (!joint) continue;
            joint->a = static_cast<int>(a);
            joint->b = static_cast<int>(b);
            floe.joints.push_back(*joint);
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

int count_cells(Corners outline, double side) {
    if (is_convex(outline)) return static_cast<int>(cell_count(area_of(outline), side));
    return static_cast<int>(Cutter(outline, side).pieces(0).size());
}

Quat turned_to(const Corner& axis) {
    // By half the angle φ of (x, z) = (cos φ, -sin φ), from roots only.
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + axis.x)));
    const double sine = std::sqrt(std::max(0.0, 0.5 * (1 - axis.x)));
    return Quat(cosine, 0, axis.z > 0 ? -sine : sine, 0).normalized();
}

}  // namespace floes
