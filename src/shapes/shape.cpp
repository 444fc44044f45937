#include "shapes/shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <ranges>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "shapes/convex_solid.hpp"
#include "shapes/overlap.hpp"

namespace floes {

namespace {

constexpr std::size_t most_points = 1000;

bool is_a_point(const ProfilePoint& point) {
    return std::isfinite(point.height) && std::isfinite(point.radius) && point.radius >= 0;
}

bool falls(const ProfilePoint& below, const ProfilePoint& above) {
    return above.height < below.height;
}

Words part_words(const ProfilePoint& lower, const ProfilePoint& upper) {
    const double angle = std::atan2(upper.height - lower.height, std::abs(upper.radius - lower.radius)) / unit::degree;
    return Words::of("{:.1f}° from the horizontal (radius {:.3f} m at {:+.3f} m to {:.3f} m at {:+.3f} m)", angle,
                     lower.radius, lower.height, upper.radius, upper.height);
}

// A body of revolution about the vertical axis, by its radius over height, from the keel up. What follows
// profile_fault() is of a profile without one.

using Profile = std::vector<ProfilePoint>;

std::vector<std::vector<double>> rows_of(const Profile& profile) {
    std::vector<std::vector<double>> rows;
    for (const ProfilePoint& point : profile) rows.push_back({point.height, point.radius});
    return rows;
}

Profile of_rows(const std::vector<std::vector<double>>& rows) {
    Profile profile;
    for (const std::vector<double>& row : rows) profile.push_back({row.at(0), row.at(1)});
    return profile;
}

double bottom_of(const Profile& profile) {
    return profile.empty() ? 0 : profile.front().height;
}

double top_of(const Profile& profile) {
    return profile.empty() ? 0 : profile.back().height;
}

/// m; at a flat ring the larger.
double waterline_radius_of(const Profile& profile) {
    double radius = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const ProfilePoint& below = profile[i - 1];
        const ProfilePoint& above = profile[i];
        if (below.height > 0 || above.height < 0) continue;
        const double rise = above.height - below.height;
        const double here = rise > 0 ? below.radius - (above.radius - below.radius) * below.height / rise
                                     : std::max(below.radius, above.radius);
        radius = std::max(radius, here);
    }
    return radius;
}

/// Why it is no body that stands in the water; nothing if it is one.
std::optional<std::string> profile_fault(const Profile& profile) {
    if (profile.size() < 2) return "is not a body; give at least two [height_m, radius_m] points";
    if (profile.size() > most_points) return fmt::format("has more than {} points", most_points);
    if (!std::ranges::all_of(profile, is_a_point))
        return "has a point that is none; heights must be finite, radii finite and at least 0";
    if (std::ranges::adjacent_find(profile, falls) != profile.end())
        return "has a height that falls; give the points from the keel up";
    if (!(bottom_of(profile) < 0 && top_of(profile) > 0))
        return "does not span the waterline; give points below and above height 0";
    if (waterline_radius_of(profile) <= 0)
        return "has no radius at the waterline; make its radius at height 0 greater than 0";
    return std::nullopt;
}

std::vector<Frustum> frusta_of(const Profile& profile) {
    if (const auto wrong = profile_fault(profile)) throw InputError("The structure's profile {}.", *wrong);
    std::vector<Frustum> solids;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const ProfilePoint& low = profile[i - 1];
        const ProfilePoint& high = profile[i];
        const bool flat = low.height == high.height;
        const bool on_axis = low.radius == 0 && high.radius == 0;
        if (!flat && !on_axis) solids.push_back({low.height, low.radius, high.height, high.radius});
    }
    return solids;
}

/// Those, continued straight on along their walls for as long as that stays inside.
std::vector<Frustum> continued_frusta_of(const Profile& profile) {
    std::vector<Frustum> continued = frusta_of(profile);
    for (Frustum& solid : continued) {
        const double slope = (solid.top_radius - solid.bottom_radius) / (solid.top_height - solid.bottom_height);
        const double low = solid.bottom_height;
        const auto wall = [&, from = solid.bottom_radius](double height) { return from + slope * (height - low); };
        const auto inside = [&](const ProfilePoint& point) {
            const double radius = wall(point.height);
            return radius >= 0 && radius <= point.radius;
        };
        // At the end itself by its own radius, which is rounded: a ring that steps inwards ends the wall there.
        const auto steps_in = [](const ProfilePoint& point, double radius) {
            return point.radius < radius * (1 - 1e-12);
        };
        for (const ProfilePoint& point : profile) {
            if (point.height < solid.top_height) continue;
            if (point.height == solid.top_height && !steps_in(point, solid.top_radius)) continue;
            if (point.height == solid.top_height || !inside(point)) break;
            solid.top_height = point.height;
            solid.top_radius = wall(point.height);
        }
        for (const ProfilePoint& point : profile | std::views::reverse) {
            if (point.height > solid.bottom_height) continue;
            if (point.height == solid.bottom_height && !steps_in(point, solid.bottom_radius)) continue;
            if (point.height == solid.bottom_height || !inside(point)) break;
            solid.bottom_radius = wall(point.height);
            solid.bottom_height = point.height;
        }
    }
    return continued;
}

double largest_radius_of(const Profile& profile) {
    double largest = 0;
    for (const ProfilePoint& point : profile) largest = std::max(largest, point.radius);
    return largest;
}

double wall_angle_of(const Profile& profile) {
    const auto above = std::ranges::find_if(profile, [](const ProfilePoint& point) { return point.height > 0; });
    if (above == profile.begin() || above == profile.end())
        throw InputError("The structure has no wall above the waterline.");
    const auto below = above - 1;
    return std::atan2(above->height - below->height, above->radius - below->radius);
}

Words words_of(const Profile& profile) {
    std::vector<Words> parts;
    for (std::size_t i = 1; i < profile.size(); ++i) parts.push_back(part_words(profile[i - 1], profile[i]));
    return Words(parts.size() == 1 ? "straight, " : "") + Words::joined(parts, ", then ");
}

std::vector<Vec2> side_view_of(const Profile& profile) {
    std::vector<Vec2> outline;
    for (const ProfilePoint& point : profile) outline.emplace_back(point.radius, point.height);
    for (auto point = profile.rbegin(); point != profile.rend(); ++point)
        outline.emplace_back(-point->radius, point->height);
    return outline;
}

constexpr std::size_t most_pieces = 1000;

double farthest(const std::vector<ConvexSolid>& solids, const Vec3& direction) {
    double reach = -1e300;
    for (const ConvexSolid& solid : solids)
        reach = std::max(reach, direction.dot(solid.place + solid.farthest(direction)));
    return reach;
}

std::vector<ConvexSolid> as_solids(const std::vector<Frustum>& frusta) {
    return {frusta.begin(), frusta.end()};
}

/// A list of names as one text, divided by commas.
std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    if (text.empty()) return names;
    for (const auto name : std::views::split(text, ','))
        names.emplace_back(trimmed(std::string_view(name.begin(), name.end()), " "));
    return names;
}

}  // namespace

Shape::Shape() : Shape(std::vector<ProfilePoint>{{-0.443, 0.445}, {0, 0.614}, {0.122, 0.736}}) {}

Shape::Shape(std::vector<ProfilePoint> profile) : profile_(std::move(profile)) {}

Shape::Shape(HullKind kind, const HullSizes& sizes) : Shape() {
    kind_ = kind;
    sizes_ = sizes;
}

Shape Shape::of_rows(const std::vector<std::vector<double>>& rows) {
    return Shape(floes::of_rows(rows));
}

void Shape::set_profile(const std::vector<std::vector<double>>& rows) {
    profile_ = floes::of_rows(rows);
}

std::vector<std::vector<double>> Shape::rows() const {
    return rows_of(profile_);
}

std::vector<ProfilePoint> Shape::in_force() const {
    return kind_ == HullKind::profile ? profile_ : profile_of(kind_, sizes_);
}

HullSolids Shape::pieces() const {
    if (kind_ != HullKind::file) return solids_of(kind_, sizes_);
    HullSolids all{names_in(part_list_), file_solids_};
    for (const std::vector<double>& row : face_rows_) {
        const auto piece = static_cast<std::size_t>(row.at(0));
        const auto face = static_cast<std::size_t>(row.at(1));
        if (piece >= all.solids.size()) continue;
        ConvexSolid& solid = all.solids[piece];
        const std::size_t faces = std::get<Polyhedron>(solid.form).faces.size();
        if (solid.face_parts.empty()) solid.face_parts.assign(faces, solid.part);
        if (face < faces) solid.face_parts[face] = static_cast<int>(row.at(2));
    }
    return all;
}

std::vector<std::vector<double>> Shape::profile() const {
    return is_of_revolution() ? rows_of(in_force()) : std::vector<std::vector<double>>{};
}

std::vector<std::string> Shape::parts() const {
    return is_of_revolution() ? std::vector<std::string>{"hull"} : pieces().parts;
}

std::vector<std::vector<double>> Shape::piece_rows() const {
    std::vector<std::vector<double>> rows;
    for (std::size_t k = 0; k < file_solids_.size(); ++k)
        for (const Vec3& corner : polyhedron(k).corners)
            rows.push_back({static_cast<double>(k), static_cast<double>(file_solids_[k].part), corner.x(), corner.y(),
                            corner.z()});
    return rows;
}

void Shape::set_pieces(const std::vector<std::vector<double>>& rows) {
    std::map<double, std::pair<int, std::vector<Vec3>>> pieces;
    for (const std::vector<double>& row : rows) {
        auto& [part, points] = pieces[row.at(0)];
        part = static_cast<int>(row.at(1));
        points.emplace_back(row.at(2), row.at(3), row.at(4));
    }
    file_solids_.clear();
    for (const auto& [number, piece] : pieces) file_solids_.emplace_back(convex_hull(piece.second), piece.first);
}

std::optional<std::string> Shape::fault_of_pieces() const {
    if (file_solids_.empty()) return "needs hull.file, or hull.pieces and hull.parts";
    if (file_solids_.size() > most_pieces) return fmt::format("has more than {} pieces", most_pieces);
    const std::vector<std::string> given = names_in(part_list_);
    for (std::size_t k = 0; k < file_solids_.size(); ++k) {
        const ConvexSolid& one = file_solids_[k];
        if (one.fault()) return fmt::format("has its piece {} flat; give it points that are not in one plane", k);
        if (one.part < 0 || one.part >= static_cast<int>(given.size()))
            return fmt::format("has its piece {} in part {}, but hull.parts names {}", k, one.part, given.size());
    }
    for (const std::vector<double>& row : face_rows_) {
        const auto piece = static_cast<std::size_t>(row.at(0));
        if (piece >= file_solids_.size() || row.at(1) >= static_cast<double>(polyhedron(piece).faces.size()) ||
            row.at(2) >= static_cast<double>(given.size()))
            return fmt::format("has a row in hull.faces, [{}, {}, {}], of a piece, face or part that there is not",
                               row.at(0), row.at(1), row.at(2));
    }
    const std::set<std::string> names(given.begin(), given.end());
    if (names.size() < given.size() || names.contains("")) return "has parts without a name of their own";
    if (!(bottom() < 0 && top() > 0)) return "does not reach above and below the water; set hull.waterline_m";
    const auto has_area = [](const ConvexSolid& one) { return area_of(one.section(0, round_sides)) > 0; };
    if (std::ranges::none_of(file_solids_, has_area)) return "cuts nothing out of the water";
    return std::nullopt;
}

std::optional<std::string> Shape::fault() const {
    if (kind_ == HullKind::profile) return profile_fault(profile_);
    if (kind_ == HullKind::file) return fault_of_pieces();
    if (auto wrong = fault_of(kind_, sizes_)) return wrong;
    return is_of_revolution() ? profile_fault(in_force()) : std::nullopt;
}

std::vector<ConvexSolid> Shape::solids() const {
    if (is_of_revolution()) return as_solids(frusta_of(in_force()));
    if (const auto wrong = fault()) throw InputError("The structure {}.", *wrong);
    return pieces().solids;
}

std::vector<ConvexSolid> Shape::overlapping_solids() const {
    return is_of_revolution() ? as_solids(continued_frusta_of(in_force())) : overlapping(solids());
}

double Shape::waterline_radius() const {
    if (is_of_revolution()) return waterline_radius_of(in_force());
    double half_breadth = 0;
    for (const std::vector<Vec2>& outline : waterlines())
        for (const Vec2& point : outline) half_breadth = std::max(half_breadth, std::abs(point.y()));
    return half_breadth;
}

double Shape::waterline_ahead(double yaw) const {
    if (is_of_revolution()) return waterline_radius_of(in_force());
    double ahead = 0;
    for (const std::vector<Vec2>& outline : waterlines())
        for (const Vec2& point : outline)
            ahead = std::max(ahead, std::cos(yaw) * point.x() + std::sin(yaw) * point.y());
    return ahead;
}

double Shape::largest_radius() const {
    if (is_of_revolution()) return largest_radius_of(in_force());
    double largest = 0;
    for (const ConvexSolid& solid : pieces().solids)
        for (const Vec3& corner : solid.corners(round_sides))
            largest = std::max(largest, std::hypot(corner.x(), corner.z()));
    return largest;
}

double Shape::bottom() const {
    return is_of_revolution() ? bottom_of(in_force()) : -farthest(pieces().solids, -Vec3::UnitY());
}

double Shape::top() const {
    return is_of_revolution() ? top_of(in_force()) : farthest(pieces().solids, Vec3::UnitY());
}

double Shape::wall_angle_above_water() const {
    if (is_of_revolution()) return wall_angle_of(in_force());
    throw InputError("Only a body of revolution has the same wall all round; hull.shape is none.");
}

Words Shape::words() const {
    if (is_of_revolution()) return words_of(in_force());
    if (kind_ != HullKind::file) return words_of(kind_, sizes_);
    return Words::of("{} convex pieces in {} parts, {:.4g} m wide at the waterline, draught {:.4g} m",
                     file_solids_.size(), names_in(part_list_).size(), 2 * waterline_radius(), draught());
}

namespace {

constexpr int lines_across = 200;

Box3 box_of(const ConvexSolid& solid) {
    Box3 box;
    for (int k = 0; k < 3; ++k) {
        box.min()[k] = (solid.place + solid.farthest(-Vec3::Unit(k)))[k];
        box.max()[k] = (solid.place + solid.farthest(Vec3::Unit(k)))[k];
    }
    return box;
}

/// Not where they only touch.
bool meet(const Box3& a, const Box3& b) {
    return (a.min().array() < b.max().array()).all() && (b.min().array() < a.max().array()).all();
}

Box3 round_all(const std::vector<Box3>& boxes) {
    Box3 all;
    for (const Box3& box : boxes) all.extend(box);
    return all;
}

/// Where the line along x through (y, z) lies in a polyhedron.
std::pair<double, double> covered(const Polyhedron& body, double y, double z) {
    double from = -1e300;
    double to = 1e300;
    for (const Plane& plane : body.planes) {
        const double left = plane.offset - plane.normal.y() * y - plane.normal.z() * z;
        const double slope = plane.normal.x();
        if (slope > 1e-12)
            to = std::min(to, left / slope);
        else if (slope < -1e-12)
            from = std::max(from, left / slope);
        else if (left < 0)
            return {0, 0};
    }
    return {from, to};
}

double covered_length(std::vector<std::pair<double, double>>& spans) {
    std::ranges::sort(spans);
    double length = 0;
    double reached = -1e300;
    for (const auto& [from, to] : spans) {
        if (to <= reached) continue;
        length += to - std::max(from, reached);
        reached = to;
    }
    return length;
}

/// Islands of outlines whose bounding boxes meet, each as the box round its outlines.
std::vector<Box3> islands(const std::vector<std::vector<Vec2>>& outlines) {
    std::vector<Box3> boxes;
    for (const std::vector<Vec2>& outline : outlines) {
        if (outline.empty()) continue;
        const Box2 flat = box_round(outline);
        Box3 box(Vec3(flat.min().x(), -1, flat.min().y()), Vec3(flat.max().x(), 1, flat.max().y()));
        const double slack = 1e-3 * box.diagonal().norm();
        for (std::size_t k = 0; k < boxes.size();) {
            Box3 wider = boxes[k];
            wider.min().array() -= slack;
            wider.max().array() += slack;
            if (!meet(box, wider)) {
                ++k;
                continue;
            }
            box.extend(boxes[k]);
            boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(k));
            k = 0;
        }
        boxes.push_back(box);
    }
    return boxes;
}

}  // namespace

double Shape::volume() const {
    const std::vector<ConvexSolid> solids = this->solids();
    std::vector<Box3> boxes;
    for (const ConvexSolid& solid : solids) boxes.push_back(box_of(solid));
    bool apart = true;
    for (std::size_t a = 0; a < boxes.size(); ++a)
        for (std::size_t b = a + 1; b < boxes.size(); ++b) apart = apart && !meet(boxes[a], boxes[b]);
    const bool flat = std::ranges::all_of(
        solids, [](const ConvexSolid& one) { return std::holds_alternative<Polyhedron>(one.form); });
    if (apart || !flat)
        return std::accumulate(solids.begin(), solids.end(), 0.0,
                               [](double sum, const ConvexSolid& one) { return sum + one.volume(); });
    const Box3 all = round_all(boxes);
    const double rise = all.sizes().y() / lines_across;
    const double way = all.sizes().z() / lines_across;
    double length = 0;
    std::vector<std::pair<double, double>> spans;
    for (int i = 0; i < lines_across; ++i) {
        for (int k = 0; k < lines_across; ++k) {
            const double y = all.min().y() + (i + 0.5) * rise;
            const double z = all.min().z() + (k + 0.5) * way;
            spans.clear();
            for (std::size_t s = 0; s < solids.size(); ++s) {
                if (!boxes[s].contains(Vec3(boxes[s].min().x(), y, z))) continue;
                const auto [from, to] = covered(std::get<Polyhedron>(solids[s].form), y, z);
                if (to > from) spans.emplace_back(from, to);
            }
            length += covered_length(spans);
        }
    }
    return length * rise * way;
}

std::vector<std::vector<Vec2>> Shape::waterlines() const {
    std::vector<std::vector<Vec2>> outlines;
    if (is_of_revolution()) {
        const double radius = waterline_radius();
        outlines.push_back(ConvexSolid(Frustum{-1, radius, 1, radius}).section(0, round_sides));
        return outlines;
    }
    for (const ConvexSolid& solid : pieces().solids)
        if (auto outline = solid.section(0, round_sides); !outline.empty()) outlines.push_back(std::move(outline));
    return outlines;
}

std::vector<WaterlineEllipse> Shape::waterline_ellipses() const {
    if (is_of_revolution()) return {{0, 0, waterline_radius(), waterline_radius()}};
    std::vector<Box3> found = islands(waterlines());
    if (found.size() > most_ellipses) found = {round_all(found)};
    std::vector<WaterlineEllipse> ellipses;
    for (const Box3& box : found) {
        const Vec3 middle = box.center();
        const Vec3 half = 0.5 * box.sizes();
        ellipses.push_back({middle.x(), middle.z(), half.x(), half.z()});
    }
    return ellipses;
}

std::vector<std::vector<Vec2>> Shape::side_view() const {
    if (is_of_revolution()) return {side_view_of(in_force())};
    std::vector<std::vector<Vec2>> outlines;
    for (const ConvexSolid& solid : pieces().solids) {
        std::vector<Vec2> points;
        for (const Vec3& corner : solid.corners(round_sides)) points.emplace_back(corner.x(), corner.y());
        outlines.push_back(convex_outline(std::move(points)));
    }
    return outlines;
}

Vec3 SurfaceMesh::normal(const std::vector<int>& polygon) const {
    Vec3 twice_area = Vec3::Zero();  // Newell's sum
    const Vec3& first = points[static_cast<std::size_t>(polygon.front())];
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Vec3 a = points[static_cast<std::size_t>(polygon[k])] - first;
        const Vec3 b = points[static_cast<std::size_t>(polygon[k + 1])] - first;
        twice_area += a.cross(b);
    }
    const double size = twice_area.norm();
    return size > 0 ? Vec3(twice_area / size) : Vec3(Vec3::Zero());
}

namespace {

SurfaceMesh mesh_of(const std::vector<ProfilePoint>& profile, int sides) {
    const int rings = static_cast<int>(profile.size());
    SurfaceMesh mesh;
    for (const ProfilePoint& ring : profile) {
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * std::numbers::pi * side / sides;
            mesh.points.emplace_back(ring.radius * std::cos(angle), ring.height, ring.radius * std::sin(angle));
        }
    }
    // Points of a ring run from x to z: clockwise as seen from above.
    std::vector<int> keel;
    std::vector<int> deck;
    for (int side = 0; side < sides; ++side) {
        keel.push_back(side);
        deck.push_back(rings * sides - 1 - side);
    }
    mesh.polygons = {keel, deck};
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const int low = ring * sides;
            const int next = (side + 1) % sides;
            mesh.polygons.push_back({low + side, low + side + sides, low + next + sides, low + next});
        }
    }
    return mesh;
}

void add(SurfaceMesh& all, const SurfaceMesh& one, const Vec3& place) {
    const int first = static_cast<int>(all.points.size());
    for (const Vec3& point : one.points) all.points.emplace_back(point + place);
    for (std::vector<int> polygon : one.polygons) {
        for (int& corner : polygon) corner += first;
        all.polygons.push_back(std::move(polygon));
    }
}

}  // namespace

SurfaceMesh Shape::mesh(int sides) const {
    if (is_of_revolution()) return mesh_of(in_force(), sides);
    SurfaceMesh all;
    for (const ConvexSolid& solid : pieces().solids) {
        if (const auto* round = std::get_if<Frustum>(&solid.form))
            add(all,
                mesh_of({{round->bottom_height, round->bottom_radius}, {round->top_height, round->top_radius}}, sides),
                solid.place);
        else
            add(all, {std::get<Polyhedron>(solid.form).corners, std::get<Polyhedron>(solid.form).faces}, solid.place);
    }
    return all;
}

namespace {

/// Flat and convex.
using Polygon = std::vector<Vec3>;

/// What of it has normal · p <= offset.
Polygon cut(const Polygon& polygon, const Plane& plane) {
    Polygon kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3& a = polygon[k];
        const Vec3& b = polygon[(k + 1) % polygon.size()];
        const double from = plane.height(a);
        const double to = plane.height(b);
        if (from <= 0) kept.push_back(a);
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.emplace_back(a + (b - a) * (from / (from - to)));
    }
    return kept;
}

/// A face, or what is left of it in view, and its plane.
struct View {
    std::vector<Polygon> left;
    Plane plane;
};

/// Takes from a face what lies in or against `other`, which may be its own neighbour. `first`: where both have the same
/// surface it is the other's.
void hide(View& face, const Polyhedron& other, bool first, double slack) {
    const auto own = [&](const Plane& one) { return same_plane(one, face.plane, slack); };
    if (!first && std::ranges::any_of(other.planes, own)) return;
    std::vector<Polygon> kept;
    for (Polygon& whole : face.left) {
        std::vector<Polygon> outside;
        Polygon within = whole;
        for (const Plane& plane : other.planes) {
            const auto height = [&](const Vec3& point) { return plane.height(point); };
            const auto [low, high] = std::ranges::minmax(within, {}, height);
            if (height(high) <= slack) continue;
            if (height(low) >= -slack) {
                within.clear();
                break;
            }
            outside.push_back(cut(within, plane.opposite()));
            within = cut(within, plane);
        }
        if (within.empty())
            kept.push_back(std::move(whole));
        else
            std::ranges::move(outside, std::back_inserter(kept));
    }
    face.left = std::move(kept);
}

void add_faces(std::span<const ConvexSolid> pieces, std::size_t number, const Vec2& heights, double slack,
               std::vector<double>& areas) {
    const ConvexSolid& piece = pieces[number];
    const auto& body = std::get<Polyhedron>(piece.form);
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
        Polygon corners;
        for (const int k : body.faces[f]) corners.push_back(body.corners[static_cast<std::size_t>(k)]);
        corners = cut(cut(corners, {Vec3::UnitY(), heights.y()}), {-Vec3::UnitY(), -heights.x()});
        if (corners.empty()) continue;
        View face{{std::move(corners)}, body.planes[f]};
        for (std::size_t k = 0; k < pieces.size() && !face.left.empty(); ++k)
            if (k != number) hide(face, std::get<Polyhedron>(pieces[k].form), k < number, slack);
        const int part = piece.face_parts.empty() ? piece.part : piece.face_parts[f];
        for (const Polygon& one : face.left) areas[static_cast<std::size_t>(part)] += floes::area_of(one);
    }
}

double area_of(const ConvexSolid& leg, double low, double high) {
    const auto& round = std::get<Frustum>(leg.form);
    const double bottom = round.bottom_height + leg.place.y();
    const double top = round.top_height + leg.place.y();
    const auto disk = [](double radius) { return std::numbers::pi * radius * radius; };
    double area = 0;
    if (low <= bottom && bottom <= high) area += disk(round.bottom_radius);
    if (low <= top && top <= high) area += disk(round.top_radius);
    const double from = std::max(low, bottom);
    const double to = std::min(high, top);
    if (from >= to) return area;
    const double a = round.radius_at(from - leg.place.y());
    const double b = round.radius_at(to - leg.place.y());
    return area + std::numbers::pi * (a + b) * std::hypot(to - from, b - a);
}

}  // namespace

std::vector<double> part_areas(const Shape& shape, double low, double high) {
    if (shape.is_of_revolution()) return {};
    const std::vector<ConvexSolid> pieces = shape.solids();
    std::vector<double> areas(shape.parts().size());
    if (shape.kind() == HullKind::four_legs) {  // they stand apart
        for (const ConvexSolid& leg : pieces) areas[static_cast<std::size_t>(leg.part)] += area_of(leg, low, high);
        return areas;
    }
    const double slack = plane_rounding * size_of(pieces);
    for (std::size_t k = 0; k < pieces.size(); ++k) add_faces(pieces, k, {low, high}, slack, areas);
    return areas;
}

}  // namespace floes
