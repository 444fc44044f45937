#include "collision/solid_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.hpp"

namespace floes {
namespace {

Vec3 turned(const Mat3& axes, const Corner& flat) {
    return axes.col(0) * flat.x + axes.col(2) * flat.z;
}

}  // namespace

PrismCorners::PrismCorners(const PrismCore& core, const Vec3& centre, const Mat3& axes)
    : core_(&core), centre_(centre), axes_(axes), count_(2 * core.corners.size()) {
    FLOES_EXPECTS(core.corners.size() <= most_corners);
    const Vec3 up = axes.col(1) * core.half_thickness;
    for (std::size_t k = 0; k < core.corners.size(); ++k) {
        const Vec3 middle = centre + turned(axes, core.corners[k]);
        corners_[2 * k] = middle + up;
        corners_[2 * k + 1] = middle - up;
    }
}

Vec3 PrismCorners::face_normal(std::size_t face) const {
    if (face < 2) return face == 0 ? Vec3(axes_.col(1)) : Vec3(-axes_.col(1));
    return turned(axes_, outward(core_->corners, face - 2));
}

Vec3 PrismCorners::edge_direction(std::size_t edge) const {
    if (edge == 0) return axes_.col(1);
    return turned(axes_, after(core_->corners, edge - 1) - core_->corners[edge - 1]);
}

Vec3 PrismCorners::nearest(const Vec3& direction) const {
    const Vec3* best = corners_.data();
    double least = direction.dot(*best);
    for (const Vec3& one : corners()) {
        const double at = direction.dot(one);
        if (at >= least) continue;
        least = at;
        best = &one;
    }
    return *best;
}

Vec3 PrismCorners::middle_of_nearest(const Vec3& direction, bool on_axis) const {
    const double least = direction.dot(nearest(direction));
    const auto aside = [&](const Vec3& one) { return direction.x() * one.z() - direction.z() * one.x(); };
    Vec3 sum = Vec3::Zero();
    const Vec3* left = nullptr;
    const Vec3* right = nullptr;
    int count = 0;
    for (const Vec3& one : corners()) {
        if (direction.dot(one) > least + length_rounding) continue;
        sum += one;
        ++count;
        if (left == nullptr || aside(one) < aside(*left)) left = &one;
        if (right == nullptr || aside(one) > aside(*right)) right = &one;
    }
    if (!on_axis || aside(*right) - aside(*left) <= length_rounding) return sum / count;
    const double share = std::clamp(-aside(*left) / (aside(*right) - aside(*left)), 0.0, 1.0);
    return *left + share * (*right - *left);
}

void PrismCorners::shift(const Vec3& by) {
    centre_ += by;
    for (std::size_t k = 0; k < count_; ++k) corners_[k] += by;
}

SolidCore::SolidCore(const ConvexSolid& core) : form_(core.form) {
    if (round() != nullptr) return;
    const Polyhedron& body = flat();
    const auto corner = [&](const std::vector<int>& face, std::size_t k) { return face[k % face.size()]; };
    for (std::size_t i = 0; i < body.faces.size(); ++i) {
        for (std::size_t k = 0; k < body.faces[i].size(); ++k) {
            const int from = corner(body.faces[i], k);
            const int to = corner(body.faces[i], k + 1);
            for (std::size_t j = i + 1; j < body.faces.size(); ++j) {
                for (std::size_t m = 0; m < body.faces[j].size(); ++m) {
                    if (corner(body.faces[j], m) != to || corner(body.faces[j], m + 1) != from) continue;
                    const Vec3& end = body.corners[static_cast<std::size_t>(from)];
                    const Vec3 along = body.corners[static_cast<std::size_t>(to)] - end;
                    edges_.push_back({end, along, body.planes[i].normal, body.planes[j].normal, along.norm()});
                }
            }
        }
    }
}

Vec3 SolidCore::farthest(const Vec3& direction) const {
    return std::visit([&](const auto& form) { return form.farthest(direction); }, form_);
}

bool SolidCore::holds(const Vec3& point) const {
    const Frustum* of = round();
    if (of == nullptr)
        return std::ranges::all_of(flat().planes,
                                   [&](const Plane& one) { return one.height(point) <= length_rounding; });
    return point.y() >= of->bottom_height - length_rounding && point.y() <= of->top_height + length_rounding &&
           std::sqrt(point.x() * point.x() + point.z() * point.z()) <= of->radius_at(point.y()) + length_rounding;
}

namespace {

/// f along one direction.
struct Along {
    double gap = -std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitY();

    /// Takes the other if it is larger by more than rounding.
    void consider(double other, const Vec3& direction) {
        if (other > gap + 1e-12) *this = {other, direction};
    }
};

double f_along(const SolidCore& solid, const PrismCorners& prism, const Vec3& n) {
    return n.dot(prism.nearest(n)) - n.dot(solid.farthest(n));
}

/// The wall of a round solid: n = (flat cos θ, up, flat sin θ), n·c = reach.
struct Wall {
    double flat, up, reach;

    explicit Wall(const Frustum& of) {
        const double rise = of.top_height - of.bottom_height;
        const double spread = of.bottom_radius - of.top_radius;
        const double length = std::sqrt(rise * rise + spread * spread);
        flat = rise / length;
        up = spread / length;
        reach = flat * of.bottom_radius + up * of.bottom_height;
    }
    void consider(const Vec3& normal, const PrismCorners& prism, Along& best) const {
        best.consider(normal.dot(prism.nearest(normal)) - reach, normal);
    }
};

/// Normals of the wall that are square to an edge of the prism.
void consider_edges(const Wall& wall, const PrismCorners& prism, Along& best) {
    for (std::size_t k = 0; k + 1 < prism.faces(); ++k) {
        const Vec3 u = prism.edge_direction(k);
        const double square = u.x() * u.x() + u.z() * u.z();
        const double along = -wall.up * u.y() / square;
        const double rest = (wall.flat * wall.flat - along * along * square) / square;
        if (!(rest >= 0)) continue;
        const double aside = std::sqrt(rest);
        for (const double side : {aside, -aside})
            wall.consider({along * u.x() - side * u.z(), wall.up, along * u.z() + side * u.x()}, prism, best);
    }
}

/// The best of a round solid's ends and its wall. No normal of the wall has a larger f than the one that faces the
/// corner of least height above the wall, if that is the nearest along it; else an edge is.
Along best_of_round(const Frustum& of, const PrismCorners& prism) {
    const Wall wall(of);
    double least = std::numeric_limits<double>::infinity();
    double low = least;
    double high = -least;
    Vec3 facing = Vec3::UnitY();
    for (const Vec3& one : prism.corners()) {
        low = std::min(low, one.y());
        high = std::max(high, one.y());
        const double across = std::sqrt(one.x() * one.x() + one.z() * one.z());
        const double height = wall.flat * across + wall.up * one.y() - wall.reach;
        if (height >= least || across == 0) continue;
        least = height;
        facing = {wall.flat * one.x() / across, wall.up, wall.flat * one.z() / across};
    }
    Along best;
    wall.consider(facing, prism, best);
    if (best.gap < least - 1e-12) consider_edges(wall, prism, best);
    best.consider(low - of.top_height, Vec3::UnitY());
    best.consider(of.bottom_height - high, -Vec3::UnitY());
    return best;
}

/// The unit vector (c, s) of the first quadrant of which c x + s z - √(a² c² + b² s²) is largest, for x, z >= 0 and
/// a >= b: the normal where an ellipse is nearest to a point, from inside or outside. The slope over the angle has one
/// root: by Newton's steps between bounds, without the functions of angles, whose last bits differ by processor.
Corner facing_ellipse(double x, double z, double a, double b) {
    const auto unit = [](double c, double s) {
        const double size = std::sqrt(c * c + s * s);
        return Corner{c / size, s / size};
    };
    constexpr int most = 60;
    Corner low{1, 0};
    Corner high{0, 1};
    Corner n = x + z > 0 ? unit(x, z) : unit(1, 1);
    for (int i = 0; i < most; ++i) {
        const double reach = std::sqrt(a * a * n.x * n.x + b * b * n.z * n.z);
        if (!(reach > 0)) break;
        const double slope = z * n.x - x * n.z + (a * a - b * b) * n.z * n.x / reach;
        (slope > 0 ? low : high) = n;
        const double turn = slope / (x * n.x + z * n.z + a * a * b * b / (reach * reach * reach) - reach);
        if (std::abs(turn) < 1e-16) break;
        const Corner next = unit(n.x - turn * n.z, n.z + turn * n.x);
        n = cross(low, next) > 0 && cross(next, high) > 0 ? next : unit(low.x + high.x, low.z + high.z);
    }
    return n;
}

/// A rim of a round solid, and how near to it an edge of the prism must come to be what touches it.
struct Rim {
    double radius, height, near;

    bool far_from(const Vec3& a, const Vec3& b) const {
        const double across = std::max(a.x() * a.x() + a.z() * a.z(), b.x() * b.x() + b.z() * b.z());
        return std::min(a.y(), b.y()) > height + near || std::max(a.y(), b.y()) < height - near ||
               across < (radius - near) * std::abs(radius - near);
    }
    /// From where it is nearest to a corner outside.
    Vec3 facing(const Vec3& corner) const {
        const double across = std::sqrt(corner.x() * corner.x() + corner.z() * corner.z());
        const double share = across > 0 ? radius / across : 0;
        return (corner - Vec3(share * corner.x(), height, share * corner.z())).stableNormalized();
    }
    /// From where it is nearest to the line of an edge, as seen along that: as an ellipse.
    Vec3 facing(const Vec3& corner, const Vec3& way) const {
        const Vec3 u = way.normalized();
        const double flat = std::sqrt(u.x() * u.x() + u.z() * u.z());
        const Vec3 one = flat > 1e-9 ? Vec3(u.z() / flat, 0, -u.x() / flat) : Vec3(1, 0, 0);
        const Vec3 other = u.cross(one);
        const Vec3 place = corner - Vec3(0, height, 0);
        const double x = one.dot(place);
        const double z = other.dot(place);
        const Corner n = facing_ellipse(std::abs(x), std::abs(z), radius, radius * std::abs(u.y()));
        return std::copysign(n.x, x) * one + std::copysign(n.z, z) * other;
    }
};

void consider_rim(const SolidCore& solid, const Rim& rim, const PrismCorners& prism, Along& best) {
    const auto consider = [&](const Vec3& n) { best.consider(f_along(solid, prism, n), n); };
    const auto consider_edge = [&](const Vec3& a, const Vec3& b) {
        if (!rim.far_from(a, b)) consider(rim.facing(a, b - a));
    };
    const std::span corners = prism.corners();
    const std::size_t count = corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        if (!rim.far_from(corners[k], corners[k])) consider(rim.facing(corners[k]));
        consider_edge(corners[k], corners[k + 2 < count ? k + 2 : k + 2 - count]);
        if (k % 2 == 0) consider_edge(corners[k], corners[k + 1]);
    }
}

void consider_rims(const SolidCore& solid, const PrismCorners& prism, double near, Along& best) {
    const Frustum& of = *solid.round();
    near = std::max(near, -best.gap);
    consider_rim(solid, {of.bottom_radius, of.bottom_height, near}, prism, best);
    consider_rim(solid, {of.top_radius, of.top_height, near}, prism, best);
}

void consider_faces(const SolidCore& solid, const PrismCorners& prism, Along& best) {
    for (std::size_t k = 0; k < prism.faces(); ++k) {
        const Vec3 n = -prism.face_normal(k);
        best.consider(f_along(solid, prism, n), n);
    }
}

Along best_of_faces(const Polyhedron& solid, const PrismCorners& prism) {
    Along best;
    for (const Plane& face : solid.planes) {
        if (face.height(prism.centre()) <= best.gap) continue;  // its corners are no farther
        best.consider(face.height(prism.nearest(face.normal)), face.normal);
    }
    return best;
}

/// Axes of an edge of each, of a polyhedron those alone that lead out of it over the edge; normals of small facets are
/// not exact.
void consider_edges(const SolidCore& solid, const PrismCorners& prism, Along& best) {
    for (const SolidCore::Edge& edge : solid.edges()) {
        for (std::size_t k = 0; k + 1 < prism.faces(); ++k) {
            Vec3 n = edge.along.cross(prism.edge_direction(k));
            const double size = n.squaredNorm();
            if (!(size > 1e-12 * edge.length * edge.length)) continue;
            n *= (n.dot(edge.left + edge.right) < 0 ? -1 : 1) / std::sqrt(size);
            const double slack = -1e-3 * edge.length;
            if (edge.left.cross(n).dot(edge.along) < slack || n.cross(edge.right).dot(edge.along) < slack) continue;
            if (n.dot(prism.centre() - edge.end) > best.gap && n.dot(prism.nearest(n) - edge.end) > best.gap)
                best.consider(f_along(solid, prism, n), n);
        }
    }
}

/// Up to four points of the difference of the two cores, and which point of it is nearest to the origin (Gilbert,
/// Johnson and Keerthi, IEEE J. Robotics and Automation 4, 1988; regions of triangles after Ericson, Real-Time
/// Collision Detection, 2005; both cited from memory).
class Simplex {
  public:
    void add(const Vec3& difference, const Vec3& on_prism) {
        at_[count_] = difference;
        on_prism_[count_] = on_prism;
        share_[count_++] = 0;
    }
    bool has(const Vec3& difference) const {
        return std::any_of(at_.begin(), at_.begin() + count_, [&](const Vec3& one) { return one == difference; });
    }
    Vec3 nearest() const { return sum(at_); }
    Vec3 on_prism() const { return sum(on_prism_); }

    /// Keeps what the nearest point lies between; false where the origin is inside.
    bool reduce() {
        share_.fill(0);
        if (count_ == 1) share_[0] = 1;
        if (count_ == 2) share_line(0, 1);
        if (count_ == 3) share_triangle(0, 1, 2);
        if (count_ == 4 && !share_body()) return false;
        int kept = 0;
        for (int k = 0; k < count_; ++k) {
            if (!(share_[k] > 0)) continue;
            at_[kept] = at_[k];
            on_prism_[kept] = on_prism_[k];
            share_[kept++] = share_[k];
        }
        count_ = kept;
        return true;
    }

  private:
    Vec3 sum(const std::array<Vec3, 4>& of) const {
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < count_; ++k) sum += share_[k] * of[k];
        return sum;
    }
    void share_line(int a, int b) {
        const Vec3 way = at_[b] - at_[a];
        const double length = way.squaredNorm();
        const double t = length > 0 ? std::clamp(-at_[a].dot(way) / length, 0.0, 1.0) : 0;
        share_[a] = 1 - t;
        share_[b] = t;
    }
    void share_triangle(int a, int b, int c) {
        const Vec3 ab = at_[b] - at_[a];
        const Vec3 ac = at_[c] - at_[a];
        const double a1 = -ab.dot(at_[a]), a2 = -ac.dot(at_[a]);
        const double b1 = -ab.dot(at_[b]), b2 = -ac.dot(at_[b]);
        const double c1 = -ab.dot(at_[c]), c2 = -ac.dot(at_[c]);
        const double of_c = a1 * b2 - b1 * a2;
        const double of_b = c1 * a2 - a1 * c2;
        const double of_a = b1 * c2 - c1 * b2;
        if (a1 <= 0 && a2 <= 0)
            share_[a] = 1;
        else if (b1 >= 0 && b2 <= b1)
            share_[b] = 1;
        else if (c2 >= 0 && c1 <= c2)
            share_[c] = 1;
        else if (of_c <= 0 && a1 >= 0 && b1 <= 0)
            share_line(a, b);
        else if (of_b <= 0 && a2 >= 0 && c2 <= 0)
            share_line(a, c);
        else if (of_a <= 0 && b2 - b1 >= 0 && c1 - c2 >= 0)
            share_line(b, c);
        else {
            const double all = of_a + of_b + of_c;
            share_[a] = of_a / all;
            share_[b] = of_b / all;
            share_[c] = of_c / all;
        }
    }
    /// The nearest of the faces that the origin is outside of.
    bool share_body() {
        constexpr int faces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
        double least = std::numeric_limits<double>::infinity();
        std::array<double, 4> best{};
        for (const auto& [a, b, c, other] : faces) {
            const Vec3 normal = (at_[b] - at_[a]).cross(at_[c] - at_[a]);
            const double side = normal.dot(at_[other] - at_[a]);
            if (-normal.dot(at_[a]) * side > 0) continue;
            share_.fill(0);
            share_triangle(a, b, c);
            const double far = nearest().squaredNorm();
            if (far >= least) continue;
            least = far;
            best = share_;
        }
        share_ = best;
        return std::isfinite(least);
    }

    std::array<Vec3, 4> at_, on_prism_;
    std::array<double, 4> share_{};
    int count_ = 0;
};

/// The distance of cores that are apart, from a direction on; 0 where they are not, or nearer than `least`.
SolidGap apart(const SolidCore& solid, const PrismCorners& prism, const Vec3& start, double least, double enough) {
    constexpr int most = 100;
    constexpr double rounding = 1e-12;
    Simplex simplex;
    SolidGap found{0, start, Vec3::Zero()};
    double distance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most; ++i) {
        const Vec3 on_prism = prism.nearest(found.normal);
        const Vec3 difference = on_prism - solid.farthest(found.normal);
        const double bound = found.normal.dot(difference);
        if (bound > enough) return {bound, found.normal, {}};
        if (bound >= distance * (1 - rounding) || simplex.has(difference)) break;
        simplex.add(difference, on_prism);
        if (!simplex.reduce()) return {};
        const Vec3 nearest = simplex.nearest();
        const double now = nearest.norm();
        if (!(now > least)) return {};
        if (!(now < distance)) break;
        distance = now;
        found = {distance, nearest / distance, simplex.on_prism()};
    }
    return found;
}

/// Of cores that overlap, or nearly: from the best of all normals of faces, and of edges, upwards. Once the prism is
/// moved along a normal until the two are apart by some distance, the direction in which they are nearest has no
/// smaller f, and the same one if there is no better near by; there is also where they touch.
SolidGap overlapping(const SolidCore& solid, const PrismCorners& prism, Along best, bool touches) {
    constexpr double away = 1e-3;
    constexpr int most = 20;
    constexpr double better = 1e-12;
    const double before = best.gap;
    consider_faces(solid, prism, best);
    consider_edges(solid, prism, best);
    if (touches && best.gap == before) return {best.gap, best.normal, prism.middle_of_nearest(best.normal, false)};
    SolidGap found{best.gap, best.normal, prism.nearest(best.normal)};
    for (int i = 0; i < most; ++i) {
        const Vec3 shift = (away - found.gap) * found.normal;
        PrismCorners moved = prism;
        moved.shift(shift);
        const SolidGap next = apart(solid, moved, found.normal, 0, std::numeric_limits<double>::infinity());
        if (!(next.gap > 0)) break;
        found.on_prism = next.on_prism - shift;
        const double gap = f_along(solid, prism, next.normal);
        if (!(gap > found.gap + better)) break;
        found.gap = gap;
        found.normal = next.normal;
    }
    return found;
}

/// Of a round solid: the normals that are considered are all at which f may be largest, but for rims deep in the ice,
/// where a way out that is shorter by some per cent may be missed.
SolidGap gap_to_round(const SolidCore& solid, const PrismCorners& prism, double enough) {
    Along best = best_of_round(*solid.round(), prism);
    const auto found = [&] { return SolidGap{best.gap, best.normal, prism.middle_of_nearest(best.normal, true)}; };
    if (best.gap > enough) return {best.gap, best.normal, Vec3::Zero()};
    SolidGap first = found();
    const bool touches = solid.holds(first.on_prism - first.gap * first.normal);
    if (touches && first.gap > 0) return first;
    consider_faces(solid, prism, best);
    consider_rims(solid, prism, touches ? 0 : enough, best);
    SolidGap last = found();
    if (!solid.holds(last.on_prism - last.gap * last.normal))
        last.on_prism = solid.farthest(last.normal) + last.gap * last.normal;
    return last;
}

}  // namespace

SolidGap gap_between(const SolidCore& solid, const PrismCorners& prism, double enough) {
    constexpr double least = 1e-5;  // of which a direction is known well
    if (solid.round() != nullptr) return gap_to_round(solid, prism, enough);
    const Along best = best_of_faces(solid.flat(), prism);
    if (best.gap > enough) return {best.gap, best.normal, Vec3::Zero()};
    const Vec3 on_prism = prism.middle_of_nearest(best.normal, false);
    const bool touches = solid.holds(on_prism - best.gap * best.normal);
    if (touches && best.gap > 0) return {best.gap, best.normal, on_prism};
    if (!touches || !solid.holds(on_prism)) {
        const SolidGap found = apart(solid, prism, best.normal, least, enough);
        if (found.gap > 0) return found;
    }
    return overlapping(solid, prism, best, touches);
}

}  // namespace floes
