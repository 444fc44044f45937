#include "cad/hull_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "cad/convex_pieces.hpp"
#include "cad/surface.hpp"
#include "core/error.hpp"

namespace floes {
namespace {

constexpr std::size_t most_pieces = 64;  // of all bodies together
constexpr double smallest = 0.01;        // m
constexpr double largest = 5e3;

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
    if (!(size > smallest && size < largest))
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

/// Of the groups, or of the bodies where there is one group only.
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
