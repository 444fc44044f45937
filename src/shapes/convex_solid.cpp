// How the hull of points is found: it grows point by point; the farthest one outside a face joins, the faces that it
// sees go, and new ones lead from it to their rim (Barber, Dobkin and Huhdanpaa, ACM Trans. Math. Software 22, 1996,
// cited from memory).

#include "shapes/convex_solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/error.hpp"

namespace floes {

namespace {

/// Volume and first moments of the tetrahedra from the first corner to the triangles of the faces.
std::pair<double, Vec3> measures(const Polyhedron& body) {
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    const Vec3 apex = body.empty() ? Vec3::Zero() : body.corners.front();
    for (const std::vector<int>& face : body.faces) {
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            const Vec3 a = body.corner(face, 0) - apex;
            const Vec3 b = body.corner(face, k) - apex;
            const Vec3 c = body.corner(face, k + 1) - apex;
            const double part = a.dot(b.cross(c)) / 6;
            volume += part;
            moment += part * (a + b + c) / 4;
        }
    }
    return {volume, moment};
}

}  // namespace

Vec3 Polyhedron::farthest(const Vec3& direction) const {
    const Vec3* best = &corners.front();
    double reach = best->dot(direction);
    for (const Vec3& corner : corners) {
        const double here = corner.dot(direction);
        if (here <= reach) continue;
        reach = here;
        best = &corner;
    }
    return *best;
}

double Polyhedron::volume() const {
    return measures(*this).first;
}

Vec3 Polyhedron::centroid() const {
    const auto [volume, moment] = measures(*this);
    return corners.front() + moment / volume;
}

Polyhedron Polyhedron::inside(double depth) const {
    if (empty()) return {};
    std::vector<Plane> within = planes;
    for (Plane& plane : within) plane.offset -= depth;
    return intersection(within, centroid());
}

Polyhedron Polyhedron::scaled(double factor) const {
    FLOES_EXPECTS(factor > 0);
    Polyhedron other = *this;
    for (Vec3& corner : other.corners) corner *= factor;
    for (Plane& plane : other.planes) plane.offset *= factor;
    return other;
}

Polyhedron Polyhedron::cut(const Plane& plane, double slack) const {
    std::vector<Vec3> kept;
    for (const Vec3& corner : corners)
        if (plane.height(corner) <= slack) kept.push_back(corner);
    if (kept.size() == corners.size()) return *this;
    if (std::ranges::all_of(kept, [&](const Vec3& corner) { return plane.height(corner) >= -slack; })) return {};
    for (const std::vector<int>& face : faces) {
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vec3& a = corner(face, k);
            const Vec3& b = corner(face, k + 1);
            const double low = plane.height(a);
            const double high = plane.height(b);
            if (low < -slack && high > slack) kept.emplace_back(a + (b - a) * (low / (low - high)));
        }
    }
    return convex_hull(kept);
}

std::vector<Vec2> Polyhedron::section(double y) const {
    std::vector<Vec2> crossed;
    for (const std::vector<int>& face : faces) {
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vec3& a = corner(face, k);
            const Vec3& b = corner(face, k + 1);
            if (a.y() == y) crossed.emplace_back(a.x(), a.z());
            if ((a.y() < y) == (b.y() < y) || a.y() == y || b.y() == y) continue;
            const double share = (y - a.y()) / (b.y() - a.y());
            crossed.emplace_back(a.x() + share * (b.x() - a.x()), a.z() + share * (b.z() - a.z()));
        }
    }
    return convex_outline(std::move(crossed));
}

// Andrew's monotone chain.
std::vector<Vec2> convex_outline(std::vector<Vec2> points) {
    const auto less = [](const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); };
    std::ranges::sort(points, less);
    points.erase(std::ranges::unique(points).begin(), points.end());
    if (points.size() < 3) return {};
    const auto turns = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0;
    };
    std::vector<Vec2> outline;
    const auto add_chain = [&](auto begin, auto end) {
        const std::size_t start = outline.size();
        for (auto point = begin; point != end; ++point) {
            while (outline.size() >= start + 2 && !turns(outline[outline.size() - 2], outline.back(), *point))
                outline.pop_back();
            outline.push_back(*point);
        }
        outline.pop_back();
    };
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return outline.size() < 3 ? std::vector<Vec2>{} : outline;
}

double area_of(std::span<const Vec2> outline) {
    double twice = 0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2& a = outline[k];
        const Vec2& b = outline[(k + 1) % outline.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

double area_of(std::span<const Vec3> polygon) {
    Vec3 twice = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        twice += (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
    return 0.5 * twice.norm();
}

namespace {

double frustum_volume(double height, double a, double b) {
    FLOES_EXPECTS(height >= 0 && a >= 0 && b >= 0);
    return std::numbers::pi / 3 * height * (a * a + a * b + b * b);
}

template <class Points>
void add_ring(Points& points, double radius, int sides, auto point_at) {
    for (int side = 0; side < (radius > 0 ? sides : 1); ++side) {
        const double angle = 2 * std::numbers::pi * side / sides;
        points.push_back(point_at(radius * std::cos(angle), radius * std::sin(angle)));
    }
}

}  // namespace

std::optional<std::string> Frustum::fault() const {
    if (!(top_height > bottom_height))
        return fmt::format("the height of a frustum is {}; it must be above 0 m", top_height - bottom_height);
    if (!(bottom_radius >= 0 && top_radius >= 0))
        return fmt::format("the smaller radius of a frustum is {}; it must be at least 0 m",
                           std::fmin(bottom_radius, top_radius));
    if (!(bottom_radius + top_radius > 0)) return "the larger radius of a frustum is 0; it must be above 0 m";
    return std::nullopt;
}

Vec3 Frustum::farthest(const Vec3& direction) const {
    const double across = std::sqrt(direction.x() * direction.x() + direction.z() * direction.z());
    const double bottom = bottom_radius * across + bottom_height * direction.y();
    const double top = top_radius * across + top_height * direction.y();
    const double radius = top > bottom ? top_radius : bottom_radius;
    const double height = top > bottom ? top_height : bottom_height;
    if (across == 0) return {radius, height, 0};
    return {radius * direction.x() / across, height, radius * direction.z() / across};
}

Frustum Frustum::inside(double depth) const {
    const double rise = top_height - bottom_height;
    const double spread = top_radius - bottom_radius;
    const double inset = depth * std::hypot(rise, spread) / rise;  // along the radius
    Frustum core = *this;
    core.bottom_radius = std::max(0.0, bottom_radius - inset);
    core.top_radius = std::max(0.0, top_radius - inset);
    // Where the wall meets the axis the tip moves along it.
    if (bottom_radius < inset) core.bottom_height += std::min(rise, (inset - bottom_radius) * rise / std::abs(spread));
    if (top_radius < inset) core.top_height -= std::min(rise, (inset - top_radius) * rise / std::abs(spread));
    return core;
}

double Frustum::radius_at(double height) const {
    const double share = (height - bottom_height) / (top_height - bottom_height);
    return bottom_radius + share * (top_radius - bottom_radius);
}

std::optional<std::string> ConvexSolid::fault() const {
    if (const auto* round = std::get_if<Frustum>(&form)) return round->fault();
    if (std::get<Polyhedron>(form).empty()) return "a solid of the structure has all its points in one plane";
    return std::nullopt;
}

Vec3 ConvexSolid::farthest(const Vec3& direction) const {
    return std::visit([&](const auto& one) { return one.farthest(direction); }, form);
}

ConvexSolid ConvexSolid::inside(double depth) const {
    ConvexSolid core = *this;
    if (auto* round = std::get_if<Frustum>(&core.form))
        *round = round->inside(depth);
    else if (Polyhedron thin = std::get<Polyhedron>(form).inside(depth); !thin.empty())
        core.form = std::move(thin);
    return core;
}

ConvexSolid ConvexSolid::scaled(double factor) const {
    FLOES_EXPECTS(factor > 0);
    ConvexSolid other = *this;
    other.place *= factor;
    std::visit([&](auto& one) { one = one.scaled(factor); }, other.form);
    return other;
}

int ConvexSolid::part_at(const Vec3& point) const {
    if (face_parts.empty()) return part;
    const std::vector<Plane>& planes = std::get<Polyhedron>(form).planes;
    const Vec3 here = point - place;
    const auto nearest = std::ranges::max_element(planes, {}, [&](const Plane& one) { return one.height(here); });
    return face_parts[static_cast<std::size_t>(nearest - planes.begin())];
}

double ConvexSolid::volume() const {
    if (const auto* round = std::get_if<Frustum>(&form))
        return frustum_volume(round->top_height - round->bottom_height, round->bottom_radius, round->top_radius);
    return std::get<Polyhedron>(form).volume();
}

std::vector<Vec2> ConvexSolid::section(double height, int sides) const {
    const double level = height - place.y();
    std::vector<Vec2> outline;
    if (const auto* round = std::get_if<Frustum>(&form)) {
        if (level < round->bottom_height || level > round->top_height) return {};
        add_ring(outline, round->radius_at(level), sides, [](double x, double z) { return Vec2(x, z); });
    } else {
        outline = std::get<Polyhedron>(form).section(level);
    }
    for (Vec2& point : outline) point += Vec2(place.x(), place.z());
    return outline;
}

std::vector<Vec3> ConvexSolid::corners(int sides) const {
    std::vector<Vec3> points;
    if (const auto* round = std::get_if<Frustum>(&form)) {
        for (const auto& [radius, height] :
             {std::pair{round->bottom_radius, round->bottom_height}, std::pair{round->top_radius, round->top_height}})
            add_ring(points, radius, sides, [&](double x, double z) { return Vec3(x, height, z); });
    } else {
        points = std::get<Polyhedron>(form).corners;
    }
    for (Vec3& point : points) point += place;
    return points;
}

namespace {

constexpr double flatness = 2e-7;  // of the size of the body

using Edge = std::pair<int, int>;
using Owners = std::vector<std::pair<Edge, std::size_t>>;  ///< the triangle of each edge, in order

struct Triangle {
    std::array<int, 3> corners{};
    Plane plane;
    std::vector<int> outside;  ///< points above it that no earlier triangle has
    bool alive = true;

    std::array<Edge, 3> edges() const {
        return {Edge{corners[0], corners[1]}, {corners[1], corners[2]}, {corners[2], corners[0]}};
    }
};

/// Those of triangles' edges that none of them has the other way round, in order.
std::vector<Edge> rim_of(std::vector<Edge> edges) {
    std::ranges::sort(edges);
    std::vector<Edge> rim;
    for (const auto& [a, b] : edges)
        if (!std::ranges::binary_search(edges, Edge{b, a})) rim.emplace_back(a, b);
    return rim;
}

// With differences below 2^25 a vector product is below 2^52, so exact in doubles too, and a determinant below 2^78.
__extension__ using LongWhole = __int128;
constexpr double lattice_places = 1 << 24;
constexpr int lattice_jitter = 64;

class Growth {
  public:
    /// What is above a triangle: what is so by more than rounding; or, of points on a lattice of whole numbers, none of
    /// them in a plane with three others, what is so at all, which no rounding can decide.
    enum class Above { by_rounding, on_lattice };

    explicit Growth(std::span<const Vec3> points, Above above = Above::by_rounding)
        : points_(points),
          above_(above),
          rounding_(above == Above::by_rounding ? flatness * box_round(points).diagonal().norm() : 2 * lattice_jitter) {
    }

    /// Empty for points in a plane; nothing where points nearer to each other than rounding leave no body.
    std::optional<Polyhedron> grown() {
        if (!begin()) return Polyhedron{};
        const std::size_t most = 1000 + 100 * points_.size();  // a whole hull takes far fewer
        for (std::size_t k = 0; k < triangles_.size(); ++k) {
            while (triangles_[k].alive && !triangles_[k].outside.empty()) add_farthest(k);
            if (triangles_.size() > most) return {};
        }
        std::erase_if(triangles_, [](const Triangle& one) { return !one.alive; });
        Polyhedron body = with_faces(true);
        if (is_whole(body)) return body;
        if (above_ == Above::by_rounding) return {};
        body = with_faces(false);
        if (is_whole(body)) return body;
        return {};
    }

  private:
    const Vec3& at(int k) const { return points_[static_cast<std::size_t>(k)]; }

    bool is_above(const Triangle& one, const Vec3& point) const {
        if (above_ == Above::by_rounding) return one.plane.height(point) > rounding_;
        const double height = one.plane.height(point);
        if (std::abs(height) > 0.01) return height > 0;  // of a place of the lattice: rounding is far below that
        using Whole = Eigen::Matrix<std::int64_t, 3, 1>;
        const Vec3& a = at(one.corners[0]);
        const Whole u = (at(one.corners[1]) - a).cast<std::int64_t>();
        const Whole normal = u.cross((at(one.corners[2]) - a).cast<std::int64_t>());
        const Whole w = (point - a).cast<std::int64_t>();
        return LongWhole{normal.x()} * w.x() + LongWhole{normal.y()} * w.y() + LongWhole{normal.z()} * w.z() > 0;
    }

    template <class Measure>
    std::pair<int, double> largest(Measure measure) const {
        std::pair<int, double> best{0, -1};
        for (int k = 0; k < static_cast<int>(points_.size()); ++k)
            if (const double value = measure(at(k)); value > best.second) best = {k, value};
        return best;
    }

    /// Four points that span a body; false if there are none.
    bool begin() {
        const auto less = [](const Vec3& a, const Vec3& b) {
            return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
        };
        const int first = static_cast<int>(std::ranges::min_element(points_, less) - points_.begin());
        const auto [second, length] = largest([&](const Vec3& p) { return (p - at(first)).norm(); });
        if (!(length > rounding_)) return false;
        const Vec3 along = (at(second) - at(first)).normalized();
        const auto [third, breadth] = largest([&](const Vec3& p) { return along.cross(p - at(first)).norm(); });
        if (!(breadth > rounding_)) return false;
        const Vec3 normal = along.cross(at(third) - at(first)).normalized();
        const auto [fourth, height] = largest([&](const Vec3& p) { return std::abs(normal.dot(p - at(first))); });
        if (!(height > rounding_)) return false;
        const bool above = normal.dot(at(fourth) - at(first)) > 0;
        const std::array<int, 3> base =
            above ? std::array<int, 3>{first, third, second} : std::array<int, 3>{first, second, third};
        add({base[0], base[1], base[2]});
        for (const auto& [a, b] : Triangle{base, {}, {}}.edges()) add({b, a, fourth});
        std::vector<int> all(points_.size());
        std::iota(all.begin(), all.end(), 0);
        share_out(all, 0);
        return true;
    }

    void add(const std::array<int, 3>& corners) {
        const Vec3& a = at(corners[0]);
        const Vec3 normal = (at(corners[1]) - a).cross(at(corners[2]) - a).normalized();
        triangles_.push_back({corners, {normal, normal.dot((a + at(corners[1]) + at(corners[2])) / 3)}, {}});
    }

    /// Points outside go to the first triangle from `from` on that they are above.
    void share_out(const std::vector<int>& points, std::size_t from) {
        for (const int point : points) {
            for (std::size_t k = from; k < triangles_.size(); ++k) {
                if (!triangles_[k].alive || !is_above(triangles_[k], at(point))) continue;
                triangles_[k].outside.push_back(point);
                break;
            }
        }
    }

    void add_farthest(std::size_t below) {
        const Triangle& face = triangles_[below];
        const int point =
            *std::ranges::max_element(face.outside, {}, [&](int one) { return face.plane.height(at(one)); });
        std::vector<Edge> seen;
        std::vector<int> orphans;
        for (Triangle& one : triangles_) {
            if (!one.alive || !is_above(one, at(point))) continue;
            one.alive = false;
            for (const Edge& edge : one.edges()) seen.push_back(edge);
            orphans.insert(orphans.end(), one.outside.begin(), one.outside.end());
            one.outside.clear();
        }
        const std::size_t first_new = triangles_.size();
        for (const auto& [a, b] : rim_of(std::move(seen))) add({a, b, point});
        std::ranges::sort(orphans);
        share_out(orphans, first_new);
    }

    /// `whole`: triangles of one plane become one face; corners inside a face or an edge go. Else each triangle is one.
    Polyhedron with_faces(bool whole) const {
        Owners owner;
        for (std::size_t k = 0; k < triangles_.size(); ++k)
            for (const Edge& edge : triangles_[k].edges()) owner.emplace_back(edge, k);
        std::ranges::sort(owner);
        std::vector<std::vector<int>> loops;
        std::vector<Plane> planes;
        std::vector<bool> done(triangles_.size(), false);
        for (std::size_t seed = 0; seed < triangles_.size(); ++seed) {
            if (done[seed]) continue;
            const std::array<int, 3>& corners = triangles_[seed].corners;
            loops.push_back(whole ? rim(face_round(seed, owner, done))
                                  : std::vector<int>(corners.begin(), corners.end()));
            planes.push_back(triangles_[seed].plane);
        }
        std::vector<int> uses(points_.size(), 0);
        for (const std::vector<int>& loop : loops)
            for (const int corner : loop) ++uses[static_cast<std::size_t>(corner)];
        Polyhedron body{.corners = {}, .faces = {}, .planes = std::move(planes)};
        std::vector<int> number(points_.size(), -1);
        for (std::size_t corner = 0; corner < points_.size(); ++corner) {
            if (uses[corner] < 3) continue;
            number[corner] = static_cast<int>(body.corners.size());
            body.corners.push_back(points_[corner]);
        }
        for (const std::vector<int>& loop : loops) {
            std::vector<int>& face = body.faces.emplace_back();
            for (const int corner : loop)
                if (const int found = number[static_cast<std::size_t>(corner)]; found >= 0) face.push_back(found);
        }
        return body;
    }

    std::vector<std::size_t> face_round(std::size_t seed, const Owners& owner, std::vector<bool>& done) const {
        const Plane& plane = triangles_[seed].plane;
        std::vector<std::size_t> face{seed};
        done[seed] = true;
        for (std::size_t k = 0; k < face.size(); ++k) {
            for (const auto& [a, b] : triangles_[face[k]].edges()) {
                const auto next = std::ranges::lower_bound(owner, Edge{b, a}, {}, &Owners::value_type::first);
                if (next == owner.end() || next->first != Edge{b, a} || done[next->second]) continue;
                const Triangle& beside = triangles_[next->second];
                const bool flat =
                    beside.plane.normal.dot(plane.normal) > 0.9 && std::ranges::all_of(beside.corners, [&](int corner) {
                        return std::abs(plane.height(at(corner))) <= 2 * rounding_;
                    });
                if (!flat) continue;
                done[next->second] = true;
                face.push_back(next->second);
            }
        }
        return face;
    }

    std::vector<int> rim(const std::vector<std::size_t>& face) const {
        std::vector<Edge> edges;
        for (const std::size_t k : face)
            for (const Edge& edge : triangles_[k].edges()) edges.push_back(edge);
        const std::vector<Edge> rim = rim_of(std::move(edges));
        std::vector<int> loop;
        for (auto at = rim.begin(); at != rim.end() && loop.size() < rim.size();) {
            loop.push_back(at->first);
            const int next = at->second;
            at = std::ranges::lower_bound(rim, next, {}, &Edge::first);
            if (at != rim.end() && at->first != next) break;
        }
        return loop;
    }

    /// Euler's sum, and no point outside. Points nearer to each other than rounding can break both.
    bool is_whole(const Polyhedron& body) const {
        std::size_t ends = 0;
        for (const std::vector<int>& face : body.faces) ends += face.size();
        const bool whole = body.corners.size() + body.faces.size() == ends / 2 + 2;
        return whole && std::ranges::all_of(points_, [&](const Vec3& point) {
                   return std::ranges::all_of(
                       body.planes, [&](const Plane& plane) { return plane.height(point) <= 20 * rounding_; });
               });
    }

    std::span<const Vec3> points_;
    Above above_;
    double rounding_;
    std::vector<Triangle> triangles_;
};

}  // namespace

namespace {

/// The hull of the points moved to a lattice of 2^24 places along the longest side, and there by up to 64 places at
/// random, so that no four of them are in a plane: whole numbers then decide all, without rounding.
std::optional<Polyhedron> hull_on_lattice(std::span<const Vec3> points) {
    const Box3 box = box_round(points);
    const Vec3& low = box.min();
    const double place = box.sizes().maxCoeff() / lattice_places;
    if (!(place > 0)) return {};
    std::mt19937_64 random(1);  // NOLINT: the same bodies every time
    std::vector<Vec3> moved;
    moved.reserve(points.size());
    for (const Vec3& point : points) {
        Vec3& one = moved.emplace_back((point - low) / place);
        for (double& value : one)
            value = std::round(value) + static_cast<double>(random() % (2 * lattice_jitter + 1)) - lattice_jitter;
    }
    std::optional<Polyhedron> body = Growth(moved, Growth::Above::on_lattice).grown();
    if (!body) return {};
    for (Vec3& corner : body->corners) corner = low + place * corner;
    for (Plane& plane : body->planes) plane.offset = place * plane.offset + plane.normal.dot(low);
    return body;
}

}  // namespace

Polyhedron convex_hull(std::span<const Vec3> points) {
    if (points.size() < 4) return {};
    if (std::optional<Polyhedron> body = Growth(points).grown()) return *std::move(body);
    if (std::optional<Polyhedron> body = hull_on_lattice(points)) return *std::move(body);
    throw InputError(
        "The hull of some points cannot be told from their rounding; move or leave out those that nearly meet.");
}

// A plane n · p = d round the origin is the point n/d of the dual body, and a face of that a corner of this.
Polyhedron intersection(std::span<const Plane> planes, const Vec3& within) {
    std::vector<Vec3> duals;
    for (const Plane& plane : planes) {
        const double distance = -plane.height(within);
        if (!(distance > 0)) return {};
        duals.emplace_back(plane.normal / distance);
    }
    std::vector<Vec3> corners;
    for (const Plane& face : convex_hull(duals).planes) {
        if (!(face.offset > 0)) throw InputError("A body within planes has no end in some direction.");
        corners.emplace_back(within + face.normal / face.offset);
    }
    if (corners.size() < 4) throw InputError("A body within planes has no end in some direction.");
    return convex_hull(corners);
}

}  // namespace floes
