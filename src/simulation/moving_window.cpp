#include "simulation/moving_window.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/state_archive.hpp"

namespace floes {

constexpr double floes_in_reserve = 3;  // side by side: what is pushed cannot pass them

MovingWindow::MovingWindow(const Scenario& scenario, const FloeSet& floes, IceAhead ahead)
    : ahead_(scenario.window_ahead()),
      behind_(scenario.window_behind()),
      stride_(scenario.arrangement.level() ? 2 * scenario.floe.element : largest_side(floes) / 4),
      least_(window_least(scenario)),
      reserve_(floes_in_reserve * largest_side(floes)),
      at_(-std::numeric_limits<double>::infinity()),
      ice_(std::move(ahead)) {
    for (std::size_t i = 0; i < floes.size(); ++i)
        places_.push_back({floes.floes[i].pose, floes.shape(i), floes.material(i)});
}

bool MovingWindow::moves_to(double structure_x) {
    const double at = std::max(at_, stride_ * std::floor(structure_x / stride_));
    return std::exchange(at_, at) != at;
}

FieldPart MovingWindow::next_part() {
    if (ice_.end > last() + reserve_) return {};
    FieldPart part = ice_.next();
    ice_.end = part.end;
    return part;
}

SleepingFloes::SleepingFloes(double wake_radius, const std::vector<IceElement>& elements) : wake_radius_(wake_radius) {
    for (std::size_t i = 0; i < elements.size(); ++i) add(i, elements[i]);
    list_awake();
}

void SleepingFloes::add(std::size_t element, const IceElement& of) {
    const auto floe = static_cast<std::size_t>(of.floe);
    floes_.resize(std::max(floes_.size(), floe + 1));
    floes_[floe].indices.push_back(element);
    const std::size_t body = of.body.index();
    floe_of_body_.resize(std::max(floe_of_body_.size(), body + 1));
    floe_of_body_[body] = floe;
    body_.push_back(of.body);
}

void SleepingFloes::rest(World& world, const IceField& ice, int place, std::span<const BodyState> states) {
    for (std::size_t i = body_.size(); i < ice.elements().size(); ++i) add(i, ice.elements()[i]);
    FloeElements& floe = floes_[static_cast<std::size_t>(place)];
    floe.there = true;
    floe.middle = middle_of(floe, states);
    set_asleep(world, floe, true);
}

void SleepingFloes::lay_down(World& world, std::span<const BodyState> states, const StructurePose& structure) {
    if (wake_radius_ == 0) return;
    for (FloeElements& floe : floes_) {
        floe.middle = middle_of(floe, states);
        const bool at_rest = std::ranges::all_of(floe.indices, [&](std::size_t i) {
            return states[i].velocity.isZero(0) && states[i].angular_velocity.isZero(0);
        });
        if (at_rest && !reached(floe, structure)) set_asleep(world, floe, true);
    }
    list_awake();
}

void SleepingFloes::wake(World& world, const StructurePose& structure) {
    if (wake_radius_ == 0 || sleepers_ == 0) return;  // a field without end has sleepers that nothing wakes but rouse()
    const std::size_t before = sleepers_;
    for (const BodyId body : world.touched_asleep()) set_asleep(world, floes_[floe_of_body_[body.index()]], false);
    for (FloeElements& floe : floes_) {
        if (floe.asleep && reached(floe, structure)) set_asleep(world, floe, false);
    }
    if (sleepers_ != before) list_awake();
}

void SleepingFloes::wake_all(World& world) {
    for (FloeElements& floe : floes_) set_asleep(world, floe, false);
    list_awake();
}

Vec3 SleepingFloes::middle_of(const FloeElements& floe, std::span<const BodyState> states) {
    Vec3 middle = Vec3::Zero();
    for (const std::size_t i : floe.indices) middle += states[i].position / static_cast<double>(floe.indices.size());
    return middle;
}

bool SleepingFloes::reached(const FloeElements& floe, const StructurePose& structure) const {
    const double x = floe.middle.x() - structure.position.x();
    const double z = floe.middle.z() - structure.position.z();
    return x * x + z * z <= wake_radius_ * wake_radius_;
}

void SleepingFloes::set_asleep(World& world, FloeElements& floe, bool asleep) {
    if (floe.asleep == asleep) return;
    floe.asleep = asleep;
    sleepers_ += asleep ? std::size_t{1} : static_cast<std::size_t>(-1);
    for (const std::size_t i : floe.indices) world.set_asleep(body_[i], asleep);
}

void SleepingFloes::list_awake() {
    awake_elements_.clear();
    std::size_t most = 0;
    for (const FloeElements& floe : floes_) most = std::max(most, floe.indices.size());
    for (std::size_t place = 0; place < most; ++place) {
        for (const FloeElements& floe : floes_) {
            if (floe.there && !floe.asleep && place < floe.indices.size())
                awake_elements_.push_back(floe.indices[place]);
        }
    }
}

void MovingWindow::archive(StateArchive& state, IceField& ice) {
    auto& [ahead, behind, stride, least, reserve, at, source, places] = *this;
    state(at);
    if (state.sets()) lay_again(ice);
}

/// Floes enter in the order in which they are laid, and so far all that are laid have entered.
void MovingWindow::lay_again(IceField& ice) {
    std::vector<SingleFloe> entered = std::move(places_);
    while (entered.size() < static_cast<std::size_t>(ice.floes())) {
        FieldPart part = ice_.next();
        ice_.end = part.end;
        std::ranges::move(part.floes, std::back_inserter(entered));
    }
    places_.clear();
    for (int place = 0; place < ice.places(); ++place) {
        places_.push_back(entered.at(static_cast<std::size_t>(ice.number_of(place))));
        ice.set_floe(place, places_.back());
    }
}

void SleepingFloes::archive(StateArchive& state) {
    auto& [wake_radius, body, floes, floe_of_body, sleepers, awake_elements] = *this;
    state.list(body, BodyId(0));
    state(floes, floe_of_body, sleepers, awake_elements);
}

}  // namespace floes
