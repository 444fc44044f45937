#include "simulation/structure_motion.hpp"

#include <cmath>

namespace floes {

StructureMotion::StructureMotion(const Scenario& scenario)
    : time_step_(scenario.general.time_step),
      tow_{scenario.structure.start, scenario.structure.speed},
      straight_(scenario.towed_straight()),
      places_(scenario.places()) {
    if (scenario.moorings.give_way()) moored_.emplace(scenario.moorings, time_step_);
    place(0, moored_state());
}

/// The pose at the end of a step and the velocity in it; of step 0 the start.
PathPlace StructureMotion::prescribed(int step) const {
    if (places_.empty()) return {{tow_.x(step * time_step_), 0, 0}, {tow_.speed, 0}, 0};
    PathPlace place = places_.at(static_cast<std::size_t>(step));
    place.pose.x += tow_.start;
    return place;
}

void StructureMotion::follow(const PathPlace& place) {
    after_ = place.pose;
    velocity_ = {place.velocity.x(), 0, place.velocity.y()};
    turning_ = place.turning;
    pace_ = place.velocity.norm();
}

/// Beside the place that it would have with moorings that do not give way.
void StructureMotion::add_offset() {
    const Vec3& offset = moored_->state().offset;
    after_ = {after_.x + offset[0], after_.z + offset[1], after_.yaw + offset[2]};
}

void StructureMotion::place(int steps, const MooredState& moored) {
    step_ = steps;
    follow(prescribed(steps));
    if (moored_) {
        moored_->place(moored);
        add_offset();
    }
    before_ = after_;
}

void StructureMotion::advance(const Vec3& load) {
    before_ = after_;
    follow(prescribed(++step_));
    if (!moored_) return;
    const Vec3 from = moored_->state().offset;
    moored_->advance(load, step_ * time_step_);
    add_offset();
    const Vec3& offset = moored_->state().offset;
    velocity_ += Vec3(offset[0] - from[0], 0, offset[1] - from[1]) / time_step_;
    turning_ += (offset[2] - from[2]) / time_step_;
}

void StructureMotion::read_lines(std::vector<FrameLine>& lines) const {
    lines.clear();
    if (!moored_) return;
    const Vec3& offset = moored_->state().offset;
    const Vec2 place(after_.x - offset[0], after_.z - offset[1]);
    for (std::size_t i = 0; i < moored_->lines(); ++i) {
        const std::optional<LinePull> pulls = moored_->line(i);
        if (!pulls) continue;
        const Vec2 fairlead = place + pulls->fairlead;
        const Vec2 anchor = place + pulls->anchor;
        lines.push_back(
            {static_cast<int>(i), {fairlead.x(), 0, fairlead.y()}, {anchor.x(), 0, anchor.y()}, pulls->tension});
    }
}

Vec3 StructureMotion::in_own_axes(const Vec3& vector) const {
    if (after_.yaw == 0) return vector;
    const Vec2 own = turned({vector.x(), vector.z()}, -after_.yaw);
    return {own.x(), vector.y(), own.y()};
}

}  // namespace floes
