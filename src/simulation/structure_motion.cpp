#include "simulation/structure_motion.hpp"

#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/state_archive.hpp"
#include "core/units.hpp"

namespace floes {

StructureMotion::StructureMotion(const Scenario& scenario)
    : time_step_(scenario.general.time_step),
      tow_{scenario.structure.start, scenario.structure.speed},
      straight_(scenario.towed_straight()),
      places_(scenario.places()) {
    if (scenario.moorings.give_way()) moored_.emplace(scenario.moorings, scenario.water_stiffness(), time_step_);
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
    velocity_ = towed_ = {place.velocity.x(), 0, place.velocity.y()};
    angular_velocity_ = towed_turning_ = {0, place.turning, 0};
    pace_ = place.velocity.norm();
}

/// To the place that it has by tow or path alone.
void StructureMotion::add(const Vec6& offset) {
    after_.position += Vec3(offset[at(Motion::surge)], offset[at(Motion::heave)], offset[at(Motion::sway)]);
    after_.yaw += offset[at(Motion::yaw)];
    after_.pitch = offset[at(Motion::pitch)];
    after_.roll = offset[at(Motion::roll)];
}

/// A load in the world's axes: pitch and roll are about the structure's own.
Vec6 StructureMotion::on_motions(const Wrench& load) const {
    const Vec3 own = turned_about_y(before_.yaw).conjugate() * load.moment;
    Vec6 found;
    found << load.force.x(), load.force.z(), load.moment.y(), load.force.y(), own.z(), own.x();
    return found;
}

void StructureMotion::place(int steps, const MooredState& moored) {
    step_ = steps;
    follow(prescribed(steps));
    if (moored_) {
        moored_->place(moored);
        add(moored_->state().offset);
    }
    before_ = after_;
}

void StructureMotion::lead(const Vec6& offset) {
    FLOES_EXPECTS(!moored_ && step_ == 0);
    led_ = true;
    led_offset_ = offset;
    follow(prescribed(0));
    add(offset);
    before_ = after_;
}

void StructureMotion::advance(const Wrench& ice, const FromOutside& outside) {
    before_ = after_;
    follow(prescribed(++step_));
    if (!gives_way()) return;
    const Vec6 from = offset();
    if (moored_)
        moored_->advance(on_motions({ice.force + outside.load.force, ice.moment + outside.load.moment}),
                         step_ * time_step_);
    else
        led_offset_ = outside.offset;
    add(offset());
    const Vec6 moved = (offset() - from) / time_step_;
    velocity_ += Vec3(moved[at(Motion::surge)], moved[at(Motion::heave)], moved[at(Motion::sway)]);
    angular_velocity_.y() += moved[at(Motion::yaw)];
    if (moored_ && !moored_->floats()) return;
    const Quat flat = turned_about_y(after_.yaw);
    const Vec3 pitched(std::cos(after_.pitch), std::sin(after_.pitch), 0);
    angular_velocity_ += flat * Vec3(moved[at(Motion::roll)] * pitched + moved[at(Motion::pitch)] * Vec3::UnitZ());
}

void StructureMotion::read_lines(std::vector<FrameLine>& lines) const {
    lines.clear();
    if (!moored_) return;
    const Vec6& offset = moored_->state().offset;
    const Vec3 place(after_.position.x() - offset[0], 0, after_.position.z() - offset[1]);
    for (std::size_t i = 0; i < moored_->lines(); ++i) {
        const std::optional<LinePull> pulls = moored_->line(i);
        if (!pulls) continue;
        lines.push_back({static_cast<int>(i), place + pulls->fairlead, place + pulls->anchor, pulls->tension});
    }
}

LinearMotion::LinearMotion(std::vector<int> directions, const Mat6& inertia, const Mat6& damping, const Mat6& stiffness,
                           double critical, double step)
    : directions_(std::move(directions)), inertia_(inertia(directions_, directions_)), inverse_(inertia_.inverse()) {
    const int first = directions_.front();
    const auto n = static_cast<Eigen::Index>(directions_.size());
    if (n == 1 && damping(first, first) == 0 && stiffness(first, first) >= 0) {  // thrusters may hold what turns over
        alone_.emplace(Oscillator{stiffness(first, first), inertia(first, first), critical}, step);
        return;
    }
    Matrix loss = damping(directions_, directions_);
    for (Eigen::Index k = 0; k < n; ++k) {
        const int own = directions_[static_cast<std::size_t>(k)];
        loss(k, k) += 2 * critical * std::sqrt(std::max(0.0, stiffness(own, own)) * inertia(own, own));
    }
    Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    rate.block(0, n, n, n).setIdentity();
    rate.block(n, 0, n, n) = -inverse_ * stiffness(directions_, directions_);
    rate.block(n, n, n, n) = -inverse_ * loss;
    rate.block(n, 2 * n, n, n) = inverse_;
    const Eigen::MatrixXd all = (step * rate).exp();
    step_ = all.topRows(2 * n);
}

void LinearMotion::advance(MooredState& state, const Vec6& load) const {
    if (alone_) {
        const int k = directions_.front();
        const OscillatorState after = alone_->after({state.offset[k], state.velocity[k]}, load[k]);
        state.offset[k] = after.offset;
        state.velocity[k] = after.velocity;
        return;
    }
    const auto n = static_cast<Eigen::Index>(directions_.size());
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 18, 1> before(3 * n);
    before << state.offset(directions_), state.velocity(directions_), load(directions_);
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 18, 1> after = step_ * before;
    state.offset(directions_) = after.head(n);
    state.velocity(directions_) = after.tail(n);
}

double LinearMotion::acceleration(Motion motion, const Vec6& force) const {
    const auto own = std::ranges::find(directions_, static_cast<int>(motion));
    if (own == directions_.end()) return 0;
    const auto row = own - directions_.begin();
    double sum = 0;
    for (std::size_t b = 0; b < directions_.size(); ++b)
        sum += inverse_(row, static_cast<Eigen::Index>(b)) * force[directions_[b]];
    return sum;
}

void LinearMotion::accelerate(MooredState& state, const Vec6& force, double time) const {
    if (alone_) {
        const int k = directions_.front();
        state.velocity[k] += time * force[k] / inertia_(0, 0);
        return;
    }
    for (std::size_t a = 0; a < directions_.size(); ++a)
        for (std::size_t b = 0; b < directions_.size(); ++b)
            state.velocity[directions_[a]] +=
                time * inverse_(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) * force[directions_[b]];
}

/// Of one direction v / (1 + b |v| t / m); of several (M + t b |v|) v' = M v, which never adds energy.
void LinearMotion::slow_down(MooredState& state, const std::array<double, 6>& quadratic, double time) const {
    const auto drag = [&](int k) { return quadratic.at(static_cast<std::size_t>(k)) * std::abs(state.velocity[k]); };
    if (alone_) {
        const int k = directions_.front();
        state.velocity[k] /= 1 + drag(k) * time / inertia_(0, 0);
        return;
    }
    if (std::ranges::all_of(directions_, [&](int k) { return drag(k) == 0; })) return;
    using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
    using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
    const Column momentum = inertia_ * Column(state.velocity(directions_));
    Small slowed = inertia_;
    for (std::size_t a = 0; a < directions_.size(); ++a)
        slowed(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(a)) += time * drag(directions_[a]);
    const Column after = slowed.partialPivLu().solve(momentum);
    state.velocity(directions_) = after;
}

namespace {

/// Directions in groups that no matrix couples with each other, by the first of each.
std::vector<std::vector<int>> coupled(const std::vector<int>& directions, std::initializer_list<Mat6> matrices) {
    Components groups(6);
    for (const int a : directions)
        for (const int b : directions)
            for (const Mat6& matrix : matrices)
                if (matrix(a, b) != 0) groups.connect(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    std::vector<std::vector<int>> found;
    for (const int a : directions) {
        const auto same = std::ranges::find_if(found, [&](const std::vector<int>& group) {
            return groups.first(static_cast<std::size_t>(group.front())) == groups.first(static_cast<std::size_t>(a));
        });
        if (same == found.end())
            found.push_back({a});
        else
            same->push_back(a);
    }
    return found;
}

/// A matrix of the hull's own axes in those of its moorings, from which it has yawed by `heading`, rad.
Mat6 turned_by(const Mat6& own, double heading) {
    const Vec2 ahead = turned({1, 0}, heading);
    const Vec2 aside = turned({0, 1}, heading);
    Mat6 turn = Mat6::Identity();
    turn.topLeftCorner<2, 2>() << ahead.x(), aside.x(), ahead.y(), aside.y();
    return turn * own * turn.transpose();
}

/// Whether a matrix is the same at all headings.
bool is_round(const Mat6& own) {
    return turned_by(own, 1.0).isApprox(own, 1e-12);
}

/// What is solved without error: of a hull that turns about a turret its springs alone, since where its lines would
/// have the axis depends on the heading.
Mat6 linear_stiffness(const Moorings& moorings) {
    if (!moorings.turret.any()) return moorings.stiffness();
    return in_plane({moorings.surge, moorings.sway, moorings.yaw}).asDiagonal();
}

/// What a force of 1 N, or a moment of 1 N m, along a motion accelerates it by, 1/kg or 1/(kg m²); 0 where it is held.
double response(const std::vector<LinearMotion>& motions, Motion along) {
    double sum = 0;
    for (const LinearMotion& one : motions) sum += one.acceleration(along, Vec6::Unit(static_cast<int>(along)));
    return sum;
}

}  // namespace

MooredMotion::MooredMotion(const Moorings& moorings, const Mat6& water, double step)
    : moorings_(moorings),
      step_(step),
      springs_(moorings.surge, moorings.sway, moorings.yaw),
      water_(water),
      stiffness_(linear_stiffness(moorings)),
      round_(is_round(moorings.inertia()) && is_round(moorings.radiation())),
      breaks_(has_lines_that_break(moorings)) {
    linear_.emplace(0, linear_at(0));
    for (int k = 0; k < 3; ++k) {
        const bool free = moorings.free.at(static_cast<std::size_t>(k));
        const double own = moorings.inertia()(k, k);
        thrusters_.push_back(free ? thrust_law(moorings.thrusters, k, own) : ThrustLaw{});
        inertia_[k] = free ? 1 / response(linear_.at(0), static_cast<Motion>(k)) : own;
    }
    state_.broken_at.assign(lines(), std::numeric_limits<double>::quiet_NaN());
    pulls_.resize(lines());
    look_at_lines();
    for (const LinePull& at_rest : pulls_) {
        largest_.push_back(at_rest.tension);
        Vec6& level = level_.emplace_back(at_rest.force);
        level.head<3>().setZero();
    }
}

std::vector<LinearMotion> MooredMotion::linear_at(double heading) const {
    const Mat6 inertia = turned_by(moorings_.inertia(), heading);
    Mat6 damping = turned_by(moorings_.radiation(), heading);
    const Mat6 stiffness = water_ + stiffness_;
    double critical = moorings_.damping;
    if (moorings_.turret.any()) {  // of what holds it, lines too; nothing holds its heading
        const Mat6 held = water_ + moorings_.stiffness();
        for (int k = 0; k < 6; ++k)
            if (k != static_cast<int>(Motion::yaw))
                damping(k, k) += 2 * critical * std::sqrt(std::max(0.0, held(k, k)) * inertia(k, k));
        critical = 0;
    }
    std::vector<LinearMotion> found;
    for (const std::vector<int>& group : coupled(moorings_.directions(), {inertia, damping, stiffness}))
        found.emplace_back(group, inertia, damping, stiffness, critical, step_);
    return found;
}

/// Of the heading now: made once, since a hull comes to few headings.
const std::vector<LinearMotion>& MooredMotion::at_this_heading() {
    if (round_) return linear_.at(0);
    const auto degrees = static_cast<int>(std::lround(state_.offset[at(Motion::yaw)] / unit::degree)) % 360;
    auto known = linear_.find(degrees);
    if (known == linear_.end()) known = linear_.emplace(degrees, linear_at(degrees * unit::degree)).first;
    return known->second;
}

/// By the quadratic damping alone, along the hull's own axes.
void MooredMotion::slow_down(double time) {
    if (std::ranges::all_of(moorings_.quadratic, [](double by_speed) { return by_speed == 0; })) return;
    state_.velocity.head<3>() = in_own_axes(state_.velocity.head<3>(), -1);
    for (const LinearMotion& one : linear_.at(0)) one.slow_down(state_, moorings_.quadratic, time);
    state_.velocity.head<3>() = in_own_axes(state_.velocity.head<3>(), 1);
    hold();
}

/// Of the turret's bearing over the step that lines have begun: what stops the yaw by its end, as far as it can.
Vec6 MooredMotion::friction(const Vec6& load) {
    const double most = moorings_.turret.friction;
    if (!(most > 0)) return Vec6::Zero();
    double velocity = state_.velocity[at(Motion::yaw)];
    for (const LinearMotion& one : at_this_heading())
        velocity += step_ * one.acceleration(Motion::yaw, load + 0.5 * beyond_);
    const double by_moment = response(at_this_heading(), Motion::yaw);
    return by_moment > 0 ? in_plane({0, 0, std::clamp(-velocity / (by_moment * step_), -most, most)}) : Vec6::Zero();
}

void MooredMotion::place(const MooredState& state) {
    const std::size_t lines = state_.broken_at.size();
    state_ = state;
    state_.broken_at.resize(lines, std::numeric_limits<double>::quiet_NaN());
    look_at_lines();
}

void MooredMotion::look_at_lines() {
    for (std::size_t i = 0; i < pulls_.size(); ++i) pulls_[i] = pull(moorings_, i, state_.offset);
}

Vec6 MooredMotion::pull_of_lines() const {
    Vec6 sum = turret_pull(moorings_, state_.offset);
    for (std::size_t i = 0; i < pulls_.size(); ++i)
        sum += std::isnan(state_.broken_at[i]) ? Vec6(pulls_[i].force - level_[i]) : Vec6(-level_[i]);
    return sum;
}

/// Between the moorings' axes and the structure's, which has turned: sense -1 into its own, 1 out of them.
Vec3 MooredMotion::in_own_axes(const Vec3& plane, double sense) const {
    const Vec2 along = turned({plane[0], plane[1]}, sense * state_.offset[2]);
    return {along.x(), along.y(), plane[2]};
}

/// By the thrusters alone.
void MooredMotion::push_back(double time) {
    if (!has_thrusters()) return;
    const Vec3 offset = in_own_axes(state_.offset.head<3>(), -1);
    const Vec3 velocity = in_own_axes(state_.velocity.head<3>(), -1);
    Vec3 force = Vec3::Zero();
    for (std::size_t k = 0; k < thrusters_.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const double pushed = velocity_under_thrust(thrusters_[k], offset[i], velocity[i], inertia_[i], time);
        if (moorings_.free.at(k)) force[i] = (pushed - velocity[i]) * inertia_[i] / time;
    }
    const Vec6 along = in_plane(in_own_axes(force, 1));
    for (const LinearMotion& one : at_this_heading()) one.accelerate(state_, along, time);
}

/// Where it is held it has no velocity.
void MooredMotion::hold() {
    for (int k = 0; k < 3; ++k)
        if (!moorings_.free.at(static_cast<std::size_t>(k))) state_.velocity[k] = 0;
}

Vec3 MooredMotion::thrust() const {
    const Vec3 offset = in_own_axes(state_.offset.head<3>(), -1);
    const Vec3 velocity = in_own_axes(state_.velocity.head<3>(), -1);
    Vec3 found = Vec3::Zero();
    for (std::size_t k = 0; k < thrusters_.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        found[i] = floes::thrust(thrusters_[k], offset[i], velocity[i]);
    }
    return found;
}

/// What lines and turret pull more than the stiffness without an offset says.
void MooredMotion::pull_beyond_linear(double time) {
    if (pulls_.empty() && moorings_.turret.curve.empty()) return;
    Mat6 linear = stiffness_;
    linear.diagonal().head<3>() -= springs_;
    beyond_ = pull_of_lines() + linear * state_.offset;
    for (const LinearMotion& one : at_this_heading()) one.accelerate(state_, beyond_, time);
}

void MooredMotion::advance(const Vec6& load, double time) {
    const double half = 0.5 * step_;
    slow_down(half);
    push_back(half);
    pull_beyond_linear(half);
    const Vec6 rubbed = load + friction(load);
    for (const LinearMotion& one : at_this_heading()) one.advance(state_, rubbed);
    look_at_lines();
    pull_beyond_linear(half);
    push_back(half);
    slow_down(half);
    break_lines(time);
}

void MooredMotion::break_lines(double time) {
    line_use_ = 0;
    for (std::size_t i = 0; i < pulls_.size(); ++i) {
        if (!std::isnan(state_.broken_at[i])) continue;
        const double now = pulls_[i].tension;
        largest_[i] = std::max(largest_[i], now);
        const double most = break_load(moorings_, i);
        if (most <= 0) continue;
        line_use_ = std::max(line_use_, now / most);
        if (now > most) state_.broken_at[i] = time;
    }
}

std::optional<LinePull> MooredMotion::line(std::size_t number) const {
    if (!std::isnan(state_.broken_at[number])) return {};
    return pulls_[number];
}

void MooredMotion::archive(StateArchive& state) {
    auto& [moorings, step, inertia, springs, water, stiffness, round, linear, thrusters, moved, beyond, pulls, level,
           largest, breaks, line_use] = *this;
    state(moved, beyond, pulls, largest, line_use);
}

void StructureMotion::archive(StateArchive& state) {
    auto& [time_step, tow, straight, places, moored, led, led_offset, step, before, after, velocity, angular_velocity,
           towed, towed_turning, pace] = *this;
    if (moored) moored->archive(state);
    state(led_offset, step, before, after, velocity, angular_velocity, towed, towed_turning, pace);
}

}  // namespace floes
