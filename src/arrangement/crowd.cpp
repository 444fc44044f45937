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

constexpr std::array<Corner, 4> field_normals{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};  // into the field

/// How fast a point at arm from the middle moves along a direction as yaw grows, m/rad.
double lever(const Corner& arm, const Corner& direction) {
    return cross(direction, arm);
}

/// The edge of a polygon that another one overlaps least.
struct Face {
    double gap = -std::numeric_limits<double>::infinity();
    std::size_t edge = 0;
};

Face widest(Corners one, Corners other, const Corner& apart) {
    Face best;
    for (std::size_t k = 0; k < one.size(); ++k) {
        const Corner normal = outward(one, k);
        double gap = std::numeric_limits<double>::infinity();
        for (const Corner& corner : other) gap = std::min(gap, dot(normal, corner + apart - one[k]));
        if (gap > best.gap) best = {gap, k};
        if (gap >= 0) return best;
    }
    return best;
}

/// Where the other polygon, at `apart`, presses on an edge: the mean, weighted by depth, of both ends of the part of
/// its pressing edge that lies below that edge and between its ends.
Corner pressed_point(Corners one, std::size_t edge, Corners other, const Corner& apart) {
    const Corner normal = outward(one, edge);
    const auto depth = [&](const Corner& p) { return -dot(normal, p - one[edge]); };
    std::size_t deepest = 0;
    for (std::size_t k = 1; k < other.size(); ++k)
        if (depth(other[k] + apart) > depth(other[deepest] + apart)) deepest = k;
    const Corner from = other[deepest] + apart;
    const Corner before = other[deepest > 0 ? deepest - 1 : other.size() - 1] + apart;
    const Corner next = after(other, deepest) + apart;
    const Corner along{-normal.z, normal.x};
    const auto slope = [&](const Corner& to) {
        return (depth(from) - depth(to)) / std::sqrt(dot(to - from, to - from));
    };
    const Corner to = slope(before) < slope(next) ? before : next;
    double low = 0;  // shares of the way from `from` to `to`
    double high = 1;
    const double begin = dot(along, one[edge]);
    const double end = dot(along, after(one, edge));
    const double at = dot(along, from);
    const double rate = dot(along, to - from);
    if (rate != 0) {
        low = std::max(low, std::min((begin - at) / rate, (end - at) / rate));
        high = std::min(high, std::max((begin - at) / rate, (end - at) / rate));
    }
    const auto point = [&](double share) { return from + share * (to - from); };
    if (high < low) return from;
    const double low_depth = std::max(depth(point(low)), 0.0);
    const double high_depth = std::max(depth(point(high)), 0.0);
    if (low_depth + high_depth <= 0) return from;
    return point((low_depth * low + high_depth * high) / (low_depth + high_depth));
}

/// Contact point from the centre of the rectangle that owns the pressed face, whose outward normal is `normal`. The
/// other lies at `apart` and presses with one end or the whole of the side that faces it: the mean of both ends of the
/// part of that side below the face and between its corners, weighted by their depths.
Vec2 pressed_point_of_rectangle(const TurnedRectangle& pressed, const TurnedRectangle& other, const Vec2& apart,
                                const Vec2& normal, double depth) {
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

Vec2 as_vector(const Corner& at) {
    return {at.x, at.z};
}
Corner as_corner(const Vec2& at) {
    return {at.x(), at.y()};
}

}  // namespace

void Crowd::Body::lie(const PlanarPose& at) {
    pose = at;
    turn = turn_of(at.yaw);
    if (!rectangle) turn_corners(own, turn, corners);
}

void Crowd::Body::shift(const Corner& arm, const Corner& normal, double push) {
    lie({pose.x + push * normal.x, pose.z + push * normal.z, pose.yaw + push * turn_weight * lever(arm, normal)});
}

Crowd::Crowd(const Walls& walls, std::span<const Outline> outlines, std::span<const PlanarPose> poses,
             const Fixed& fixed)
    : walls_(walls), free_(poses.size()) {
    const bool all = std::ranges::all_of(outlines, is_rectangle) && std::ranges::all_of(fixed.outlines, is_rectangle);
    const double first = area_of(outlines.front());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        Body& body = add(outlines[i], all, poses[i]);
        body.weight = first / area_of(outlines[i]);
        body.turn_weight = turning / (body.reach * body.reach);
    }
    skin_ = 0.25 * widest_;
    for (std::size_t i = 0; i < fixed.poses.size(); ++i) add(fixed.outlines[i], all, fixed.poses[i]);
    find_neighbours();
}

Crowd::Body& Crowd::add(const Outline& outline, bool as_rectangle, const PlanarPose& pose) {
    Body& body = bodies_.emplace_back();
    body.own = outline;
    if (as_rectangle) body.rectangle = {half_sides_of(outline)->x, half_sides_of(outline)->z};
    body.reach = reach_of(outline);
    body.lie(pose);
    widest_ = std::max(widest_, body.reach);
    return body;
}

double Crowd::sweep() {
    if (neighbours_are_old()) find_neighbours();
    double deepest = 0;
    for (const auto& [first, second] : pairs_) {
        Body& one = bodies_[first];
        Body& other = bodies_[second];
        const auto met = contact(one, other);
        if (!met) continue;
        deepest = std::max(deepest, met->depth);
        const double by_one = lever(met->arm_first, met->normal);
        const double by_other = lever(met->arm_second, met->normal);
        // By ratios of weights, which are exactly 1 where floes are alike.
        const double ratio = other.weight / one.weight;  // 0 for a fixed one, which is never the first of a pair
        const double turned = by_one * by_one + by_other * by_other * ratio * (other.turn_weight / one.turn_weight);
        const double push = over_relaxation * met->depth / (1 + ratio + one.turn_weight * turned);
        one.shift(met->arm_first, met->normal, -push);
        if (second < free_) other.shift(met->arm_second, met->normal, ratio * push);
    }
    for (Body& body : std::span(bodies_).first(free_)) {
        for (const Corner& normal : field_normals) {
            const auto met = contact(body, normal);
            if (!met) continue;
            deepest = std::max(deepest, met->depth);
            const double by = lever(met->arm_first, normal);
            body.shift(met->arm_first, normal, met->depth / (1 + body.turn_weight * by * by));
        }
    }
    return deepest;
}

template <class See>
void Crowd::for_each_overlap(const See& see) const {
    for (const auto& [first, second] : pairs_) {
        const auto met = contact(bodies_[first], bodies_[second]);
        if (!met) continue;
        see(first, met->depth);
        see(second, met->depth);
    }
    for (std::size_t i = 0; i < free_; ++i)
        for (const Corner& normal : field_normals)
            if (const auto met = contact(bodies_[i], normal)) see(i, met->depth);
}

double Crowd::deepest() const {
    double deepest = 0;
    for_each_overlap([&](std::size_t, double depth) { deepest = std::max(deepest, depth); });
    return deepest;
}

std::vector<double> Crowd::overlaps() const {
    std::vector<double> sums(bodies_.size(), 0);
    for_each_overlap([&](std::size_t floe, double depth) { sums[floe] += depth; });
    sums.resize(free_);
    return sums;
}

double Crowd::overlap_at(std::size_t floe, const PlanarPose& pose) const {
    Body there = bodies_[floe];
    there.lie(pose);
    double sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (i == floe) continue;
        if (const auto met = contact(there, bodies_[i])) sum += met->depth;
    }
    for (const Corner& normal : field_normals)
        if (const auto met = contact(there, normal)) sum += met->depth;
    return sum;
}

std::vector<PlanarPose> Crowd::poses() const {
    std::vector<PlanarPose> result;
    for (const Body& body : std::span(bodies_).first(free_))
        result.push_back({body.pose.x, body.pose.z, std::remainder(body.pose.yaw, 2 * std::numbers::pi)});
    return result;
}

std::optional<Crowd::Contact> Crowd::contact(const Body& first, const Body& second) {
    const Corner apart = second.place() - first.place();
    const double reach = first.reach + second.reach;
    if (dot(apart, apart) >= reach * reach) return {};
    if (first.rectangle && second.rectangle) return contact_of_rectangles(first, second);
    const Face of_first = widest(first.corners, second.corners, apart);
    if (of_first.gap >= 0) return {};
    const Face of_second = widest(second.corners, first.corners, -1 * apart);
    if (of_second.gap >= 0) return {};
    if (of_first.gap >= of_second.gap) {
        const Corner at = pressed_point(first.corners, of_first.edge, second.corners, apart);
        return Contact{-of_first.gap, outward(first.corners, of_first.edge), at, at - apart};
    }
    const Corner at = pressed_point(second.corners, of_second.edge, first.corners, -1 * apart);
    return Contact{-of_second.gap, -1 * outward(second.corners, of_second.edge), at + apart, at};
}

/// The same in fewer operations.
std::optional<Crowd::Contact> Crowd::contact_of_rectangles(const Body& first, const Body& second) {
    const Vec2 apart = as_vector(second.place() - first.place());
    const TurnedRectangle one{*first.rectangle, first.turn};
    const TurnedRectangle other{*second.rectangle, second.turn};
    double least = std::numeric_limits<double>::infinity();
    Vec2 normal = Vec2::Zero();
    bool side_of_first = true;
    for (const bool is_first : {true, false}) {
        const Turn turn = is_first ? first.turn : second.turn;
        const Extent reach = is_first ? joint_extent(one, other) : joint_extent(other, one);
        for (const auto& [axis, width] : {std::pair{along(turn), reach.x}, std::pair{across(turn), reach.z}}) {
            const double distance = axis.dot(apart);
            const double depth = width - std::abs(distance);
            if (depth <= 0) return {};
            if (depth >= least) continue;
            least = depth;
            normal = distance < 0 ? Vec2(-axis) : axis;
            side_of_first = is_first;
        }
    }
    if (side_of_first) {
        const Vec2 at = pressed_point_of_rectangle(one, other, apart, normal, least);
        return Contact{least, as_corner(normal), as_corner(at), as_corner(at - apart)};
    }
    const Vec2 at = pressed_point_of_rectangle(other, one, -apart, -normal, least);
    return Contact{least, as_corner(normal), as_corner(at + apart), as_corner(at)};
}

std::optional<Crowd::Contact> Crowd::contact(const Body& body, const Corner& wall_normal) const {
    const Corner arm = body.rectangle ? as_corner(corner(*body.rectangle, body.turn, -as_vector(wall_normal)))
                                      : *std::ranges::min_element(body.corners, {},
                                                                  [&](const Corner& p) { return dot(wall_normal, p); });
    const Corner edge{wall_normal.x > 0 ? walls_.low_x : walls_.low_x + walls_.length,
                      wall_normal.z > 0 ? walls_.low_z : walls_.low_z + walls_.breadth};
    const double depth = dot(wall_normal, edge - body.place() - arm);
    if (depth <= 0) return {};
    return Contact{depth, wall_normal, arm, {}};
}

bool Crowd::neighbours_are_old() const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Corner way = bodies_[i].place() - places_[i];
        if (dot(way, way) > 0.25 * skin_ * skin_) return true;
    }
    return false;
}

void Crowd::find_neighbours() {
    Cells cells({walls_.low_x, walls_.low_z, walls_.length, walls_.breadth}, 2 * widest_ + skin_, bodies_.size());
    places_.clear();
    pairs_.clear();
    for (const Body& body : bodies_) {
        const std::size_t number = places_.size();
        cells.for_each_near(body.pose.x, body.pose.z, [&](const Resident& other) {
            if (static_cast<std::size_t>(other.floe) >= free_) return;  // both are fixed
            const double both = body.reach + bodies_[static_cast<std::size_t>(other.floe)].reach + skin_;
            const Corner apart = body.place() - Corner{other.x, other.z};
            if (dot(apart, apart) < both * both) pairs_.emplace_back(static_cast<std::size_t>(other.floe), number);
        });
        cells.insert({body.pose.x, body.pose.z, {}, static_cast<int>(number)});
        places_.push_back(body.place());
    }
    // In order of numbers, so that sweeps have no preferred direction.
    std::ranges::sort(pairs_);
}

}  // namespace floes
