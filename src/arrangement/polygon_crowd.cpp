#include "arrangement/polygon_crowd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "arrangement/crowd.hpp"
#include "core/turn.hpp"

namespace floes {
namespace {

constexpr double skin = 0.25;  // of the largest reach

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

}  // namespace

void PolygonCrowd::Body::lie(const PlanarPose& at) {
    pose = at;
    const Turn turn = turn_of(at.yaw);
    corners = from_axes(own, {}, {turn.cos, -turn.sin});
}

void PolygonCrowd::Body::shift(const Corner& arm, const Corner& normal, double push) {
    lie({pose.x + push * normal.x, pose.z + push * normal.z, pose.yaw + push * turn_weight * lever(arm, normal)});
}

PolygonCrowd::PolygonCrowd(const Walls& walls, std::span<const Outline> outlines, std::span<const PlanarPose> poses,
                           const Fixed<Outline>& fixed)
    : walls_(walls), free_(poses.size()) {
    const double first = area_of(outlines.front());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        Body& body = add(outlines[i], poses[i]);
        body.weight = first / area_of(outlines[i]);
        body.turn_weight = turning / (body.reach * body.reach);
    }
    for (std::size_t i = 0; i < fixed.poses.size(); ++i) add(fixed.shapes[i], fixed.poses[i]);
    find_neighbours();
}

PolygonCrowd::Body& PolygonCrowd::add(const Outline& outline, const PlanarPose& pose) {
    Body& body = bodies_.emplace_back();
    body.own = outline;
    body.reach = reach_of(outline);
    body.lie(pose);
    widest_ = std::max(widest_, body.reach);
    return body;
}

double PolygonCrowd::sweep() {
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
        const double sum = one.weight * (1 + one.turn_weight * by_one * by_one) +
                           other.weight * (1 + other.turn_weight * by_other * by_other);
        const double push = over_relaxation * met->depth / sum;
        one.shift(met->arm_first, met->normal, -push * one.weight);
        if (second < free_) other.shift(met->arm_second, met->normal, push * other.weight);
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
void PolygonCrowd::for_each_overlap(const See& see) const {
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

double PolygonCrowd::deepest() const {
    double deepest = 0;
    for_each_overlap([&](std::size_t, double depth) { deepest = std::max(deepest, depth); });
    return deepest;
}

std::vector<double> PolygonCrowd::overlaps() const {
    std::vector<double> sums(bodies_.size(), 0);
    for_each_overlap([&](std::size_t polygon, double depth) { sums[polygon] += depth; });
    sums.resize(free_);
    return sums;
}

double PolygonCrowd::overlap_at(std::size_t polygon, const PlanarPose& pose) const {
    Body there = bodies_[polygon];
    there.lie(pose);
    double sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (i == polygon) continue;
        if (const auto met = contact(there, bodies_[i])) sum += met->depth;
    }
    for (const Corner& normal : field_normals)
        if (const auto met = contact(there, normal)) sum += met->depth;
    return sum;
}

void PolygonCrowd::put(std::size_t polygon, const PlanarPose& pose) {
    bodies_[polygon].lie(pose);
}

std::vector<PlanarPose> PolygonCrowd::poses() const {
    std::vector<PlanarPose> result;
    for (const Body& body : std::span(bodies_).first(free_))
        result.push_back({body.pose.x, body.pose.z, std::remainder(body.pose.yaw, 2 * std::numbers::pi)});
    return result;
}

std::optional<PolygonCrowd::Contact> PolygonCrowd::contact(const Body& first, const Body& second) {
    const Corner apart = second.place() - first.place();
    const double reach = first.reach + second.reach;
    if (dot(apart, apart) >= reach * reach) return {};
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

std::optional<PolygonCrowd::Contact> PolygonCrowd::contact(const Body& body, const Corner& wall_normal) const {
    const Corner arm =
        *std::ranges::min_element(body.corners, {}, [&](const Corner& p) { return dot(wall_normal, p); });
    const Corner edge{wall_normal.x > 0 ? walls_.low_x : walls_.low_x + walls_.length,
                      wall_normal.z > 0 ? walls_.low_z : walls_.low_z + walls_.breadth};
    const double depth = dot(wall_normal, edge - body.place() - arm);
    if (depth <= 0) return {};
    return Contact{depth, wall_normal, arm, {}};
}

bool PolygonCrowd::neighbours_are_old() const {
    const double most = 0.5 * skin * widest_;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Corner way = bodies_[i].place() - places_[i];
        if (dot(way, way) > most * most) return true;
    }
    return false;
}

void PolygonCrowd::find_neighbours() {
    Cells cells({walls_.low_x, walls_.low_z, walls_.length, walls_.breadth}, (2 + skin) * widest_, bodies_.size());
    places_.clear();
    pairs_.clear();
    for (const Body& body : bodies_) {
        const std::size_t number = places_.size();
        cells.for_each_near(body.pose.x, body.pose.z, [&](const Resident& other) {
            if (static_cast<std::size_t>(other.floe) >= free_) return;  // both are fixed
            const double both = body.reach + bodies_[static_cast<std::size_t>(other.floe)].reach + skin * widest_;
            const Corner apart = body.place() - Corner{other.x, other.z};
            if (dot(apart, apart) < both * both) pairs_.emplace_back(static_cast<std::size_t>(other.floe), number);
        });
        cells.insert({body.pose.x, body.pose.z, {}, static_cast<int>(number)});
        places_.push_back(body.place());
    }
    std::ranges::sort(pairs_);  // so that sweeps have no preferred direction
}

}  // namespace floes
