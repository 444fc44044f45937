#include "campaign/hull_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/closed_bodies.hpp"
#include "core/error.hpp"

namespace floes {

namespace {

constexpr double flat = 1e-6;              // of the body's size: nearer than this is in a plane
constexpr double deep_enough = 1 / 500.0;  // likewise: less deep is not cut

struct Facet {
    std::vector<Vec3> corners;
    Plane plane;
    int group = 0;

    Vec3 middle() const {
        Vec3 sum = Vec3::Zero();
        for (const Vec3& corner : corners) sum += corner;
        return sum / static_cast<double>(corners.size());
    }
};

struct Part {
    Polyhedron cell;  ///< what the cuts so far leave of space
    std::vector<Facet> surface;
    Polyhedron hull;
    double depth = 0;  ///< of the deepest point of the surface in the hull, m
    Vec3 deepest = Vec3::Zero();
};

class Cutter {
  public:
    explicit Cutter(const Surface& body) : body_(&body) {
        Part whole;
        Box3 box;
        for (std::size_t t = 0; t < body.triangles.size(); ++t) {
            Facet facet{{body.corner(t, 0), body.corner(t, 1), body.corner(t, 2)}, {}, body.group[t]};
            box.extend(box_round(facet.corners));
            const Vec3 normal = (facet.corners[1] - facet.corners[0]).cross(facet.corners[2] - facet.corners[0]);
            if (!(normal.norm() > 0)) continue;
            facet.plane = {normal.normalized(), normal.normalized().dot(facet.middle())};
            whole.surface.push_back(std::move(facet));
        }
        size_ = box.diagonal().norm();
        const Vec3 wide = 0.01 * Vec3::Constant(size_);
        const Box3 wider(box.min() - wide, box.max() + wide);
        std::vector<Vec3> corners;
        for (int k = 0; k < 8; ++k) corners.push_back(wider.corner(static_cast<Box3::CornerType>(k)));
        whole.cell = convex_hull(corners);
        finish(whole);
        parts_.push_back(std::move(whole));
    }

    std::vector<Part> cut(std::size_t most) && {
        while (parts_.size() < most) {
            const auto worst = std::ranges::max_element(parts_, {}, &Part::depth);
            if (worst->depth <= deep_enough * size_) break;
            std::optional<std::pair<Part, Part>> halves = best_cut(*worst);
            if (!halves) {
                worst->depth = 0;  // it stays as it is
                continue;
            }
            *worst = std::move(halves->first);
            parts_.push_back(std::move(halves->second));
        }
        return std::move(parts_);
    }

    double size() const { return size_; }

  private:
    void find_hull(Part& part) const {
        std::vector<Vec3> points;
        for (const Facet& facet : part.surface) points.insert(points.end(), facet.corners.begin(), facet.corners.end());
        for (const Vec3& corner : part.cell.corners)  // corners that cuts alone make, inside the body
            if (encloses(*body_, corner)) points.push_back(corner);
        part.hull = convex_hull(points);
    }

    void find_depth(Part& part) const {
        part.depth = 0;
        const auto probe = [&](const Vec3& point) {
            double depth = size_;
            for (const Plane& plane : part.hull.planes) {
                depth = std::min(depth, -plane.height(point));
                if (depth <= part.depth) return;
            }
            part.depth = depth;
            part.deepest = point;
        };
        for (const Facet& facet : part.surface) {
            for (const Vec3& corner : facet.corners) probe(corner);
            probe(facet.middle());
            for (std::size_t k = 0; k < facet.corners.size(); ++k)
                probe(0.5 * (facet.corners[k] + facet.corners[(k + 1) % facet.corners.size()]));
        }
    }

    void finish(Part& part) const {
        find_hull(part);
        if (!part.hull.empty()) find_depth(part);
    }

    /// The side of the facet where the plane's normal points from; other sides by turning the plane.
    Facet below(const Facet& facet, const Plane& plane) const {
        const double slack = flat * size_;
        Facet kept{{}, facet.plane, facet.group};
        bool any = false;
        for (std::size_t k = 0; k < facet.corners.size(); ++k) {
            const Vec3& a = facet.corners[k];
            const Vec3& b = facet.corners[(k + 1) % facet.corners.size()];
            const double low = plane.height(a);
            const double high = plane.height(b);
            any = any || low < -slack;
            if (low <= slack) kept.corners.push_back(a);
            if ((low < -slack && high > slack) || (low > slack && high < -slack))
                kept.corners.emplace_back(a + (b - a) * (low / (low - high)));
        }
        const bool lies_in = std::ranges::all_of(
            facet.corners, [&](const Vec3& corner) { return std::abs(plane.height(corner)) <= slack; });
        if (lies_in ? facet.plane.normal.dot(plane.normal) < 0 : !any) kept.corners.clear();
        return kept;
    }

    Part half(const Part& part, const Plane& plane) const {
        Part side;
        side.cell = part.cell.cut(plane);
        for (const Facet& facet : part.surface)
            if (Facet kept = below(facet, plane); kept.corners.size() >= 3) side.surface.push_back(std::move(kept));
        if (!side.surface.empty() && !side.cell.empty()) find_hull(side);
        return side;
    }

    std::vector<Plane> planes_at(const Part& part) const {
        std::vector<Plane> planes;
        const auto add = [&](const Vec3& normal) {
            const auto same = [&](const Plane& one) { return std::abs(one.normal.dot(normal)) > 1 - 1e-9; };
            if (std::ranges::none_of(planes, same)) planes.push_back({normal, normal.dot(part.deepest)});
        };
        for (const Facet& facet : part.surface) {
            const bool touches =
                std::abs(facet.plane.height(part.deepest)) <= flat * size_ &&
                std::ranges::any_of(facet.corners, [&, k = std::size_t{0}](const Vec3& corner) mutable {
                    const Vec3& next = facet.corners[++k % facet.corners.size()];
                    const Vec3 along = next - corner;
                    const double share = std::clamp((part.deepest - corner).dot(along) / along.squaredNorm(), 0.0, 1.0);
                    return (corner + share * along - part.deepest).norm() <= flat * size_;
                });
            if (touches && planes.size() < 12) add(facet.plane.normal);
        }
        for (int axis = 0; axis < 3; ++axis) add(Vec3::Unit(axis));
        return planes;
    }

    std::optional<std::pair<Part, Part>> best_cut(const Part& part) const {
        std::optional<std::pair<Part, Part>> best;
        double least = part.hull.volume();
        for (const Plane& plane : planes_at(part)) {
            Part low = half(part, plane);
            Part high = half(part, plane.opposite());
            if (low.hull.empty() || high.hull.empty()) continue;
            const double volume = low.hull.volume() + high.hull.volume();
            if (volume >= least * (1 - 1e-9)) continue;
            least = volume;
            best.emplace(std::move(low), std::move(high));
        }
        if (best) {
            find_depth(best->first);
            find_depth(best->second);
        }
        return best;
    }

    const Surface* body_;
    double size_ = 0;
    std::vector<Part> parts_;
};

int largest(const std::map<int, double>& areas) {
    const auto found = std::ranges::max_element(areas, {}, [](const auto& one) { return one.second; });
    return found == areas.end() ? -1 : found->first;
}

ConvexPiece piece_of(const Part& part, double size) {
    ConvexPiece piece{part.hull, {}, 0};
    // Until its corners are all that it is made of: whoever makes it of its corners again finds the same faces.
    for (int again = 0; again < 3; ++again) piece.body = convex_hull(std::vector<Vec3>(piece.body.corners));
    std::map<int, double> all;
    for (const Facet& facet : part.surface) all[facet.group] += floes::area_of(facet.corners);
    piece.group = largest(all);
    for (const Plane& face : piece.body.planes) {
        std::map<int, double> areas;
        for (const Facet& facet : part.surface)
            if (facet.plane.normal.dot(face.normal) > 0.99 &&
                std::abs(face.height(facet.middle())) <= 2 * deep_enough * size)
                areas[facet.group] += floes::area_of(facet.corners);
        piece.face_groups.push_back(largest(areas));
    }
    return piece;
}

}  // namespace

std::vector<ConvexPiece> convex_pieces(const Surface& body, std::size_t most) {
    Cutter cutter(body);
    const double size = cutter.size();
    std::vector<ConvexPiece> pieces;
    for (const Part& part : std::move(cutter).cut(most))
        if (!part.hull.empty()) pieces.push_back(piece_of(part, size));
    return pieces;
}

namespace {

constexpr std::size_t most_pieces = most_bodies;  // of all together
constexpr double smallest_size = 0.01;            // m
constexpr double largest_size = 5e3;

Vec3 direction(HullAxis axis) {
    const int number = static_cast<int>(axis);
    return (number % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(number / 2);
}

/// Bounds of what the surfaces cut out of the water.
Box2 waterline_bounds(const std::vector<Surface>& bodies) {
    Box2 box;
    for (const Surface& body : bodies)
        for (std::size_t t = 0; t < body.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& a = body.corner(t, k);
                const Vec3& b = body.corner(t, (k + 1) % 3);
                if ((a.y() <= 0) == (b.y() <= 0)) continue;
                const Vec3 at = a + (b - a) * (a.y() / (a.y() - b.y()));
                box.extend(Vec2(at.x(), at.z()));
            }
    return box;
}

/// Into m, with x ahead and y up from the waterline, about the middle of the waterline's bounds.
void turn(std::vector<Surface>& bodies, const HullFile& file, const std::string& name) {
    const Vec3 up = direction(file.up);
    const Vec3 ahead = direction(file.forward);
    if (up.dot(ahead) != 0)
        throw InputError("{}: hull.up and hull.forward are the same axis; they must be at right angles", name);
    const Vec3 aside = ahead.cross(up);
    Box3 box;
    for (Surface& body : bodies)
        for (Vec3& point : body.points) {
            const Vec3 at = metres(file.unit) * point;
            point = {at.dot(ahead), at.dot(up) - file.waterline, at.dot(aside)};
            box.extend(point);
        }
    const double size = box.diagonal().norm();
    if (!(size > smallest_size && size < largest_size))
        throw InputError(
            "{}: the hull is {:.4g} m from corner to corner, which is none of a structure; is hull.unit right?", name,
            size);
    if (!(box.min().y() < 0 && box.max().y() > 0))
        throw InputError(
            "{}: the hull reaches from {:.4g} m to {:.4g} m above the waterline, so it does not stand in the water; "
            "set hull.waterline_m, hull.up or hull.unit",
            name, box.min().y(), box.max().y());
    const Vec2 middle = waterline_bounds(bodies).center();
    for (Surface& body : bodies)
        for (Vec3& point : body.points) point -= Vec3(middle.x(), 0, middle.y());
}

/// The names of the groups, or of the bodies where there is one group only.
std::vector<std::string> part_names(std::vector<std::string> names, std::size_t bodies) {
    for (std::size_t k = 0; k < names.size(); ++k)
        if (names[k].find_first_not_of(" \t") == std::string::npos) names[k] = fmt::format("group {}", k + 1);
    if (names.size() > 1) return names;
    if (bodies == 1) return {"hull"};
    names.clear();
    for (std::size_t k = 0; k < bodies; ++k) names.push_back(fmt::format("body {}", k + 1));
    return names;
}

void take_bodies(Structure& structure, const std::vector<Surface>& bodies) {
    const std::vector<std::string>& groups = bodies.front().groups;
    const std::vector<std::string> names = part_names(groups, bodies.size());
    const bool by_body = groups.size() == 1 && bodies.size() > 1;
    std::vector<std::vector<double>> corners;
    std::vector<std::vector<double>> faces;
    double volume = 0;
    double piece = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        volume += volume_of(bodies[k]);
        for (const ConvexPiece& one : convex_pieces(bodies[k], most_pieces / bodies.size())) {
            const double part = static_cast<double>(by_body ? static_cast<int>(k) : one.group);
            for (const Vec3& corner : one.body.corners)
                corners.push_back({piece, part, corner.x(), corner.y(), corner.z()});
            for (std::size_t f = 0; f < one.face_groups.size() && !by_body; ++f)
                if (one.face_groups[f] >= 0 && one.face_groups[f] != one.group)
                    faces.push_back({piece, static_cast<double>(f), static_cast<double>(one.face_groups[f])});
            ++piece;
        }
    }
    if (corners.empty()) throw InputError("its surface encloses nothing; export a solid");
    structure.shape.set_pieces(corners);
    structure.shape.set_faces(faces);
    structure.shape.part_list() = fmt::format("{}", fmt::join(names, ", "));
    HullFile& file = structure.hull_file;
    file = {.path = "", .most_added = file.most_added, .volume = volume};
}

}  // namespace

void take_hull(Structure& structure, const std::string& bytes, const std::string& name) {
    std::vector<Surface> bodies = closed_bodies(read_surface(bytes, name), name);
    turn(bodies, structure.hull_file, name);
    try {
        take_bodies(structure, bodies);
    } catch (const InputError& error) {
        throw InputError("{}: {}", name, error.what());
    }
}

}  // namespace floes
