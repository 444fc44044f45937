// The hull of points, grown point by point: the farthest one outside a face joins, the faces that it sees go, and new
// ones lead from it to their rim (Barber, Dobkin and Huhdanpaa, ACM Trans. Math. Software 22, 1996, cited from memory).

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "structure/polyhedron.hpp"

namespace floes {
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

class Growth {
  public:
    explicit Growth(std::span<const Vec3> points) : points_(points) {
        Vec3 low = points.front();
        Vec3 high = low;
        for (const Vec3& point : points) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        rounding_ = flatness * (high - low).norm();
    }

    Polyhedron grown() {
        if (!begin()) return {};
        for (std::size_t k = 0; k < triangles_.size(); ++k)
            while (triangles_[k].alive && !triangles_[k].outside.empty()) add_farthest(k);
        std::erase_if(triangles_, [](const Triangle& one) { return !one.alive; });
        Polyhedron body = with_whole_faces();
        check(body);
        return body;
    }

  private:
    const Vec3& at(int k) const { return points_[static_cast<std::size_t>(k)]; }

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
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
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
                if (!triangles_[k].alive || triangles_[k].plane.height(at(point)) <= rounding_) continue;
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
            if (!one.alive || one.plane.height(at(point)) <= rounding_) continue;
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

    /// Triangles of one plane become one face; corners inside a face or an edge go.
    Polyhedron with_whole_faces() const {
        Owners owner;
        for (std::size_t k = 0; k < triangles_.size(); ++k)
            for (const Edge& edge : triangles_[k].edges()) owner.emplace_back(edge, k);
        std::ranges::sort(owner);
        std::vector<std::vector<int>> loops;
        std::vector<Plane> planes;
        std::vector<bool> done(triangles_.size(), false);
        for (std::size_t seed = 0; seed < triangles_.size(); ++seed) {
            if (done[seed]) continue;
            loops.push_back(rim(face_round(seed, owner, done)));
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
    void check(const Polyhedron& body) const {
        std::size_t ends = 0;
        for (const std::vector<int>& face : body.faces) ends += face.size();
        const bool whole = body.corners.size() + body.faces.size() == ends / 2 + 2;
        const bool closed = whole && std::ranges::all_of(points_, [&](const Vec3& point) {
                                return std::ranges::all_of(body.planes, [&](const Plane& plane) {
                                    return plane.height(point) <= 20 * rounding_;
                                });
                            });
        if (!closed)
            throw InputError(
                "The hull of some points cannot be told from their rounding; leave out points that lie within a "
                "millionth of the body's size of each other.");
    }

    std::span<const Vec3> points_;
    double rounding_ = 0;
    std::vector<Triangle> triangles_;
};

}  // namespace

Polyhedron convex_hull(std::span<const Vec3> points) {
    if (points.size() < 4) return {};
    return Growth(points).grown();
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
