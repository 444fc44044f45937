#include "simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "ice/scenario_world.hpp"
#include "simulation/field_water.hpp"

namespace floes {
namespace {

std::vector<ConvexSolid> solids_of(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    return scenario.contact.internal_edges ? shape.solids() : shape.overlapping_solids();
}

/// Of the structure in one step. More than the tank's ever are, and no bound: with more the memory grows.
constexpr std::size_t most_contacts = 1024;

}  // namespace

Simulation::Simulation(const Scenario& scenario, const FloeSet& floes, IceAhead ahead)
    : scenario_(scenario),
      channel_(make_channel(scenario, floes)),
      wellbeing_(scenario, channel_),
      motion_(scenario),
      hull_loads_(scenario.structure.shape, solids_of(scenario),
                  static_cast<std::size_t>(scenario.step_count() - scenario.first_window_step())),
      world_(scenario_world(scenario)),
      structure_(world_.add_structure(hull_loads_.solids(), {scenario.structure.start, 0, 0})),
      ice_(world_, scenario, floes),
      sheets_(world_, scenario, channel_),
      water_(make_water(scenario, floes, ice_)),
      piece_water_(scenario, floes),
      work_(scenario, floes, ice_, structure_),
      sleeping_(scenario.field.wake_radius, ice_.elements()),
      contact_bins_(scenario.structure.shape.bottom(), scenario.structure.shape.top()) {
    for (int floe = 0; floe < ice_.places(); ++floe) piece_water_.share_out(floe, ice_, world_, water_);
    const auto steps = static_cast<std::size_t>(scenario.step_count());
    for (const auto history : load_histories) (loads_.*history).reserve(steps);
    if (motion_.is_free())
        for (const auto history : motion_histories) (motions_.*history).reserve(steps);
    structure_contacts_.reserve(most_contacts);
    states_.resize(ice_.elements().size());
    states_before_.resize(states_.size());
    read_states();
    drift_with_current();
    sleeping_.lay_down(world_, states_, motion_.after());
    encounters_.enter(ice_.floes());
    if (ahead.next) start_window(floes, std::move(ahead));
    if (motion_.after().yaw != 0) place_structure();
}

/// Ice that lies still in the water moves with it.
void Simulation::drift_with_current() {
    const Vec2 current = scenario_.water.current_velocity();
    if (current.isZero(0)) return;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        states_[i].velocity = {current.x(), 0, current.y()};
        world_.place(ice_.elements()[i].body, states_[i]);
    }
}

Simulation::Simulation(const Scenario& scenario, const FloeSet& floes, const SimulationState& state)
    : Simulation(scenario, floes) {
    if (scenario.field.endless())
        throw InputError("A tow through a field without end begins at its start: a state does not hold all its floes.");
    if (state.elements.size() != states_.size()) {
        throw InputError(fmt::format("A state of {} elements cannot be that of {} floes with {} elements.",
                                     state.elements.size(), floes.size(), states_.size()));
    }
    const auto known = static_cast<std::size_t>(state.steps);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const auto history : load_histories) (loads_.*history).assign(known, unknown);
    if (motion_.is_free())
        for (const auto history : motion_histories) (motions_.*history).assign(known, unknown);
    steps_ = state.steps;
    sleeping_.wake_all(world_);
    motion_.place(steps_, state.moored);
    place_structure();
    for (std::size_t i = 0; i < states_.size(); ++i) world_.place(ice_.elements()[i].body, state.elements[i]);
    sheets_.place(world_, state.sheets);
    sheets_.read(world_, motion_.after(), time());
    ice_.repeat_breaks(world_, state.breaks);
    share_out_water(0);
    read_states();
    sleeping_.lay_down(world_, states_, motion_.after());
}

bool Simulation::run(const std::stop_token& stop, const Watcher& watch) {
    if (watch) watch(*this);
    while (steps_ < scenario_.step_count()) {
        if (stop.stop_requested()) return false;
        step();
        if (watch) watch(*this);
    }
    return true;
}

void Simulation::read_frame(Frame& frame) const {
    frame.step = steps_;
    frame.time = time();
    frame.structure = motion_.after();
    motion_.read_lines(frame.lines);
    frame.load = ice_load_;
    frame.elements = states_;
    const std::vector<IceElement>& elements = ice_.elements();
    frame.pieces.resize(elements.size());
    std::ranges::transform(elements, frame.pieces.begin(), &IceElement::piece);
    ice_.read_utilisation(world_, frame.utilisation);
    std::vector<ContactForce> contacts;
    world_.read_contacts(contacts);
    frame.contacts.clear();
    for (const ContactForce& one : contacts) frame.contacts.push_back(seen(one));
}

FrameContact Simulation::seen(const ContactForce& contact) const {
    const auto element = [&](BodyId body) {
        if (body == structure_) return touches_structure;
        const std::optional<std::size_t> index = ice_.element_of(body);
        return index ? static_cast<int>(*index) : touches_ice_sheet;
    };
    const int a = element(contact.a);
    const int b = element(contact.b);
    if (a >= 0) return {a, b, contact.point, contact.normal, contact.friction};
    return {b, a, contact.point, -contact.normal, -contact.friction};
}

void Simulation::step() {
    move_structure();
    move_window();
    wake_floes();
    apply_water();
    sheets_.press(world_);
    world_.step();
    sweeps_ += world_.sweeps();
    ++swept_steps_;
    if (work_.looks_at(steps_)) states_before_ = states_;
    read_states();
    sheets_.read(world_, motion_.after(), step_end());
    if (work_.looks_at(steps_)) work_.add(world_, ice_, sheets_, piece_water_, motion_, states_before_, states_);
    check_wellbeing();
    if (const auto& moored = motion_.moored())
        sheets_.check_fixed(motion_.after(), moored->state().offset.head<2>(), step_end());
    world_.read_contacts(structure_contacts_, structure_);
    read_ice_load();
    encounters_.meet(structure_contacts_, ice_);
    if (steps_ >= scenario_.first_window_step()) map_contacts();
    break_joints();
    record();
}

void Simulation::place_structure() {
    const PlanarPose& pose = motion_.after();
    world_.place(structure_, {.position = {pose.x, 0, pose.z},
                              .rotation = Eigen::AngleAxisd(pose.yaw, Vec3::UnitY()).toRotationMatrix(),
                              .velocity = motion_.velocity(),
                              .angular_velocity = {0, motion_.turning(), 0}});
}

void Simulation::move_structure() {
    motion_.advance({ice_load_.x(), ice_load_.z(), ice_moment_});
    const PlanarPose& pose = motion_.after();
    world_.move_structure({pose.x, 0, pose.z}, pose.yaw);
}

void Simulation::wake_floes() {
    sleeping_.wake(world_, motion_.before());
}

void Simulation::apply_water() {
    const std::vector<IceElement>& elements = ice_.elements();
    const std::vector<std::size_t>& awake = sleeping_.awake_elements();
    water_.clear();
    for (const std::size_t i : awake) {
        const BodyState& state = states_[i];
        water_.set(i,
                   {state.position, state.rotation, state.velocity, state.angular_velocity, elements[i].exposed_edges});
    }
    const PlanarPose& structure = motion_.before();
    if (motion_.is_free())
        water_.move_structure({structure.z, structure.yaw, {motion_.velocity().x(), motion_.velocity().z()}});
    if (work_.looks_at(steps_))
        work_.split_water(water_, structure.x);
    else
        water_.compute(structure.x);
    for (const std::size_t i : awake) world_.apply(elements[i].body, water_.wrench(i));
}

void Simulation::read_states() {
    for (const std::size_t i : sleeping_.awake_elements()) states_[i] = world_.state(ice_.elements()[i].body);
}

void Simulation::check_wellbeing() const {
    for (std::size_t i = 0; i < states_.size(); ++i) {
        const std::optional<std::string> trouble = wellbeing_.trouble(states_[i]);
        if (!trouble) continue;
        const IceElement& element = ice_.elements()[i];
        if (!ice_.is_there(element.floe)) continue;
        throw MemberFailure(fmt::format("Element {} of floe {} {} (t = {:.2f} s).", element.index,
                                        ice_.number_of(element.floe), *trouble, step_end()));
    }
}

void Simulation::break_joints() {
    const std::size_t before = ice_.breaks().size();
    if (ice_.break_joints(world_, step_end()) > 0) share_out_water(before);
}

void Simulation::share_out_water(std::size_t first_break) {
    const std::vector<BreakEvent>& breaks = ice_.breaks();
    for (std::size_t i = first_break; i < breaks.size(); ++i) {
        if (i == first_break || breaks[i].floe != breaks[i - 1].floe)
            piece_water_.share_out(ice_.place_of(breaks[i].floe), ice_, world_, water_);
    }
}

}  // namespace floes
