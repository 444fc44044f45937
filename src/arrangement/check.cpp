#include "arrangement/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "arrangement/crowd.hpp"
#include "core/error.hpp"
#include "shapes/polygon.hpp"

namespace floes {

namespace {

constexpr double area_rounding = 1e-12;  // relative
constexpr double tidied_area = 1e-4;     // likewise, of polygons, each of which loses its shortest edges

/// Between two floes, along the direction in which they are farthest from being too near, m.
struct Gap {
    double width = 0;  ///< below 0 they overlap
    double wanted = 0;
};

/// margin: by which both are to be larger on every side, m.
Gap widest_gap(const TurnedRectangle& first, const TurnedRectangle& second, double margin, double dx, double dz) {
    Gap widest{-std::numeric_limits<double>::infinity(), 0};
    const auto look = [&](double distance, double touching, double clear) {
        if (distance - clear > widest.width - widest.wanted) widest = {distance - touching, clear - touching};
    };
    const auto grown = [&](const TurnedRectangle& one) { return TurnedRectangle{one.shape.grown(margin), one.turn}; };
    for (const auto& [own, other] : {std::pair(first, second), std::pair(second, first)}) {
        const Turn turn = own.turn;
        const Extent reach = joint_extent(own, other);
        const Extent wanted = joint_extent(grown(own), grown(other));
        look(std::abs(turn.cos * dx - turn.sin * dz), reach.x, wanted.x);
        look(std::abs(turn.sin * dx + turn.cos * dz), reach.z, wanted.z);
    }
    return widest;
}

std::string gap_text(const Gap& gap, double clearance) {
    const std::string found = std::abs(gap.width) < length_rounding ? "touch"
                              : gap.width < 0                       ? fmt::format("overlap by {:.4g} m", -gap.width)
                                                                    : fmt::format("are {:.4g} m apart", gap.width);
    const bool at_an_angle = gap.wanted > 1.0001 * clearance;
    return fmt::format("{}; they are to be {:.4g} m apart, the clearance{}", found, gap.wanted,
                       at_an_angle ? fmt::format(" of {} m at the angle between them", clearance) : "");
}

/// "0.02 m beyond its edge at z = 5 m and is to stay 0.002 m within": the edge that it is worst at.
std::string edge_text(const Scenario& scenario, const PlanarPose& pose, const TurnedRectangle& floe) {
    const Walls walls = field_walls(scenario);
    const Extent half = extent(floe.shape, floe.turn);
    struct Edge {
        char axis;
        double at;
        double room;
    };
    const double end = walls.low_x + walls.length;
    const double side = walls.low_z + walls.breadth;
    const std::array edges{
        Edge{'x', walls.low_x, pose.x - half.x - walls.low_x}, Edge{'x', end, end - (pose.x + half.x)},
        Edge{'z', walls.low_z, pose.z - half.z - walls.low_z}, Edge{'z', side, side - (pose.z + half.z)}};
    const Edge& worst = *std::ranges::min_element(edges, {}, &Edge::room);
    return fmt::format("{:.4g} m {} its edge at {} = {:.6g} m and is to stay {} m within", std::abs(worst.room),
                       worst.room < 0 ? "beyond" : "from", worst.axis, worst.at, scenario.arrangement.clearance);
}

/// The first floe that overlaps an earlier one, and the first such earlier one.
std::optional<std::pair<std::size_t, std::size_t>> overlapping_pair(const Walls& walls,
                                                                    std::span<const TurnedRectangle> grown,
                                                                    std::span<const PlanarPose> poses) {
    double reach = 0;
    for (const TurnedRectangle& floe : grown) reach = std::max(reach, 2 * floe.shape.half_diagonal());
    Cells cells({walls.low_x, walls.low_z, walls.length, walls.breadth}, reach, poses.size());
    for (std::size_t j = 0; j < poses.size(); ++j) {
        const auto [x, z, yaw] = poses[j];
        std::size_t first = j;
        cells.for_each_near(x, z, [&, x = x, z = z](const Resident& other) {
            const auto i = static_cast<std::size_t>(other.floe);
            if (i < first && overlap(grown[i], grown[j], x - other.x, z - other.z)) first = i;
        });
        if (first < j) return std::pair(first, j);
        cells.insert({x, z, grown[j].turn, static_cast<int>(j)});
    }
    return std::nullopt;
}

/// Whether they are farther than `gap` apart along x, without a look at their edges.
bool are_far_apart(Corners a, Corners b, double gap) {
    const auto [first_a, last_a] = std::ranges::minmax(a, {}, &Corner::x);
    const auto [first_b, last_b] = std::ranges::minmax(b, {}, &Corner::x);
    return first_a.x > last_b.x + gap || first_b.x > last_a.x + gap;
}

/// Grown by half the clearance each they must not overlap: so corners keep up to 1.21 times of it from sides.
std::optional<Fault> fault_of_rectangles(const Walls& walls, std::span<const Rectangle> shapes,
                                         std::span<const PlanarPose> poses, double clearance) {
    const double margin = 0.5 * (clearance - length_rounding);
    std::vector<TurnedRectangle> grown;
    for (std::size_t i = 0; i < poses.size(); ++i) grown.push_back({shapes[i].grown(margin), turn_of(poses[i].yaw)});
    const std::optional<std::pair<std::size_t, std::size_t>> pair = overlapping_pair(walls, grown, poses);
    if (!pair) return std::nullopt;
    const auto [i, j] = *pair;
    const double dx = poses[j].x - poses[i].x;
    const double dz = poses[j].z - poses[i].z;
    return Fault{
        fmt::format(
            "floes {} and {}, at x = {:.4f} m, z = {:.4f} m and x = {:.4f} m, z = {:.4f} m, {}", i, j, poses[i].x,
            poses[i].z, poses[j].x, poses[j].z,
            gap_text(widest_gap({shapes[i], grown[i].turn}, {shapes[j], grown[j].turn}, margin, dx, dz), clearance)),
        {i, j}};
}

/// The first polygon that leaves the walls, or lies nearer than `gap` to an earlier one.
std::optional<Fault> fault_of_polygons(const Walls& walls, const std::vector<Outline>& outlines, double gap) {
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        for (const Corner& corner : outlines[i])
            if (!(corner.x >= walls.low_x && corner.x <= walls.low_x + walls.length && corner.z >= walls.low_z &&
                  corner.z <= walls.low_z + walls.breadth))
                return Fault{
                    fmt::format(
                        "floe {} is not inside the field: it has a corner at x = {:.4f} m, z = {:.4f} m, beyond x "
                        "= {:.4f} to {:.4f} m and z = {:.4f} to {:.4f} m, the field less the clearance",
                        i, corner.x, corner.z, walls.low_x, walls.low_x + walls.length, walls.low_z,
                        walls.low_z + walls.breadth),
                    {i}};
        for (std::size_t k = 0; k < i; ++k) {
            if (are_far_apart(outlines[k], outlines[i], gap)) continue;
            if (const double apart = distance_between_outlines(outlines[k], outlines[i]); !(apart >= gap))
                return Fault{fmt::format("floes {} and {} are {:.4g} m apart and are to be {:.4g} m", k, i, apart, gap),
                             {k, i}};
        }
    }
    return std::nullopt;
}

}  // namespace

Outline on_water(Corners outline, const PlanarPose& pose) {
    const Turn turn = turn_of(pose.yaw);
    return from_axes(outline, {pose.x, pose.z}, {turn.cos, -turn.sin});
}

std::vector<Outline> outlines_on_water(const FloeSet& floes) {
    std::vector<Outline> found;
    for (std::size_t i = 0; i < floes.size(); ++i)
        found.push_back(on_water(floes.shape(i).corners(), floes.floes[i].pose));
    return found;
}

std::vector<Outline> outlines_of(const FloeSet& floes) {
    std::vector<Outline> found;
    for (std::size_t i = 0; i < floes.size(); ++i) found.push_back(floes.shape(i).hull());
    return found;
}

std::vector<Rectangle> rectangles(const FloeSet& floes) {
    std::vector<Rectangle> found;
    for (std::size_t i = 0; i < floes.size(); ++i)
        found.push_back({0.5 * floes.shape(i).length, 0.5 * floes.shape(i).breadth});
    return found;
}

Walls field_walls(const Scenario& scenario) {
    const Field& field = scenario.field;
    return {field.begin, -field.half_width, scenario.field_length(), 2 * field.half_width};
}

std::optional<Fault> find_fault(const Scenario& scenario, const FloeSet& floes) {
    const Field& field = scenario.field;
    const std::vector<PlanarPose> poses = floes.poses();
    const double clearance = scenario.arrangement.clearance;
    if (poses.size() != static_cast<std::size_t>(field.floes)) {
        return Fault{fmt::format("the arrangement has {} floes where the field has {}", poses.size(), field.floes)};
    }
    if (scenario.arrangement.level()) return std::nullopt;  // check_level() has looked at it
    const double concentration = covered_area(floes) / (scenario.field_length() * 2 * field.half_width);
    const double exact = scenario.shapes.any() ? tidied_area : area_rounding;
    if (!(std::abs(concentration - field.concentration) <= exact * field.concentration)) {
        return Fault{fmt::format("the floes cover {} of the field instead of {}", concentration, field.concentration)};
    }
    const Walls walls = field_walls(scenario).shrunk(clearance - length_rounding);
    if (scenario.shapes.any()) return fault_of_polygons(walls, outlines_on_water(floes), clearance - length_rounding);
    const std::vector<Rectangle> shapes = rectangles(floes);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const PlanarPose& pose = poses[i];
        // Checked first, because turn_of() is not defined for NaN.
        if (!(std::abs(pose.yaw) < 1e6)) return Fault{fmt::format("floe {} has the yaw {} rad", i, pose.yaw), {i}};
        const TurnedRectangle turned{shapes[i], turn_of(pose.yaw)};
        if (!walls.admits(shapes[i], pose.x, pose.z, turned.turn)) {
            return Fault{fmt::format("floe {} at x = {:.4f} m, z = {:.4f} m is not inside the field: it lies {}", i,
                                     pose.x, pose.z, edge_text(scenario, pose, turned)),
                         {i}};
        }
    }
    return fault_of_rectangles(walls, shapes, poses, clearance);
}

std::optional<std::string> nearness_fault(const Walls& walls, std::span<const Outline> outlines,
                                          std::span<const PlanarPose> poses, double clearance) {
    // Parts of a field without end go on beyond its ends, so only its sides are walls here.
    constexpr double far = 1e9;
    const Walls sides = Walls{-far, walls.low_z, 2 * far, walls.breadth}.shrunk(clearance - length_rounding);
    if (std::ranges::all_of(outlines, is_rectangle)) {
        std::vector<Rectangle> shapes;
        for (const Outline& one : outlines) shapes.push_back({half_sides_of(one)->x, half_sides_of(one)->z});
        for (std::size_t i = 0; i < poses.size(); ++i)
            if (!sides.admits(shapes[i], poses[i].x, poses[i].z, turn_of(poses[i].yaw)))
                return fmt::format("the floe at x = {:.4f} m, z = {:.4f} m crosses a side", poses[i].x, poses[i].z);
        if (const auto fault = fault_of_rectangles(walls, shapes, poses, clearance)) return fault->sentence;
        return std::nullopt;
    }
    std::vector<Outline> laid;
    for (std::size_t i = 0; i < poses.size(); ++i) laid.push_back(on_water(outlines[i], poses[i]));
    if (const auto fault = fault_of_polygons(sides, laid, clearance - length_rounding)) return fault->sentence;
    return std::nullopt;
}

void expect_none(const std::optional<std::string>& fault, std::uint64_t part, std::uint32_t arrangement) {
    if (fault)
        throw RunError("part {} of arrangement {} came out wrong, which is an error of the program: {}", part,
                       arrangement, *fault);
}

}  // namespace floes
