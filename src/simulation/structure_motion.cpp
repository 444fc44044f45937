#include "simulation/structure_motion.hpp"

#include <algorithm>
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
    after_ = {.position = {place.pose.x, 0, place.pose.z}, .yaw = place.pose.yaw};
    velocity_ = {place.velocity.x(), 0, place.velocity.y()};
    angular_velocity_ = {0, place.turning, 0};
    pace_ = place.velocity.norm();
}

/// Beside the place that it would have with moorings that do not give way.
void StructureMotion::add_offset() {
    const Vec3& offset = moored_->state().offset;
    after_.position += Vec3(offset[0], 0, offset[1]);
    after_.yaw += offset[2];
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

void StructureMotion::advance(const Wrench& load) {
    before_ = after_;
    follow(prescribed(++step_));
    if (!moored_) return;
    const Vec3 from = moored_->state().offset;
    moored_->advance({load.force.x(), load.force.z(), load.moment.y()}, step_ * time_step_);
    add_offset();
    const Vec3& offset = moored_->state().offset;
    velocity_ += Vec3(offset[0] - from[0], 0, offset[1] - from[1]) / time_step_;
    angular_velocity_.y() += (offset[2] - from[2]) / time_step_;
}

void StructureMotion::read_lines(std::vector<FrameLine>& lines) const {
    lines.clear();
    if (!moored_) return;
    const Vec3& offset = moored_->state().offset;
    const Vec2 place(after_.position.x() - offset[0], after_.position.z() - offset[1]);
    for (std::size_t i = 0; i < moored_->lines(); ++i) {
        const std::optional<LinePull> pulls = moored_->line(i);
        if (!pulls) continue;
        const Vec2 fairlead = place + pulls->fairlead;
        const Vec2 anchor = place + pulls->anchor;
        lines.push_back(
            {static_cast<int>(i), {fairlead.x(), 0, fairlead.y()}, {anchor.x(), 0, anchor.y()}, pulls->tension});
    }
}

MooredMotion::MooredMotion(const Moorings& moorings, double step)
    : moorings_(moorings),
      step_(step),
      inertia_(moorings.inertia()),
      springs_(moorings.surge, moorings.sway, moorings.yaw),
      stiffness_(moorings.stiffness()) {
    for (int k = 0; k < moorings.directions(); ++k) {
        linear_.emplace_back(Oscillator{stiffness_[k], inertia_[k], moorings.damping}, step);
        thrusters_.push_back(thrust_law(moorings.thrusters, k, inertia_[k]));
    }
    state_.broken_at.assign(moorings.lines.size(), std::numeric_limits<double>::quiet_NaN());
    for (const MooringLine& line : moorings.lines) largest_.push_back(line.pretension);
}

void MooredMotion::place(const MooredState& state) {
    const std::size_t lines = state_.broken_at.size();
    state_ = state;
    state_.broken_at.resize(lines, std::numeric_limits<double>::quiet_NaN());
}

Vec3 MooredMotion::pull_of_lines(const Vec3& offset) const {
    Vec3 sum = turret_pull(moorings_, offset);
    for (std::size_t i = 0; i < moorings_.lines.size(); ++i)
        if (std::isnan(state_.broken_at[i])) sum += pull(moorings_, moorings_.lines[i], offset).force;
    return sum;
}

/// m v' = -b |v| v, each direction by itself: v / (1 + b |v| t / m).
void MooredMotion::slow_down(double time) {
    const Vec3 quadratic = moorings_.quadratic();
    for (int k = 0; k < moorings_.directions(); ++k)
        state_.velocity[k] /= 1 + quadratic[k] * std::abs(state_.velocity[k]) * time / inertia_[k];
}

/// Between the moorings' axes and the structure's, which has turned: sense -1 into its own, 1 out of them.
Vec3 MooredMotion::in_own_axes(const Vec3& plane, double sense) const {
    const Vec2 along = turned({plane[0], plane[1]}, sense * state_.offset[2]);
    return {along.x(), along.y(), plane[2]};
}

/// By the thrusters alone.
void MooredMotion::push_back(double time) {
    if (!has_thrusters()) return;
    const Vec3 offset = in_own_axes(state_.offset, -1);
    Vec3 velocity = in_own_axes(state_.velocity, -1);
    for (std::size_t k = 0; k < thrusters_.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        velocity[i] = velocity_under_thrust(thrusters_[k], offset[i], velocity[i], inertia_[i], time);
    }
    state_.velocity = in_own_axes(velocity, 1);
}

Vec3 MooredMotion::thrust() const {
    const Vec3 offset = in_own_axes(state_.offset, -1);
    const Vec3 velocity = in_own_axes(state_.velocity, -1);
    Vec3 found = Vec3::Zero();
    for (std::size_t k = 0; k < thrusters_.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        found[i] = floes::thrust(thrusters_[k], offset[i], velocity[i]);
    }
    return found;
}

/// What lines and turret pull more than the stiffness without an offset says.
void MooredMotion::pull_beyond_linear(double time) {
    if (moorings_.lines.empty() && moorings_.turret_curve.empty()) return;
    const Vec3 force = pull_of_lines(state_.offset) + (stiffness_ - springs_).cwiseProduct(state_.offset);
    for (int k = 0; k < moorings_.directions(); ++k) state_.velocity[k] += time * force[k] / inertia_[k];
}

void MooredMotion::advance(const Vec3& load, double time) {
    slow_down(0.5 * step_);
    push_back(0.5 * step_);
    pull_beyond_linear(0.5 * step_);
    for (std::size_t k = 0; k < linear_.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const OscillatorState after = linear_[k].after({state_.offset[i], state_.velocity[i]}, load[i]);
        state_.offset[i] = after.offset;
        state_.velocity[i] = after.velocity;
    }
    pull_beyond_linear(0.5 * step_);
    push_back(0.5 * step_);
    slow_down(0.5 * step_);
    break_lines(time);
}

void MooredMotion::break_lines(double time) {
    for (std::size_t i = 0; i < moorings_.lines.size(); ++i) {
        if (!std::isnan(state_.broken_at[i])) continue;
        const MooringLine& line = moorings_.lines[i];
        const double now = pull(moorings_, line, state_.offset).tension;
        largest_[i] = std::max(largest_[i], now);
        if (line.break_load > 0 && now > line.break_load) state_.broken_at[i] = time;
    }
}

std::optional<LinePull> MooredMotion::line(std::size_t number) const {
    if (!std::isnan(state_.broken_at[number])) return {};
    return pull(moorings_, moorings_.lines[number], state_.offset);
}

Vec3 MooredMotion::restoring() const {
    return pull_of_lines(state_.offset) - springs_.cwiseProduct(state_.offset);
}

}  // namespace floes
