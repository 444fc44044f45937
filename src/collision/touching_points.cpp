#include "collision/touching_points.hpp"

#include <cmath>

#include "core/state_archive.hpp"

namespace floes {
namespace {

double square(const Triple& a) {
    return dot(a, a);
}

void take_impulses(TouchingPoint& point, const TouchingPoint& known) {
    point.impulse = known.impulse;
    point.slide = known.slide;
    point.friction_impulse = known.friction_impulse;
    point.remembered_slip = known.remembered_slip;
}

}  // namespace

void TouchingPoints::add(const PrismPlace& a, const PrismPlace& b, const Triple& on_b, const Triple& normal,
                         double distance, double reach) {
    TouchingPoint point;
    point.distance = distance;
    point.on_b = on_b;
    point.normal = normal;
    for (std::size_t k = 0; k < 3; ++k) point.on_a[k] = on_b[k] + normal[k] * distance;
    point.in_a = to_own(a, point.on_a);
    point.in_b = to_own(b, point.on_b);
    double nearest = reach * reach;
    int place = -1;
    for (int i = 0; i < count_; ++i) {
        const double apart = square((*this)[i].in_a - point.in_a);
        if (apart < nearest) {
            nearest = apart;
            place = i;
        }
    }
    if (place < 0) {
        (*this)[count_ < most ? count_++ : least_wanted(point)] = point;
        return;
    }
    TouchingPoint& known = (*this)[place];
    floes::take_impulses(point, known);
    known = point;
}

void TouchingPoints::take_impulses(const TouchingPoints& before, double reach) {
    for (int i = 0; i < count_; ++i) {
        TouchingPoint& point = (*this)[i];
        double nearest = reach * reach;
        for (int k = 0; k < before.count(); ++k) {
            const double apart = square(before[k].in_b - point.in_b);
            if (apart >= nearest) continue;
            nearest = apart;
            floes::take_impulses(point, before[k]);
        }
    }
}

/// The deepest point stays; of the others that one goes without which the four span most.
int TouchingPoints::least_wanted(const TouchingPoint& added) const {
    int deepest = -1;
    double least = added.distance;
    for (int i = 0; i < most; ++i) {
        if ((*this)[i].distance < least) {
            deepest = i;
            least = (*this)[i].distance;
        }
    }
    constexpr int others[most][3] = {{1, 3, 2}, {0, 3, 2}, {0, 3, 1}, {0, 2, 1}};
    int widest = -1;
    double most_area = -1e30;
    for (int i = 0; i < most; ++i) {
        const auto& [from, to, opposite] = others[i];
        const double area =
            i == deepest ? 0.0
                         : square(cross(added.in_a - (*this)[from].in_a, (*this)[to].in_a - (*this)[opposite].in_a));
        if (std::abs(area) > most_area) {
            widest = i;
            most_area = std::abs(area);
        }
    }
    return widest < 0 ? 0 : widest;
}

void TouchingPoints::refresh(const PrismPlace& a, const PrismPlace& b, double reach) {
    for (int i = 0; i < count_; ++i) {
        TouchingPoint& point = (*this)[i];
        point.on_a = to_world(a, point.in_a);
        point.on_b = to_world(b, point.in_b);
        point.distance = dot(point.on_a - point.on_b, point.normal);
    }
    for (int i = count_ - 1; i >= 0; --i) {
        const TouchingPoint& point = (*this)[i];
        bool lasts = point.distance <= reach;
        if (lasts) {
            Triple aside;
            for (std::size_t k = 0; k < 3; ++k)
                aside[k] = point.on_b[k] - (point.on_a[k] - point.normal[k] * point.distance);
            lasts = !(square(aside) > reach * reach);
        }
        if (lasts) continue;
        --count_;
        if (i != count_) (*this)[i] = (*this)[count_];
    }
}

void ContactStore::reserve(std::size_t count) {
    points_.reserve(count);
    free_.reserve(count);
}

std::int32_t ContactStore::take() {
    if (free_.empty()) {
        free_.push_back(static_cast<std::int32_t>(points_.size()));
        points_.emplace_back();
    }
    const std::int32_t place = free_.back();
    free_.pop_back();
    (*this)[place] = {};
    return place;
}

void TouchingPoints::archive(StateArchive& state) {
    auto& [points, count] = *this;
    state(count);
    for (int i = 0; i < count; ++i) state(points.at(static_cast<std::size_t>(i)));
}

void ContactStore::archive(StateArchive& state) {
    auto& [points, free] = *this;
    state(points, free);
}

}  // namespace floes
