#include "collision/prism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/state_archive.hpp"

namespace floes {
/// As of boxes (solver/contact_setup.inl): flush faces reach their whole area within micrometres.
constexpr double flattest = 1e-5;

PrismShape::PrismShape(Outline of, double half)
    : corners(std::move(of)), half_thickness(half), half_extent{0, half, 0}, is_box(is_rectangle(corners)) {
    inner_radius = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Corner normal = outward(corners, k);
        const double ahead = dot(normal, corners[k]);
        double back = -ahead;
        for (const Corner& one : corners) back = std::max(back, -dot(normal, one));
        edges.push_back({normal, 0.5 * (ahead + back), 0.5 * (ahead - back)});
        inner_radius = std::min(inner_radius, std::max(ahead, 0.0));
    }
    for (const Corner& one : corners) {
        half_extent[0] = std::max(half_extent[0], std::abs(one.x));
        half_extent[2] = std::max(half_extent[2], std::abs(one.z));
    }
}

PrismSections::PrismSections(const PrismShape& prism, const Triple& normal)
    : prism_(&prism), flat_{normal[0], normal[2]}, cosine_(std::max(std::abs(normal[1]), flattest)) {
    const double size = std::sqrt(dot(flat_, flat_));
    if (size < flattest) flat_ = size > 0 ? (flattest / size) * flat_ : Corner{flattest, 0};
    const std::size_t count = prism.corners.size();
    for (std::size_t k = 0; k < count; ++k) heights_[k] = dot(flat_, prism.corners[k]);
    heights_[count] = heights_[0];
    const auto [low, high] = std::ranges::minmax(std::span(heights_).first(count));
    low_ = low;
    rise_ = 2 * prism.half_thickness * cosine_;
    middle_ = 0.5 * (high - low + rise_);
}

PrismSection PrismSections::below(double height) const {
    const Outline& corners = prism_->corners;
    const Corner along{-flat_.z, flat_.x};
    double low = std::numeric_limits<double>::infinity();  // ends of the chord
    double high = -low;
    PrismSection found;
    Corner first, last;  // about the first corner
    bool any = false;
    const auto add = [&](const Corner& point) {
        const Corner next = point - corners[0];
        if (any)
            found.area += 0.5 * cross(last, next);
        else
            first = next;
        last = next;
        any = true;
    };
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const double room = height - heights_[k];
        const double room_next = height - heights_[k + 1];
        if (room >= 0) add(corners[k]);
        if ((room >= 0) == (room_next >= 0)) continue;
        const Corner at = corners[k] + room / (room - room_next) * (after(corners, k) - corners[k]);
        add(at);
        low = std::min(low, dot(along, at));
        high = std::max(high, dot(along, at));
    }
    if (any) found.area += 0.5 * cross(last, first);
    if (high > low) found.growth = (high - low) / dot(flat_, flat_);  // along is as long as flat_
    return found;
}

PrismSection PrismSections::at(double depth) const {
    const double d = std::min(depth, middle_);
    const PrismSection whole = below(low_ + d);
    const PrismSection past = d > rise_ ? below(low_ + d - rise_) : PrismSection{};
    return {std::max(0.0, (whole.area - past.area) / cosine_),
            depth < middle_ ? std::max(0.0, (whole.growth - past.growth) / cosine_) : 0};
}

PrismSection PrismSections::crushed(double depth) const {
    const Triple& half = prism_->half_extent;
    const double touching = 2 * flattest * std::min({half[0], half[1], half[2]});
    const double taken = std::max(depth, touching);
    const PrismSection section = at(taken);
    return {std::max(0.0, section.area + section.growth * (depth - taken)), section.growth};
}

int edge_towards(const PrismShape& prism, const Triple& direction) {
    int edge = -1;
    double most = std::abs(direction[1]);
    for (std::size_t k = 0; k < prism.edges.size(); ++k) {
        const double along = prism.edges[k].normal.x * direction[0] + prism.edges[k].normal.z * direction[2];
        if (along <= most) continue;
        most = along;
        edge = static_cast<int>(k);
    }
    return edge;
}

void PrismShape::archive(StateArchive& state) {
    auto& [of_corners, of_edges, radius, half, extent, box] = *this;
    state(of_corners, of_edges, radius, half, extent, box);
}

}  // namespace floes
