#include "arrangement/scattered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>

#include "arrangement/crowd.hpp"
#include "core/error.hpp"

namespace floes {

namespace {

constexpr int attempts = 10;
constexpr int rounds = 20;  // more would order the field, because they redraw the floes that do not fit
constexpr int sweeps_per_round = 1000;
constexpr std::size_t floes_per_redraw = 250;
// With mixed sizes
constexpr int pocket_rounds = 150;
constexpr int pocket_sweeps = 200;
constexpr std::size_t pocket_choice = 8;  // the smallest of every eighth floe
constexpr int pocket_throws = 200;

/// Its middle anywhere in the field, at any angle. Where it crosses a wall it will be pushed in: to throw again instead
/// would leave less ice at the walls and more in the middle than elsewhere.
PlanarPose throw_anywhere(const Walls& walls, RandomStream& random) {
    PlanarPose pose;
    pose.x = random.uniform(walls.low_x, walls.low_x + walls.length);
    pose.z = random.uniform(walls.low_z, walls.low_z + walls.breadth);
    pose.yaw = random.uniform(-std::numbers::pi, std::numbers::pi);
    return pose;
}

/// Numbers of the floes that overlap most: one of so many.
std::vector<std::size_t> most_pressed(const Crowd& crowd, std::size_t of) {
    const std::vector<double> overlaps = crowd.overlaps();
    std::vector<std::size_t> floes(overlaps.size());
    std::iota(floes.begin(), floes.end(), std::size_t{0});
    std::ranges::stable_sort(floes, std::ranges::greater(), [&](std::size_t floe) { return overlaps[floe]; });
    floes.resize(1 + (floes.size() - 1) / of);
    return floes;
}

/// With mixed sizes, the smallest of the floes that overlap most, where it overlaps least among many throws: a pocket
/// that a small floe fills loosens the rest, and large floes stay as they were thrown.
void fill_a_pocket(Crowd& crowd, std::span<const Outline> outlines, const Walls& thrown, RandomStream& random) {
    const std::vector<std::size_t> floes = most_pressed(crowd, pocket_choice);
    const std::size_t floe = *std::ranges::min_element(floes, {}, [&](std::size_t i) { return reach_of(outlines[i]); });
    PlanarPose best = throw_anywhere(thrown, random);
    double least = crowd.overlap_at(floe, best);
    for (int i = 1; i < pocket_throws; ++i) {
        const PlanarPose pose = throw_anywhere(thrown, random);
        const double overlap = crowd.overlap_at(floe, pose);
        if (overlap >= least) continue;
        best = pose;
        least = overlap;
    }
    crowd.put(floe, best);
}

/// Between which walls floes are pushed and thrown, and beside what.
struct Room {
    Walls walls;
    Walls first;  // where floes are thrown
    Walls again;  // where those are that do not fit
    Fixed fixed;
    std::span<const PlanarPose> loose;

    std::vector<PlanarPose> poses(std::size_t floes, RandomStream& random) const {
        std::vector<PlanarPose> found(loose.begin(), loose.end());
        while (found.size() < floes) found.push_back(throw_anywhere(first, random));
        return found;
    }
};

/// Some floes are wedged: most often a straight row from wall to wall that is a little too long. Pushing does not bend
/// it, and one floe less loosens it. Rectangles of one size are thrown again, of others the smallest fills a pocket.
std::optional<std::vector<PlanarPose>> attempt(const Room& room, std::span<const Outline> outlines, double margin,
                                               RandomStream& random) {
    const bool alike = is_rectangle(outlines.front()) &&
                       std::ranges::all_of(outlines, [&](const Outline& one) { return one == outlines.front(); });
    Crowd crowd(room.walls, outlines, room.poses(outlines.size(), random), room.fixed);
    for (int round = 0; round < (alike ? rounds : pocket_rounds); ++round) {
        for (int sweep = 0; sweep < (alike ? sweeps_per_round : pocket_sweeps); ++sweep)
            if (crowd.sweep() < margin && crowd.deepest() < margin) return crowd.poses();
        if (!alike) {
            fill_a_pocket(crowd, outlines, room.again, random);
            continue;
        }
        for (const std::size_t floe : most_pressed(crowd, floes_per_redraw))
            crowd.put(floe, throw_anywhere(room.again, random));
    }
    return {};
}

/// a_part: of a field without end, which takes no other method.
std::string refusal(const Walls& walls, std::span<const Outline> outlines, double clearance, bool a_part) {
    const bool rectangles = std::ranges::all_of(outlines, is_rectangle);
    Corner largest;
    double area = 0;
    for (const Outline& one : outlines) {
        largest = {std::max(largest.x, size_of(one).x), std::max(largest.z, size_of(one).z)};
        area += area_of(one);
    }
    const std::string floes =
        rectangles ? fmt::format("{} floes of {} m x {} m, scattered in", outlines.size(), largest.x, largest.z)
                   : fmt::format("{} polygons that cover {:.3g} % of", outlines.size(),
                                 100 * area / (walls.length * walls.breadth));
    const char* other =
        !rectangles ? ", or take shapes.kind = \"voronoi\", whose cells fit at any concentration"
        : a_part    ? ""
                    : ", or use arrangement.method = \"monte_carlo\", whose floes lie in rows where they are dense";
    return fmt::format(
        "{} a field of {:.3f} m x {:.3f} m, still overlap after {} attempts at pushing them apart to a clearance of {} "
        "m; lower field.concentration_percent or the clearance{}",
        floes, walls.length, walls.breadth, attempts, clearance, other);
}

}  // namespace

std::vector<PlanarPose> scattered(const Walls& walls, std::span<const Outline> outlines, double clearance,
                                  RandomStream& random, const std::optional<Beside>& beside) {
    // Floes are enlarged by this margin and come to rest with overlaps below it, so the true floes do not overlap.
    double margin = std::numeric_limits<double>::infinity();
    for (const Outline& one : outlines) margin = std::min(margin, 1e-4 * inner_radius(one));
    const auto enlarge_all = [&](std::span<const Outline> given) {
        std::vector<Outline> larger;
        for (const Outline& one : given) larger.push_back(grown(grown(one, 0.5 * clearance), margin));
        return larger;
    };
    const std::vector<Outline> larger = enlarge_all(outlines);
    const std::vector<Outline> fixed = beside ? enlarge_all(beside->fixed.outlines) : std::vector<Outline>{};
    const Walls inner = walls.shrunk(0.5 * clearance);
    Room room{inner, inner, inner, {}, {}};
    if (beside) {
        const auto beyond = [&](double x) {
            return Walls{x, inner.low_z, inner.low_x + inner.length - x, inner.breadth};
        };
        room = {inner, beyond(beside->from), beyond(beside->again), {fixed, beside->fixed.poses}, beside->loose};
    }
    for (int i = 0; i < attempts; ++i)
        if (const auto poses = attempt(room, larger, margin, random)) return *poses;
    throw InputError(refusal(walls, outlines, clearance, beside.has_value()));
}

}  // namespace floes
