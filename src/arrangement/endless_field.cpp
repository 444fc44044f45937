#include "arrangement/endless_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "arrangement/check.hpp"
#include "arrangement/scattered.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "scenario/floes.hpp"

namespace floes {

namespace {

WaterArea strip_of(const Scenario& scenario) {
    const Field& field = scenario.field;
    return {field.begin, -field.half_width, scenario.field_length(), 2 * field.half_width};
}

std::vector<Outline> outlines_of(std::span<const SingleFloe> floes) {
    std::vector<Outline> found;
    for (const SingleFloe& floe : floes) found.push_back(floe.shape.hull());
    return found;
}

std::vector<PlanarPose> poses_of(std::span<const SingleFloe> floes) {
    std::vector<PlanarPose> found;
    for (const SingleFloe& floe : floes) found.push_back(floe.pose);
    return found;
}

}  // namespace

CellField::CellField(const Scenario& scenario, std::uint64_t seed, std::uint32_t number)
    : scenario_(scenario),
      seed_(seed),
      number_(number),
      strip_(strip_of(scenario)),
      diagram_(strip_, scenario.shapes.relaxations) {}

void CellField::throw_points() {
    RandomStream random(seed_, number_, StreamId::voronoi, ++thrown_);
    diagram_.add(thrown_points(strip_, static_cast<std::size_t>(scenario_.field.floes), random));
    strip_.low_x += strip_.length;
}

/// The floes of the next cells; taken: how many cells they are of, those that are left out included.
std::vector<Outline> CellField::opened(std::size_t count, std::size_t& taken) {
    constexpr int attempts = 20;
    const double thickness = scenario_.floe.thickness;
    Shrunk floes;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        std::vector<Outline> kept;
        double area = 0;
        for (taken = 0; kept.size() < count; ++taken) {
            while (diagram_.ready() < taken + 2) throw_points();  // and the one beyond, which says where the part ends
            const Outline& cell = diagram_.cell(taken);
            area += area_of(cell);
            if (is_floe(eroded(cell, floes.offset), thickness)) kept.push_back(cell);
        }
        floes = shrunk_to(kept, scenario_.field.concentration * area);
        check_gap(scenario_, floes.offset);
        if (std::ranges::all_of(floes.outlines, [&](const Outline& one) { return is_floe(one, thickness); }))
            return floes.outlines;
    }
    throw InputError(
        "shapes.relaxations = {} left a Voronoi cell that is narrower than the ice is thick after its edges moved in "
        "by {:.4g} m; relax more, raise field.concentration_percent or take larger floes",
        scenario_.shapes.relaxations, floes.offset);
}

FieldPart CellField::next() {
    const FloeSet drawn = floes_of(scenario_, {seed_, number_, ++parts_});
    std::size_t taken = 0;
    const std::vector<Outline> outlines = opened(drawn.size(), taken);
    FieldPart part;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        SingleFloe& floe = part.floes.emplace_back(SingleFloe{{}, drawn.shape(i), drawn.material(i)});
        lie_as(floe, outlines[i]);
    }
    part.end = 0.5 * (diagram_.middle_x(taken - 1) + diagram_.middle_x(taken));
    diagram_.take(taken);
    check_beside_last(part.floes);
    last_ = part.floes;
    return part;
}

void CellField::check_beside_last(const std::vector<SingleFloe>& floes) const {
    std::vector<SingleFloe> both = last_;
    both.insert(both.end(), floes.begin(), floes.end());
    const Walls walls{strip_.low_x, strip_.low_z, strip_.length, strip_.breadth};
    expect_none(nearness_fault(walls, outlines_of(both), poses_of(both), scenario_.arrangement.clearance), parts_,
                number_);
}

namespace {

constexpr int rows_in_a_part = 2;

/// Steps of Lloyd's, after which cells are much alike, and so is their stiffness in all directions (docs/fracture.md).
constexpr int steps_of_sheet = 20;

/// How far a cell reaches at most, in sides of an element.
constexpr double longest_cell = 3;

SingleFloe sheet_of(const Scenario& scenario, std::uint64_t seed, std::uint32_t number) {
    const FloeSet sheet = floes_of(scenario, {seed, number});
    return {sheet.floes[0].pose, sheet.shape(0), sheet.material(0)};
}

std::size_t cells_in_a_part(const FloeShape& sheet) {
    return static_cast<std::size_t>(rows_in_a_part * std::max(1L, std::lround(sheet.breadth / sheet.element)));
}

WaterArea first_strip(const Scenario& scenario, const FloeShape& sheet) {
    const double area = static_cast<double>(cells_in_a_part(sheet)) * sheet.element * sheet.element;
    return {scenario.field.begin, -sheet.breadth / 2, area / sheet.breadth, sheet.breadth};
}

}  // namespace

EndlessSheet::EndlessSheet(const Scenario& scenario, std::uint64_t seed, std::uint32_t number)
    : sheet_(sheet_of(scenario, seed, number)),
      seed_(seed),
      number_(number),
      draw_(static_cast<std::uint64_t>(scenario.elements.draw) << 32U),
      cells_(cells_in_a_part(sheet_.shape)),
      strip_(first_strip(scenario, sheet_.shape)),
      diagram_(strip_, steps_of_sheet) {}

void EndlessSheet::throw_points() {
    RandomStream random(seed_, number_, StreamId::elements, draw_ + ++thrown_);
    diagram_.add(thrown_points(strip_, cells_, random));
    strip_.low_x += strip_.length;
}

void EndlessSheet::join(const Laid& cell, std::vector<CutJoint>& joints) const {
    for (const Laid& other : edge_) {
        std::optional<CutJoint> joint =
            joint_between(cell.corners, cell.centre, other.corners, other.centre, std::min(cell.side, other.side));
        if (!joint) continue;
        joint->a = cell.number;
        joint->b = other.number;
        joints.push_back(*joint);
    }
}

FieldPart EndlessSheet::next() {
    FieldPart part;
    while (diagram_.ready() < cells_ + 1) throw_points();  // and the one beyond, which says where the part ends
    for (std::size_t i = 0; i < cells_; ++i) {
        const Measures measures = measures_of(diagram_.cell(i));
        SingleFloe& floe = part.floes.emplace_back(sheet_);
        floe.pose = {measures.centroid.x, measures.centroid.z, 0};
        floe.shape.outline = in_axes(diagram_.cell(i), measures.centroid, {1, 0});
        const Corner size = size_of(floe.shape.outline);
        floe.shape.length = size.x;
        floe.shape.breadth = size.z;
        floe.shape.element = std::sqrt(measures.area);
        floe.shape.pattern = 0;
        const CutElement cut = floe.shape.cut().elements.front();
        const Corner centre = cut.centre + Corner{floe.pose.x, floe.pose.z};
        const Laid cell{laid_++, centre, from_axes(cut.corners, centre, cut.axis), floe.shape.element};
        join(cell, part.joints);
        edge_.push_back(cell);
    }
    part.end = 0.5 * (diagram_.middle_x(cells_ - 1) + diagram_.middle_x(cells_));
    diagram_.take(cells_);
    std::erase_if(edge_,
                  [&](const Laid& one) { return one.centre.x < part.end - longest_cell * sheet_.shape.element; });
    return part;
}

namespace {

/// The straight wall ahead of the floes that wait crowds and orders those beside it. So these are thrown again, and all
/// that wait are so many that none that stays saw the wall. In diagonals of the largest floe.
constexpr double diagonals_at_the_wall = 1.5;
constexpr double waiting_diagonals = 4;

/// Part number of the draws of the floes that wait when nothing is laid yet; no field has so many parts.
constexpr std::uint64_t first_waiting = 1U << 31U;

/// Twice as far as a floe reaches from its centroid, at most.
double largest_diagonal(std::span<const SingleFloe> floes) {
    double largest = 0;
    for (const SingleFloe& floe : floes) largest = std::max(largest, 2 * reach_of(floe.shape.corners()));
    return largest;
}

/// Those of the floes, in the order of x, whose middles lie below `x.y()`: thrown out of their places, from not at all
/// at `x.x()` to a diagonal there. Floes that are thrown anywhere push, and would push those that lie at rest beside
/// them to a denser field.
std::vector<PlanarPose> shaken(std::span<const PlanarPose> floes, const Vec2& x, double diagonal,
                               RandomStream& random) {
    std::vector<PlanarPose> found;
    for (PlanarPose pose : floes) {
        if (pose.x >= x.y()) break;
        const double share = (pose.x - x.x()) / (x.y() - x.x());
        pose.x += share * diagonal * random.uniform(-1, 1);
        pose.z += share * diagonal * random.uniform(-1, 1);
        pose.yaw += share * std::numbers::pi * random.uniform(-1, 1);
        found.push_back(pose);
    }
    return found;
}

}  // namespace

EndlessField::EndlessField(const Scenario& scenario, std::uint64_t seed, std::uint32_t number, std::uint64_t geometry)
    : scenario_(scenario), seed_(seed), number_(number), geometry_(geometry), end_(scenario.field.begin) {
    const Field& field = scenario.field;
    double wanted = 0;  // area of the floes that wait
    for (std::uint64_t part = first_waiting; waiting_.empty() || area_ < wanted; ++part) {
        for (const SingleFloe& floe : drawn(part)) {
            if (!waiting_.empty() && area_ >= wanted) break;
            waiting_.push_back(floe);
            area_ += floe.shape.area();
            wanted = waiting_diagonals * largest_diagonal(waiting_) * field.concentration * 2 * field.half_width;
        }
    }
}

std::vector<SingleFloe> EndlessField::drawn(std::uint64_t part) const {
    const FloeSet floes = floes_of(scenario_, {seed_, number_, part});
    std::vector<SingleFloe> found;
    for (std::size_t i = 0; i < floes.size(); ++i) found.push_back({{}, floes.shape(i), floes.material(i)});
    return found;
}

double EndlessField::end_of_all() const {
    return scenario_.field.begin + area_ / (scenario_.field.concentration * 2 * scenario_.field.half_width);
}

FieldPart EndlessField::next() {
    const std::uint64_t part = ++parts_;
    std::vector<SingleFloe> floes = std::move(waiting_);
    const std::vector<PlanarPose> before = poses_of(floes);  // in the order of x
    const double wall = end_of_all();
    for (const SingleFloe& floe : drawn(part)) {
        floes.push_back(floe);
        area_ += floe.shape.area();
    }
    const double reach = largest_diagonal(floes);
    const Field& field = scenario_.field;
    const double low = laid_.empty() ? field.begin : end_ - reach;
    const Walls walls{low, -field.half_width, end_of_all() - low, 2 * field.half_width};
    std::erase_if(laid_, [&](const SingleFloe& floe) { return floe.pose.x < low - reach; });

    const double clearance = scenario_.arrangement.clearance;
    const std::uint64_t key = digest64(fmt::format("{:016x} part {}", geometry_, part));
    RandomStream random(seed_, number_, StreamId::scattering, key);
    const double from = wall - diagonals_at_the_wall * reach;
    const std::vector<PlanarPose> loose = shaken(before, {end_, from}, reach, random);
    const std::vector<Outline> fixed = outlines_of(laid_);
    const std::vector<PlanarPose> fixed_poses = poses_of(laid_);
    std::optional<Beside> beside;
    if (!laid_.empty()) beside = {{fixed, fixed_poses}, loose, from, end_};
    const std::vector<PlanarPose> poses = scattered(walls, outlines_of(floes), clearance, random, beside);
    for (std::size_t i = 0; i < floes.size(); ++i) floes[i].pose = poses[i];
    std::ranges::stable_sort(floes, {}, [](const SingleFloe& floe) { return floe.pose.x; });

    const auto stay = static_cast<std::ptrdiff_t>(field.floes);
    waiting_.assign(floes.begin() + stay, floes.end());
    end_ = 0.5 * (floes[static_cast<std::size_t>(stay) - 1].pose.x + waiting_.front().pose.x);
    floes.resize(static_cast<std::size_t>(stay));
    laid_.insert(laid_.end(), floes.begin(), floes.end());
    expect_none(nearness_fault(walls, outlines_of(laid_), poses_of(laid_), clearance), part, number_);
    return {std::move(floes), end_};
}

}  // namespace floes
