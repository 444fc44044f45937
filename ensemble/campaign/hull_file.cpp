#include "campaign/hull_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <assimp/Importer.hpp>

#include "core/error.hpp"

namespace floes {

namespace {

constexpr std::size_t most_triangles = 20'000;

std::string ending_of(const std::string& file) {
    std::string ending = file.substr(std::min(file.rfind('.'), file.size() - 1) + 1);
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

/// Which points are one, by their places.
class Points {
  public:
    explicit Points(Surface& into) : into_(&into) {}

    int number_of(const Vec3& point) {
        const auto [found, is_new] =
            numbers_.try_emplace({point.x(), point.y(), point.z()}, static_cast<int>(into_->points.size()));
        if (is_new) into_->points.push_back(point);
        return found->second;
    }

  private:
    Surface* into_;
    std::map<std::array<double, 3>, int> numbers_;
};

int group_named(Surface& surface, std::string name) {
    std::ranges::replace(name, ',', ' ');
    const auto found = std::ranges::find(surface.groups, name);
    const auto number = static_cast<int>(found - surface.groups.begin());
    if (found == surface.groups.end()) surface.groups.push_back(std::move(name));
    return number;
}

void add_mesh(Surface& surface, Points& points, const aiMesh& mesh, int group, const std::string& file) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) continue;  // points and lines
        std::array<int, 3> corners{};
        for (unsigned k = 0; k < 3; ++k) {
            const aiVector3D& at = mesh.mVertices[face.mIndices[k]];
            const Vec3 point(static_cast<double>(at.x) + 0.0, static_cast<double>(at.y) + 0.0,
                             static_cast<double>(at.z) + 0.0);
            if (!point.allFinite())
                throw InputError(fmt::format("{}: a point of the surface is not a number; write the file anew", file));
            corners[k] = points.number_of(point);
        }
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
        surface.triangles.push_back(corners);
        surface.group.push_back(group);
    }
}

/// Names of the solids of an STL text, which assimp would end at the first blank.
std::vector<std::string> solid_names(const std::string& bytes) {
    std::vector<std::string> names;
    for (std::size_t from = 0; from < bytes.size();) {
        const std::size_t end = std::min(bytes.find_first_of("\r\n", from), bytes.size());
        constexpr std::string_view word = "solid ";
        const std::size_t first = bytes.find_first_not_of(" \t", from);
        if (first < end && bytes.compare(first, word.size(), word) == 0) {
            std::size_t last = end;
            while (bytes[last - 1] == ' ' || bytes[last - 1] == '\t') --last;
            names.push_back(
                bytes.substr(std::min(first + word.size(), last), last - std::min(first + word.size(), last)));
        }
        from = end + 1;
    }
    return names;
}

/// `names`: of the meshes; empty where nodes have theirs.
void add_node(Surface& surface, Points& points, const aiScene& scene, const aiNode& node,
              const std::vector<std::string>& names, const std::string& file) {
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const unsigned number = node.mMeshes[m];
        const aiMesh& mesh = *scene.mMeshes[number];
        const std::string name = !names.empty()          ? names[number]
                                 : node.mName.length > 0 ? node.mName.C_Str()
                                                         : mesh.mName.C_Str();
        add_mesh(surface, points, mesh, group_named(surface, name), file);
    }
    for (unsigned k = 0; k < node.mNumChildren; ++k) add_node(surface, points, scene, *node.mChildren[k], names, file);
}

/// For every triangle the number of its body: those that edges join.
std::vector<int> bodies_of(const Surface& surface, const std::map<std::pair<int, int>, int>& owner, int& bodies) {
    std::vector<int> body(surface.triangles.size(), -1);
    for (std::size_t seed = 0; seed < body.size(); ++seed) {
        if (body[seed] >= 0) continue;
        std::vector<std::size_t> found{seed};
        body[seed] = bodies;
        for (std::size_t k = 0; k < found.size(); ++k) {
            const auto& corners = surface.triangles[found[k]];
            for (std::size_t e = 0; e < 3; ++e) {
                const auto next = static_cast<std::size_t>(owner.at({corners[(e + 1) % 3], corners[e]}));
                if (body[next] >= 0) continue;
                body[next] = bodies;
                found.push_back(next);
            }
        }
        ++bodies;
    }
    return body;
}

/// The triangle on the left of each directed edge.
std::map<std::pair<int, int>, int> edge_owners(const Surface& surface, const std::string& file) {
    std::map<std::pair<int, int>, int> owner;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        for (std::size_t e = 0; e < 3; ++e) {
            const std::pair<int, int> edge{surface.triangles[t][e], surface.triangles[t][(e + 1) % 3]};
            if (owner.try_emplace(edge, static_cast<int>(t)).second) continue;
            const Vec3& at = surface.corner(t, e);
            throw InputError(fmt::format(
                "{}: two triangles at ({:.6g}, {:.6g}, {:.6g}) have the same edge in the same direction, so the "
                "surface has no inside; let the CAD program unite its bodies and orient its faces",
                file, at.x(), at.y(), at.z()));
        }
    }
    std::size_t open = 0;
    const Vec3* at = nullptr;
    for (const auto& [edge, triangle] : owner) {
        if (owner.contains({edge.second, edge.first})) continue;
        ++open;
        at = &surface.points[static_cast<std::size_t>(edge.first)];
    }
    if (open > 0)
        throw InputError(fmt::format(
            "{}: the surface is open: {} edges have a triangle on one side only, one of them at ({:.6g}, {:.6g}, "
            "{:.6g}); close it (a deck, a bottom, the middle plane of a half model), or let the CAD program sew it",
            file, open, at->x(), at->y(), at->z()));
    return owner;
}

std::vector<Surface> bodies_together(const Surface& surface, const std::string& file) {
    int count = 0;
    const std::vector<int> body = bodies_of(surface, edge_owners(surface, file), count);
    std::vector<Surface> bodies(static_cast<std::size_t>(count));
    for (Surface& one : bodies) {
        one.points = surface.points;
        one.groups = surface.groups;
    }
    for (std::size_t t = 0; t < body.size(); ++t) {
        bodies[static_cast<std::size_t>(body[t])].triangles.push_back(surface.triangles[t]);
        bodies[static_cast<std::size_t>(body[t])].group.push_back(surface.group[t]);
    }
    const auto inside_out = [](const Surface& one) { return volume_of(one) < 0; };
    if (std::ranges::all_of(bodies, inside_out)) {
        for (Surface& one : bodies)
            for (auto& corners : one.triangles) std::swap(corners[1], corners[2]);
    } else if (std::ranges::any_of(bodies, inside_out)) {
        throw InputError(
            fmt::format("{}: one of its bodies is inside out, as a hollow in another is; a hull is taken as solid, so "
                        "leave hollows out, or turn the faces of that body",
                        file));
    }
    return bodies;
}

/// Where each group is closed by itself: bodies that touch may share edges.
std::vector<Surface> bodies_by_group(const Surface& surface, const std::string& file) {
    std::vector<Surface> bodies;
    for (std::size_t g = 0; g < surface.groups.size(); ++g) {
        Surface own{surface.points, {}, {}, surface.groups};
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            if (surface.group[t] != static_cast<int>(g)) continue;
            own.triangles.push_back(surface.triangles[t]);
            own.group.push_back(surface.group[t]);
        }
        if (own.triangles.empty()) continue;
        for (Surface& body : bodies_together(own, file)) bodies.push_back(std::move(body));
    }
    return bodies;
}

/// Corners within `tolerance` m of an earlier one become that one; what then has no area goes.
Surface welded(const Surface& surface, double tolerance) {
    using Cell = std::array<long long, 3>;
    const auto cell_of = [&](const Vec3& point) {
        return Cell{std::llround(point.x() / tolerance), std::llround(point.y() / tolerance),
                    std::llround(point.z() / tolerance)};
    };
    std::map<Cell, std::vector<int>> kept;
    const auto representative = [&](int number) {
        const Vec3& point = surface.points[static_cast<std::size_t>(number)];
        const Cell own = cell_of(point);
        for (int k = 0; k < 27; ++k) {
            const auto there = kept.find({own[0] + k % 3 - 1, own[1] + k / 3 % 3 - 1, own[2] + k / 9 - 1});
            if (there == kept.end()) continue;
            for (const int other : there->second)
                if ((surface.points[static_cast<std::size_t>(other)] - point).norm() <= tolerance) return other;
        }
        kept[own].push_back(number);
        return number;
    };
    std::vector<int> now(surface.points.size());
    for (std::size_t k = 0; k < now.size(); ++k) now[k] = representative(static_cast<int>(k));
    Surface found{surface.points, {}, {}, surface.groups};
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<int, 3> corners = surface.triangles[t];
        for (int& corner : corners) corner = now[static_cast<std::size_t>(corner)];
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
        found.triangles.push_back(corners);
        found.group.push_back(surface.group[t]);
    }
    return found;
}

double size_of(const Surface& surface) {
    Vec3 low = surface.corner(0, 0);
    Vec3 high = low;
    for (const Vec3& point : surface.points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return (high - low).norm();
}

std::vector<Surface> bodies_as_they_are(const Surface& surface, const std::string& file) {
    if (surface.groups.size() > 1) {
        try {
            return bodies_by_group(surface, file);
        } catch (const InputError&) {  // groups are patches of bodies
        }
    }
    return bodies_together(surface, file);
}

}  // namespace

Surface read_surface(const std::string& bytes, const std::string& file) {
    const std::string ending = ending_of(file);
    if (ending != "stl" && ending != "obj")
        throw InputError(fmt::format("{}: hulls are read from .stl and .obj files; export one of these", file));
    Assimp::Importer importer;
    const aiScene* scene =
        importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, ending.c_str());
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw InputError(fmt::format("{}: this is no readable .{} file ({}); export it anew", file, ending,
                                     importer.GetErrorString()));
    Surface surface;
    Points points(surface);
    std::vector<std::string> names = ending == "stl" ? solid_names(bytes) : std::vector<std::string>{};
    if (names.size() != scene->mNumMeshes) names.clear();
    add_node(surface, points, *scene, *scene->mRootNode, names, file);
    if (surface.triangles.empty()) throw InputError(fmt::format("{}: the file has no triangles", file));
    if (surface.triangles.size() > most_triangles)
        throw InputError(fmt::format("{}: the surface has {} triangles, more than {}; export it more coarsely", file,
                                     surface.triangles.size(), most_triangles));
    return surface;
}

std::vector<Surface> closed_bodies(const Surface& surface, const std::string& file) {
    try {
        return bodies_as_they_are(surface, file);
    } catch (const InputError&) {
        // Programs round the corners of each triangle by itself: the last printed digit, or what sewing leaves.
        const double size = size_of(surface);
        for (const double share : welding) {
            try {
                return bodies_as_they_are(welded(surface, share * size), file);
            } catch (const InputError&) {  // by more, or not at all
            }
        }
        throw;
    }
}

double volume_of(const Surface& body) {
    const Vec3& origin = body.corner(0, 0);
    double six = 0;
    for (std::size_t t = 0; t < body.triangles.size(); ++t)
        six += (body.corner(t, 0) - origin).dot((body.corner(t, 1) - origin).cross(body.corner(t, 2) - origin));
    return six / 6;
}

// Solid angles add up to 4 π inside and to 0 outside (Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30, 1983,
// cited from memory).
bool encloses(const Surface& body, const Vec3& point) {
    double half = 0;
    for (std::size_t t = 0; t < body.triangles.size(); ++t) {
        const Vec3 a = body.corner(t, 0) - point;
        const Vec3 b = body.corner(t, 1) - point;
        const Vec3 c = body.corner(t, 2) - point;
        const double below =
            a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
        half += std::atan2(a.dot(b.cross(c)), below);
    }
    return half > 3;  // of 2 π
}

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
    double area() const {
        Vec3 twice = Vec3::Zero();
        for (std::size_t k = 1; k + 1 < corners.size(); ++k)
            twice += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
        return 0.5 * twice.norm();
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
        Vec3 low = body.corner(0, 0);
        Vec3 high = low;
        for (std::size_t t = 0; t < body.triangles.size(); ++t) {
            Facet facet{{body.corner(t, 0), body.corner(t, 1), body.corner(t, 2)}, {}, body.group[t]};
            for (const Vec3& corner : facet.corners) {
                low = low.cwiseMin(corner);
                high = high.cwiseMax(corner);
            }
            const Vec3 normal = (facet.corners[1] - facet.corners[0]).cross(facet.corners[2] - facet.corners[0]);
            if (!(normal.norm() > 0)) continue;
            facet.plane = {normal.normalized(), normal.normalized().dot(facet.middle())};
            whole.surface.push_back(std::move(facet));
        }
        size_ = (high - low).norm();
        const Vec3 wide = 0.01 * Vec3::Constant(size_);
        std::vector<Vec3> corners;
        for (int k = 0; k < 8; ++k)
            corners.emplace_back((k & 1) != 0 ? high.x() + wide.x() : low.x() - wide.x(),
                                 (k & 2) != 0 ? high.y() + wide.y() : low.y() - wide.y(),
                                 (k & 4) != 0 ? high.z() + wide.z() : low.z() - wide.z());
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
            Part high = half(part, {-plane.normal, -plane.offset});
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
    for (const Facet& facet : part.surface) all[facet.group] += facet.area();
    piece.group = largest(all);
    for (const Plane& face : piece.body.planes) {
        std::map<int, double> areas;
        for (const Facet& facet : part.surface)
            if (facet.plane.normal.dot(face.normal) > 0.99 &&
                std::abs(face.height(facet.middle())) <= 2 * deep_enough * size)
                areas[facet.group] += facet.area();
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

constexpr std::size_t most_pieces = 64;  // of all bodies together
constexpr double smallest_size = 0.01;   // m
constexpr double largest_size = 5e3;

Vec3 direction(HullAxis axis) {
    const int number = static_cast<int>(axis);
    return (number % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(number / 2);
}

/// Into m, with x ahead and y up from the waterline; then to the middle of the waterline's bounds.
void turn(Surface& surface, const HullFile& file, const std::string& name) {
    const Vec3 up = direction(file.up);
    const Vec3 ahead = direction(file.forward);
    if (up.dot(ahead) != 0)
        throw InputError(
            fmt::format("{}: hull.up and hull.forward are the same axis; they must be at right angles", name));
    const Vec3 aside = ahead.cross(up);
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = -low;
    for (Vec3& point : surface.points) {
        const Vec3 at = metres(file.unit) * point;
        point = {at.dot(ahead), at.dot(up) - file.waterline, at.dot(aside)};
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const double size = (high - low).norm();
    if (!(size > smallest_size && size < largest_size))
        throw InputError(
            fmt::format("{}: the hull is {:.4g} m from corner to corner, which is none of a structure; is "
                        "hull.unit right?",
                        name, size));
    if (!(low.y() < 0 && high.y() > 0))
        throw InputError(
            fmt::format("{}: the hull reaches from {:.4g} m to {:.4g} m above the waterline, so it does not stand in "
                        "the water; set "
                        "hull.waterline_m, hull.up or hull.unit",
                        name, low.y(), high.y()));
}

/// Bounds of what the surface cuts out of the water.
std::pair<Vec2, Vec2> waterline_bounds(const Surface& surface) {
    Vec2 low = Vec2::Constant(1e300);
    Vec2 high = -low;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& a = surface.corner(t, k);
            const Vec3& b = surface.corner(t, (k + 1) % 3);
            if ((a.y() <= 0) == (b.y() <= 0)) continue;
            const Vec3 at = a + (b - a) * (a.y() / (a.y() - b.y()));
            low = low.cwiseMin(Vec2(at.x(), at.z()));
            high = high.cwiseMax(Vec2(at.x(), at.z()));
        }
    }
    return {low, high};
}

/// The names of the groups, or of the bodies where there is one group only.
std::vector<std::string> part_names(const Surface& surface, std::size_t bodies) {
    std::vector<std::string> names = surface.groups;
    for (std::size_t k = 0; k < names.size(); ++k)
        if (names[k].find_first_not_of(" \t") == std::string::npos) names[k] = fmt::format("group {}", k + 1);
    if (names.size() > 1) return names;
    if (bodies == 1) return {"hull"};
    names.clear();
    for (std::size_t k = 0; k < bodies; ++k) names.push_back(fmt::format("body {}", k + 1));
    return names;
}

void take_bodies(Structure& structure, const Surface& surface, const std::vector<Surface>& bodies,
                 const std::string& name) {
    if (bodies.size() > most_pieces)
        throw InputError(
            fmt::format("{}: the file has {} bodies, more than the {} pieces of a hull; leave out what no "
                        "ice meets",
                        name, bodies.size(), most_pieces));
    const std::vector<std::string> names = part_names(surface, bodies.size());
    const bool by_body = surface.groups.size() == 1 && bodies.size() > 1;
    std::vector<std::vector<double>> corners;
    std::vector<std::vector<double>> faces;
    double volume = 0;
    double piece = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        volume += volume_of(bodies[k]);
        for (const ConvexPiece& one : convex_pieces(bodies[k], 1 + (most_pieces - bodies.size()) / bodies.size())) {
            const double part = static_cast<double>(by_body ? static_cast<int>(k) : one.group);
            for (const Vec3& corner : one.body.corners)
                corners.push_back({piece, part, corner.x(), corner.y(), corner.z()});
            for (std::size_t f = 0; f < one.face_groups.size() && !by_body; ++f)
                if (one.face_groups[f] >= 0 && one.face_groups[f] != one.group)
                    faces.push_back({piece, static_cast<double>(f), static_cast<double>(one.face_groups[f])});
            ++piece;
        }
    }
    if (corners.empty()) throw InputError(fmt::format("{}: its surface encloses nothing; export a solid", name));
    structure.shape.set_pieces(corners);
    structure.shape.set_faces(faces);
    structure.shape.part_list() = fmt::format("{}", fmt::join(names, ", "));
    HullFile& file = structure.hull_file;
    file = {.path = "", .most_added = file.most_added, .volume = volume};
}

}  // namespace

void take_hull(Structure& structure, const std::string& bytes, const std::string& name) {
    Surface surface = read_surface(bytes, name);
    turn(surface, structure.hull_file, name);
    const auto [low, high] = waterline_bounds(surface);
    const Vec2 middle = 0.5 * (low + high);
    for (Vec3& point : surface.points) point -= Vec3(middle.x(), 0, middle.y());
    const std::vector<Surface> bodies = closed_bodies(surface, name);
    try {
        take_bodies(structure, surface, bodies, name);
    } catch (const InputError& error) {
        const std::string what = error.what();
        throw what.starts_with(name) ? error : InputError(fmt::format("{}: {}", name, what));
    }
}

}  // namespace floes
