#include "collision/touching_points.hpp"

#include <cmath>

namespace floes {
namespace {

Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double square(const Triple& a) {
    return dot(a, a);
}

}  // namespace

void TouchingPoints::update(const BoxPlace& a, const BoxPlace& b, const BoxOverlap& overlap, double reach) {
    for (int i = 0; i < overlap.count; ++i) {
        const BoxOverlap::Point& found = overlap.points[static_cast<std::size_t>(i)];
        TouchingPoint point;
        point.distance = -found.depth;
        point.on_b = found.on_b;
        for (std::size_t k = 0; k < 3; ++k) {
            point.normal[k] = -overlap.normal[k];
            point.on_a[k] = point.on_b[k] + point.normal[k] * point.distance;
        }
        point.in_a = to_box(a, point.on_a);
        point.in_b = to_box(b, point.on_b);
        add(point, reach);
    }
    refresh(a, b, reach);
}

/// A point near a known one takes its place and its impulses.
void TouchingPoints::add(const TouchingPoint& point, double reach) {
    double nearest = reach * reach;
    int place = -1;
    for (int i = 0; i < count_; ++i) {
        const double apart = square((*this)[i].in_a - point.in_a);
        if (apart < nearest) {
            nearest = apart;
            place = i;
        }
    }
    if (place >= 0) {
        TouchingPoint& known = (*this)[place];
        const double impulse = known.impulse;
        const Triple slide = known.slide;
        const double friction_impulse = known.friction_impulse;
        known = point;
        known.impulse = impulse;
        known.slide = slide;
        known.friction_impulse = friction_impulse;
        return;
    }
    (*this)[count_ < most ? count_++ : least_wanted(point)] = point;
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

void TouchingPoints::refresh(const BoxPlace& a, const BoxPlace& b, double reach) {
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

}  // namespace floes
