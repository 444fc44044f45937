#include "structure/shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "structure/measures.hpp"
#include "structure/overlap.hpp"

namespace floes {
namespace {

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
    for (std::size_t from = 0; from <= text.size() && !text.empty();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        const std::size_t first = std::min(text.find_first_not_of(' ', from), comma);
        std::size_t last = comma;
        while (last > first && text[last - 1] == ' ') --last;
        names.push_back(text.substr(first, last - first));
        from = comma + 1;
    }
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
    return Shape(Profile::of_rows(rows).points());
}

Profile Shape::in_force() const {
    if (kind_ == HullKind::profile) return profile_;
    std::vector<ProfilePoint> points;
    for (const Vec2& point : profile_of(kind_, sizes_)) points.push_back({point.x(), point.y()});
    return Profile(std::move(points));
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
    return is_of_revolution() ? in_force().rows() : std::vector<std::vector<double>>{};
}

std::vector<std::string> Shape::parts() const {
    return is_of_revolution() ? std::vector<std::string>{"hull"} : pieces().parts;
}

const Polyhedron& Shape::polyhedron(std::size_t piece) const {
    return std::get<Polyhedron>(file_solids_[piece].form);
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
    if (!(waterplane_area() > 0)) return "cuts nothing out of the water";
    return std::nullopt;
}

std::optional<std::string> Shape::fault() const {
    if (kind_ == HullKind::profile) return profile_.fault();
    if (kind_ == HullKind::file) return fault_of_pieces();
    if (auto wrong = fault_of(kind_, sizes_)) return wrong;
    return is_of_revolution() ? in_force().fault() : std::nullopt;
}

std::vector<ConvexSolid> Shape::solids() const {
    if (is_of_revolution()) return as_solids(in_force().solids());
    if (const auto wrong = fault()) throw InputError(fmt::format("The structure {}.", *wrong));
    return pieces().solids;
}

std::vector<ConvexSolid> Shape::overlapping_solids() const {
    return is_of_revolution() ? as_solids(in_force().overlapping_solids()) : overlapping(solids());
}

double Shape::waterline_radius() const {
    if (is_of_revolution()) return in_force().waterline_radius();
    double half_breadth = 0;
    for (const std::vector<Vec2>& outline : waterlines())
        for (const Vec2& point : outline) half_breadth = std::max(half_breadth, std::abs(point.y()));
    return half_breadth;
}

double Shape::waterline_ahead() const {
    if (is_of_revolution()) return in_force().waterline_radius();
    double ahead = 0;
    for (const std::vector<Vec2>& outline : waterlines())
        for (const Vec2& point : outline) ahead = std::max(ahead, point.x());
    return ahead;
}

double Shape::largest_radius() const {
    if (is_of_revolution()) return in_force().largest_radius();
    double largest = 0;
    for (const ConvexSolid& solid : pieces().solids)
        for (const Vec3& corner : solid.corners(round_sides))
            largest = std::max(largest, std::hypot(corner.x(), corner.z()));
    return largest;
}

double Shape::bottom() const {
    return is_of_revolution() ? in_force().bottom() : -farthest(pieces().solids, -Vec3::UnitY());
}

double Shape::top() const {
    return is_of_revolution() ? in_force().top() : farthest(pieces().solids, Vec3::UnitY());
}

double Shape::wall_angle_above_water() const {
    if (is_of_revolution()) return in_force().wall_angle_above_water();
    throw InputError("Only a body of revolution has the same wall all round; hull.shape is none.");
}

std::string Shape::words() const {
    if (is_of_revolution()) return in_force().words();
    if (kind_ != HullKind::file) return words_of(kind_, sizes_);
    return fmt::format("{} convex pieces in {} parts, {:.4g} m wide at the waterline, draught {:.4g} m",
                       file_solids_.size(), names_in(part_list_).size(), 2 * waterline_radius(), draught());
}

}  // namespace floes
