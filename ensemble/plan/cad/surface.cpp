#include "cad/surface.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

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

/// Of every triangle the number of its body: those that edges join.
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
                        "leave hollows "
                        "out, or turn the faces of that body",
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
    if (surface.groups.size() > 1) {
        try {
            return bodies_by_group(surface, file);
        } catch (const InputError&) {  // groups are patches of bodies
        }
    }
    return bodies_together(surface, file);
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

}  // namespace floes
