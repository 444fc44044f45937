#include "simulation/nearby_ice.hpp"

#include <algorithm>
#include <cmath>

#include "core/state_archive.hpp"
#include "shapes/hydrostatics.hpp"
#include "simulation/record.hpp"

namespace floes {

NearbyIce::NearbyIce(const Scenario& scenario, const Channel& channel)
    : sheets_(channel.sheets),
      waterplane_(hydrostatics(scenario.structure.shape).waterplane),
      thickness_(scenario.floe.thickness) {
    for (const std::vector<Vec2>& outline : scenario.structure.shape.waterlines())
        for (const Vec2& corner : outline) waterline_.push_back({corner.x(), 0, corner.y()});
    const Box3 box = box_round(waterline_);
    low_ = box.min();
    high_ = box.max();
    const double breadth = high_.z() - low_.z();
    high_ += Vec3{breadth, 0, breadth};
    low_.z() -= breadth;
    if (scenario.field.sides == FieldSides::wall)
        for (const double side : {-1.0, 1.0}) walls_.push_back({{0, side}, scenario.field.half_width});
    within_.reserve(4 + sheets_.size() + walls_.size());
    for (Outline* outline : {&box_, &seen_, &spare_})
        outline->reserve(most_corners + 4 + sheets_.size() + walls_.size());
    if (!walls_.empty()) waterplane_ = waterplane_between_walls(scenario.structure.shape);
}

/// Of a hull that does not turn: it may be wider than the field. A piece that only stands on the water, as on one
/// below, takes nothing of it.
double NearbyIce::waterplane_between_walls(const Shape& shape) {
    std::vector<std::vector<Vec2>> outlines;
    const auto reaches_below = [](const ConvexSolid& solid) {
        return std::ranges::any_of(solid.corners(round_sides), [](const Vec3& corner) { return corner.y() < 0; });
    };
    if (shape.is_of_revolution())
        outlines = shape.waterlines();
    else
        for (const ConvexSolid& solid : shape.solids())
            if (reaches_below(solid)) outlines.push_back(solid.section(0, round_sides));
    double area = 0;
    for (const std::vector<Vec2>& outline : outlines) {
        seen_.clear();
        for (const Vec2& corner : outline) seen_.push_back({corner.x(), corner.y()});
        if (area_of(seen_) < 0) std::ranges::reverse(seen_);
        for (const HalfPlane& wall : walls_) cut_to(wall);
        if (!seen_.empty()) area += area_of(seen_);
    }
    return area;
}

void NearbyIce::cut_to(const HalfPlane& half) {
    clip_into(spare_, seen_, half);
    seen_.swap(spare_);
}

void NearbyIce::lay_box(std::span<const SheetMotion> sheets, const StructurePose& at) {
    const Quat turn = turned_about_y(at.yaw);
    const auto corner = [&](double x, double z) {
        const Vec3 there = at.position + turn * Vec3{x, 0, z};
        return Corner{there.x(), there.z()};
    };
    seen_.assign({corner(low_.x(), low_.z()), corner(high_.x(), low_.z()), corner(high_.x(), high_.z()),
                  corner(low_.x(), high_.z())});
    within_.clear();
    for (std::size_t k = 0; k < seen_.size(); ++k) {
        const Corner normal = outward(seen_, k);
        within_.push_back({normal, dot(normal, seen_[k])});
    }
    for (std::size_t k = 0; k < sheets_.size(); ++k) {
        const IceSheet& form = sheets_[k];
        const double way = k < sheets.size() ? sheets[k].way : 0;
        const Vec3 edge = form.centre + form.half_extents.cwiseProduct(form.inwards) + way * form.inwards;
        within_.push_back({{-form.inwards.x(), -form.inwards.z()}, -edge.dot(form.inwards)});
        cut_to(within_.back());
    }
    for (const HalfPlane& wall : walls_) cut_to(within_.emplace_back(wall));
    box_.swap(seen_);
}

/// The element as seen from above, m².
double NearbyIce::area_in_box(const CutElement& element, const BodyState& state) {
    double reach = 0;
    for (const Corner& one : element.corners) reach = std::max(reach, std::hypot(one.x, one.z));
    const Corner middle{state.position.x(), state.position.z()};
    const auto room = [&](const HalfPlane& half) { return half.bound - dot(half.normal, middle); };
    if (std::ranges::any_of(within_, [&](const HalfPlane& half) { return room(half) <= -reach; })) return 0;
    seen_.clear();
    for (const Corner& one : element.corners) {
        const Vec3 there = state.position + state.rotation * Vec3{one.x, 0, one.z};
        seen_.push_back({there.x(), there.z()});
    }
    if (area_of(seen_) < 0) std::ranges::reverse(seen_);  // upside down
    for (const HalfPlane& half : within_)
        if (!seen_.empty() && room(half) < reach) cut_to(half);
    return seen_.empty() ? 0.0 : area_of(seen_);
}

void NearbyIce::reach_to(const CutElement& element, const BodyState& state) {
    const double half = 0.5 * thickness_ * std::abs(state.rotation(1, 1));
    for (const Corner& one : element.corners) {
        const double middle = state.position.y() + state.rotation(1, 0) * one.x + state.rotation(1, 2) * one.z;
        height_ = std::max(height_, middle + half);
        draught_ = std::max(draught_, half - middle);
    }
}

void NearbyIce::look(int step, const IceField& ice, std::span<const BodyState> states,
                     std::span<const SheetMotion> sheets, const StructurePose& at) {
    if (step % steps_a_look != 0) return;
    lay_box(sheets, at);
    double covered = 0;
    height_ = draught_ = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const IceElement& element = ice.elements()[i];
        if (!ice.is_there(element.floe)) continue;
        const CutElement& cut = ice.cut_element(element);
        const double area = area_in_box(cut, states[i]);
        if (area > 0) reach_to(cut, states[i]);
        if (!(states[i].position.y() < -thickness_)) covered += area;
    }
    concentration_ = covered / (area_of(box_) - waterplane_);
}

IceAmount NearbyIce::astern(const IceField& ice, std::span<const BodyState> states, const StructurePose& at) const {
    const Pose pose = at.pose();
    double line = at.position.x();
    for (const Vec3& corner : waterline_) line = std::min(line, (pose.position + pose.orientation * corner).x());
    IceAmount found;
    for (int place = 0; place < ice.places(); ++place) {
        if (!ice.is_there(place)) continue;
        double area = 0;
        double moment = 0;
        for (const std::size_t i : ice.indices(place)) {
            const double own = ice.cut_element(ice.elements()[i]).area;
            const double x = states[i].position.x();
            area += own;
            moment += own * x;
            if (x < line) found.area += own;
        }
        if (moment < line * area) ++found.floes;
    }
    return found;
}

void NearbyIce::archive(StateArchive& state) {
    auto& [sheets, walls, waterline, low, high, waterplane, thickness, within, box, seen, spare, concentration, height,
           draught] = *this;
    state(concentration, height, draught);
}

}  // namespace floes
