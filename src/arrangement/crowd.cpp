#include "arrangement/crowd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "core/error.hpp"

namespace floes {

namespace {

constexpr double relative_rounding = 1e-9;  // relative

/// At least as wide as the floes lie apart on average: a wide area with few of them is not divided into millions.
double width_of(const CellArea& area, double reach, std::size_t floes) {
    const double wanted = reach * (1 + relative_rounding);
    if (area.periodic) return wanted;
    return std::max(wanted,
                    std::sqrt(area.length * area.breadth / static_cast<double>(std::max<std::size_t>(floes, 1))));
}

int cells_along(double length, double width, bool periodic) {
    const int count = length > width ? static_cast<int>(std::floor(length / width)) : 1;
    if (periodic && count < 3) {
        throw InputError("a periodic box must be at least three floe diagonals wide; use more floes");
    }
    return count;
}

}  // namespace

Cells::Cells(const CellArea& area, double reach, std::size_t floes)
    : area_(area),
      columns_(cells_along(area.length, width_of(area, reach, floes), area.periodic)),
      rows_(cells_along(area.breadth, width_of(area, reach, floes), area.periodic)),
      columns_per_metre_(area.length > 0 ? columns_ / area.length : 0),
      rows_per_metre_(area.breadth > 0 ? rows_ / area.breadth : 0),
      count_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0),
      residents_(count_.size() * static_cast<std::size_t>(capacity_)),
      slot_(floes),
      neighbours_begin_{0} {
    constexpr std::array<std::array<int, 2>, 9> steps{
        {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
    for (int column = 0; column < columns_; ++column) {
        for (int row = 0; row < rows_; ++row) {
            for (const auto& [to_column, to_row] : steps) {
                int other_column = column + to_column;
                int other_row = row + to_row;
                if (area.periodic) {
                    other_column = (other_column + columns_) % columns_;
                    other_row = (other_row + rows_) % rows_;
                }
                if (other_column < 0 || other_column >= columns_ || other_row < 0 || other_row >= rows_) continue;
                neighbours_.push_back(other_column * rows_ + other_row);
            }
            neighbours_begin_.push_back(neighbours_.size());
        }
    }
}

int Cells::cell_at(double x, double z) const {
    const auto number = [](double cells, int count) { return static_cast<int>(std::clamp(cells, 0.0, count - 1.0)); };
    return number((x - area_.low_x) * columns_per_metre_, columns_) * rows_ +
           number((z - area_.low_z) * rows_per_metre_, rows_);
}

void Cells::insert(const Resident& resident) {
    const int cell = cell_at(resident.x, resident.z);
    int& count = count_[static_cast<std::size_t>(cell)];
    if (count == capacity_) make_room();
    residents_[first(cell) + static_cast<std::size_t>(count)] = resident;
    slot_[static_cast<std::size_t>(resident.floe)] = {cell, count};
    ++count;
}

void Cells::make_room() {
    const int before = std::exchange(capacity_, 2 * capacity_);
    std::vector<Resident> residents(count_.size() * static_cast<std::size_t>(capacity_));
    for (std::size_t cell = 0; cell < count_.size(); ++cell) {
        std::copy_n(residents_.begin() + static_cast<std::ptrdiff_t>(cell) * before, count_[cell],
                    residents.begin() + static_cast<std::ptrdiff_t>(cell) * capacity_);
    }
    residents_ = std::move(residents);
}

void Cells::erase(Slot slot) {
    int& count = count_[static_cast<std::size_t>(slot.cell)];
    --count;
    const Resident& last = residents_[first(slot.cell) + static_cast<std::size_t>(count)];
    slot_[static_cast<std::size_t>(last.floe)] = slot;
    residents_[first(slot.cell) + static_cast<std::size_t>(slot.index)] = last;
}

void Cells::move(const Resident& resident) {
    const Slot slot = slot_[static_cast<std::size_t>(resident.floe)];
    if (cell_at(resident.x, resident.z) == slot.cell) {
        residents_[first(slot.cell) + static_cast<std::size_t>(slot.index)] = resident;
        return;
    }
    erase(slot);
    insert(resident);
}

namespace {

const std::array<Vec2, 4> wall_normals{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};  // into the field

/// How fast a point at arm from the middle moves along direction as the rectangle turns, m/rad.
double lever(const Vec2& arm, const Vec2& direction) {
    return direction.x() * arm.y() - direction.y() * arm.x();
}

/// Contact point from the centre of the rectangle that owns the pressed face, whose outward normal is `normal`. The
/// other lies at `apart` and presses with one end or the whole of the side that faces it: the mean of both ends of the
/// part of that side below the face and between its corners, weighted by their depths.
Vec2 pressed_point(const TurnedRectangle& pressed, const TurnedRectangle& other, const Vec2& apart, const Vec2& normal,
                   double depth) {
    const double on_along = normal.dot(along(other.turn));
    const double on_across = normal.dot(across(other.turn));
    const bool presses_along = std::abs(on_along) < std::abs(on_across);  // the pressing side runs along its own x
    const Vec2 tangent = presses_along ? Vec2(std::copysign(1.0, -on_along) * along(other.turn))
                                       : Vec2(std::copysign(1.0, -on_across) * across(other.turn));
    Vec2 deepest = apart + corner(other.shape, other.turn, -normal);
    // Its points are deepest - s tangent, 0 <= s <= length; the depth falls by rise s.
    const double rise = -tangent.dot(normal);
    double low = 0;
    double high = 2 * (presses_along ? other.shape.half_length : other.shape.half_breadth);
    const Vec2 side(-normal.y(), normal.x());
    const bool side_is_breadth = std::abs(normal.dot(along(pressed.turn))) > std::abs(normal.dot(across(pressed.turn)));
    const double reach = side_is_breadth ? pressed.shape.half_breadth : pressed.shape.half_length;
    const double at = side.dot(deepest);
    const double rate = side.dot(tangent);  // at least 0.7 in size: the pressing side faces the pressed one
    low = std::max(low, std::min((at - reach) / rate, (at + reach) / rate));
    high = std::min(high, std::max((at - reach) / rate, (at + reach) / rate));
    const double low_depth = std::max(depth - rise * low, 0.0);
    const double high_depth = std::max(depth - rise * high, 0.0);
    if (high < low || low_depth + high_depth <= 0) return deepest;
    return deepest - (low_depth * low + high_depth * high) / (low_depth + high_depth) * tangent;
}

double area(const Rectangle& shape) {
    return shape.half_length * shape.half_breadth;
}

template <class Body>
void shift(Body& body, const Vec2& arm, const Vec2& normal, double push) {
    body.place += push * normal;
    body.yaw += push * body.turn_weight * lever(arm, normal);
    body.turn = turn_of(body.yaw);
}

}  // namespace

void Crowd::Body::lie(const PlanarPose& pose) {
    yaw = pose.yaw;
    turn = turn_of(pose.yaw);
    place = {pose.x, pose.z};
}

Crowd::Crowd(const Walls& walls, std::span<const Rectangle> shapes, std::span<const PlanarPose> poses,
             const Fixed<Rectangle>& fixed)
    : walls_(walls),
      diagonal_(2 * std::max(widest_reach(shapes), widest_reach(fixed.shapes))),
      skin_(0.25 * widest_reach(shapes)),
      free_(poses.size()) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const double reach = shapes[i].half_diagonal();
        bodies_.push_back({.shape = shapes[i],
                           .weight = area(shapes.front()) / area(shapes[i]),
                           .turn_weight = turning / (reach * reach),
                           .turn = {}});
        bodies_.back().lie(poses[i]);
    }
    for (std::size_t i = 0; i < fixed.poses.size(); ++i) {
        bodies_.push_back({.shape = fixed.shapes[i], .weight = 0, .turn_weight = 0, .turn = {}});
        bodies_.back().lie(fixed.poses[i]);
    }
    find_neighbours();
}

double Crowd::sweep() {
    if (neighbours_are_old()) find_neighbours();
    double deepest = 0;
    for (const auto& [first, second] : pairs_) {
        const auto met = contact(bodies_[first], bodies_[second]);
        if (!met) continue;
        deepest = std::max(deepest, met->depth);
        Body& one = bodies_[first];
        Body& other = bodies_[second];
        const double by_one = lever(met->arm_first, met->normal);
        const double by_other = lever(met->arm_second, met->normal);
        // By ratios of weights, which are exactly 1 where floes are alike.
        const double ratio = other.weight / one.weight;  // 0 for a fixed one, which is never the first of a pair
        const double turned = by_one * by_one + by_other * by_other * ratio * (other.turn_weight / one.turn_weight);
        const double push = over_relaxation * met->depth / (1 + ratio + one.turn_weight * turned);
        shift(one, met->arm_first, met->normal, -push);
        shift(other, met->arm_second, met->normal, ratio * push);
    }
    for (Body& body : std::span(bodies_).first(free_)) {
        for (const Vec2& normal : wall_normals) {
            const auto met = contact(body, normal);
            if (!met) continue;
            deepest = std::max(deepest, met->depth);
            const double by = lever(met->arm_first, normal);
            shift(body, met->arm_first, normal, met->depth / (1 + body.turn_weight * by * by));
        }
    }
    return deepest;
}

// `see(rectangle, depth)` of both rectangles of a pair, and of each that overlaps a wall.
template <class See>
void Crowd::for_each_overlap(const See& see) const {
    for (const auto& [first, second] : pairs_) {
        const auto met = contact(bodies_[first], bodies_[second]);
        if (!met) continue;
        see(first, met->depth);
        see(second, met->depth);
    }
    for (std::size_t i = 0; i < free_; ++i) {
        for (const Vec2& normal : wall_normals)
            if (const auto met = contact(bodies_[i], normal)) see(i, met->depth);
    }
}

std::vector<double> Crowd::overlaps() const {
    std::vector<double> sums(bodies_.size(), 0);
    for_each_overlap([&](std::size_t rectangle, double depth) { sums[rectangle] += depth; });
    sums.resize(free_);
    return sums;
}

double Crowd::deepest() const {
    double deepest = 0;
    for_each_overlap([&](std::size_t, double depth) { deepest = std::max(deepest, depth); });
    return deepest;
}

double Crowd::overlap_at(std::size_t rectangle, const PlanarPose& pose) const {
    Body there = bodies_[rectangle];
    there.lie(pose);
    double sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (i == rectangle) continue;
        if (const auto met = contact(there, bodies_[i])) sum += met->depth;
    }
    for (const Vec2& normal : wall_normals)
        if (const auto met = contact(there, normal)) sum += met->depth;
    return sum;
}

void Crowd::put(std::size_t rectangle, const PlanarPose& pose) {
    bodies_[rectangle].lie(pose);
}

std::vector<PlanarPose> Crowd::poses() const {
    std::vector<PlanarPose> result;
    for (const Body& body : std::span(bodies_).first(free_))
        result.push_back({body.place.x(), body.place.y(), std::remainder(body.yaw, 2 * std::numbers::pi)});
    return result;
}

std::optional<Crowd::Contact> Crowd::contact(const Body& first, const Body& second) const {
    const Vec2 apart = second.place - first.place;
    if (apart.squaredNorm() >= diagonal_ * diagonal_) return {};
    Contact found{std::numeric_limits<double>::infinity(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
    bool side_of_first = true;
    for (const bool is_first : {true, false}) {
        const Turn turn = is_first ? first.turn : second.turn;
        const Extent reach =
            is_first ? joint_extent(first.turned(), second.turned()) : joint_extent(second.turned(), first.turned());
        for (const auto& [axis, width] : {std::pair{along(turn), reach.x}, std::pair{across(turn), reach.z}}) {
            const double distance = axis.dot(apart);
            const double depth = width - std::abs(distance);
            if (depth <= 0) return {};
            if (depth >= found.depth) continue;
            found.depth = depth;
            found.normal = distance < 0 ? Vec2(-axis) : axis;
            side_of_first = is_first;
        }
    }
    if (side_of_first) {
        found.arm_first = pressed_point(first.turned(), second.turned(), apart, found.normal, found.depth);
        found.arm_second = found.arm_first - apart;
    } else {
        found.arm_second = pressed_point(second.turned(), first.turned(), -apart, -found.normal, found.depth);
        found.arm_first = found.arm_second + apart;
    }
    return found;
}

std::optional<Crowd::Contact> Crowd::contact(const Body& body, const Vec2& wall_normal) const {
    const Vec2 arm = corner(body.shape, body.turn, -wall_normal);
    const Vec2 edge(wall_normal.x() > 0 ? walls_.low_x : walls_.low_x + walls_.length,
                    wall_normal.y() > 0 ? walls_.low_z : walls_.low_z + walls_.breadth);
    const double depth = wall_normal.dot(edge - body.place - arm);
    if (depth <= 0) return {};
    return Contact{depth, wall_normal, arm, Vec2::Zero()};
}

bool Crowd::neighbours_are_old() const {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if ((bodies_[i].place - places_[i]).squaredNorm() > 0.25 * skin_ * skin_) return true;
    return false;
}

void Crowd::find_neighbours() {
    const double reach = diagonal_ + skin_;
    Cells cells({walls_.low_x, walls_.low_z, walls_.length, walls_.breadth}, reach, bodies_.size());
    places_.clear();
    pairs_.clear();
    for (const Body& body : bodies_) {
        const std::size_t number = places_.size();
        const double own = body.shape.half_diagonal();
        cells.for_each_near(body.place.x(), body.place.y(), [&](const Resident& other) {
            if (static_cast<std::size_t>(other.floe) >= free_) return;  // both are fixed
            const double both = own + bodies_[static_cast<std::size_t>(other.floe)].shape.half_diagonal() + skin_;
            if ((body.place - Vec2(other.x, other.z)).squaredNorm() < both * both)
                pairs_.emplace_back(static_cast<std::size_t>(other.floe), number);
        });
        cells.insert({body.place.x(), body.place.y(), body.turn, static_cast<int>(number)});
        places_.push_back(body.place);
    }
    // In order of numbers, so that sweeps have no preferred direction.
    std::ranges::sort(pairs_);
}

}  // namespace floes
