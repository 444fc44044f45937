// A Simulation from its start on: what each step leaves, how the field follows, and how all of it is saved.

#include "simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/state_archive.hpp"

namespace floes {

void Encounters::meet(std::span<const ContactForce> contacts, const IceField& ice) {
    if (met_.size() < static_cast<std::size_t>(ice.places())) met_.resize(static_cast<std::size_t>(ice.places()));
    for (const ContactForce& contact : contacts) {
        for (const BodyId body : {contact.a, contact.b}) {
            if (const auto element = ice.element_of(body))
                met_[static_cast<std::size_t>(ice.elements()[*element].floe)] = 1;
        }
    }
}

void Encounters::leave(int place, const IceField& ice) {
    if (!has_met(place)) return;
    ++left_met_;
    left_broken_ += ice.is_broken(place) ? 1 : 0;
    met_[static_cast<std::size_t>(place)] = 0;
}

bool Encounters::has_met(int place) const {
    return static_cast<std::size_t>(place) < met_.size() && met_[static_cast<std::size_t>(place)] != 0;
}

int Encounters::met(const IceField& ice) const {
    int found = left_met_;
    for (int place = 0; place < ice.places(); ++place) found += ice.is_there(place) && has_met(place) ? 1 : 0;
    return found;
}

int Encounters::met_broken(const IceField& ice) const {
    int found = left_broken_;
    for (int place = 0; place < ice.places(); ++place)
        found += ice.is_there(place) && has_met(place) && ice.is_broken(place) ? 1 : 0;
    return found;
}

namespace {

bool within(double value, double low, double high) {
    return value >= low && value <= high;
}  // false for NaN

}  // namespace

Wellbeing::Wellbeing(const Scenario& scenario, const Channel& channel)
    : speed(scenario.general.runaway_speed),
      begin(channel.begin - channel.room - channel.drift),
      end(channel.end + channel.room + channel.drift),
      outer_edge(channel.outer_edge + channel.drift),
      top(std::max(scenario.structure.shape.top(), 0.0) + channel.room),
      bottom(scenario.structure.shape.bottom() - channel.room) {}

std::optional<std::string> Wellbeing::trouble(const BodyState& state) const {
    const Vec3& at = state.position;
    if (!at.allFinite() || !state.rotation.allFinite() || !state.velocity.allFinite() ||
        !state.angular_velocity.allFinite()) {
        return "has a state that is not a number";
    }
    if (state.velocity.squaredNorm() > speed * speed) {
        return fmt::format("has run away: its speed is {:.4g} m/s, over runaway_speed = {:.4g} m/s",
                           state.velocity.norm(), speed);
    }
    if (!within(at.z(), -outer_edge, outer_edge)) {
        return fmt::format("is gone: it lies at z = {:.4g} m, beyond the outer edge of a wall sheet at {:.4g} m",
                           at.z(), std::copysign(outer_edge, at.z()));
    }
    if (!within(at.x(), begin, end)) {
        return fmt::format("is gone: it lies at x = {:.4g} m, outside the channel from {:.4g} to {:.4g} m", at.x(),
                           begin, end);
    }
    if (!within(at.y(), bottom, top)) {
        return fmt::format("is gone: it lies at height {:.4g} m, outside {:.4g} to {:.4g} m", at.y(), bottom, top);
    }
    return std::nullopt;
}

namespace {

std::vector<ConvexSolid> solids_of(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    return scenario.contact.internal_edges ? shape.solids() : shape.overlapping_solids();
}

/// As hull and water see it: the structure rests where level ice is pushed on it.
Scenario by_motion(Scenario scenario) {
    if (scenario.field.level_pushed) scenario.structure.speed = 0;
    return scenario;
}

/// The bed, if there is one, and after it the walls.
std::optional<BodyId> add_planes(World& world, const Scenario& scenario) {
    const Water& water = scenario.water;
    std::optional<BodyId> bed;
    if (water.has_bed())
        bed = world.add_plane({.point = {scenario.structure.start, -water.depth, 0},
                               .normal = {-std::sin(water.bed_slope), std::cos(water.bed_slope), 0},
                               .friction = water.bed_friction});
    for (const double side : {-1.0, 1.0})
        if (scenario.field.sides == FieldSides::wall)
            world.add_plane({.point = {0, 0, side * scenario.field.half_width}, .normal = {0, 0, -side}});
    return bed;
}

/// Contacts of the structure in one step. More than the tank's ever are, and no bound: with more the memory grows.
constexpr std::size_t most_contacts = 1024;

}  // namespace

Simulation::Simulation(const Scenario& scenario, const FloeSet& floes, IceAhead ahead)
    : scenario_(scenario),
      channel_(make_channel(scenario, floes)),
      wellbeing_(scenario, channel_),
      motion_(by_motion(scenario)),
      hull_loads_(scenario.structure.shape, solids_of(scenario),
                  static_cast<std::size_t>(scenario.step_count() - scenario.first_window_step())),
      world_(scenario_world(scenario)),
      structure_(world_.add_structure(hull_loads_.solids(), {.position = {scenario.structure.start, 0, 0}})),
      bed_(add_planes(world_, scenario)),
      ice_(world_, scenario, floes),
      sheets_(world_, scenario, channel_),
      water_(make_water(by_motion(scenario), floes, ice_)),
      piece_water_(scenario, floes, ice_),
      lee_(scenario, channel_, floes, ice_),
      work_(scenario, floes, ice_, structure_),
      nearby_(scenario, channel_),
      sleeping_(scenario.field.wake_radius, ice_.elements()),
      contact_bins_(scenario.structure.shape.bottom(), scenario.structure.shape.top()) {
    hold_edges(floes);
    piece_water_.share_out(ice_, world_, water_);
    const auto steps = static_cast<std::size_t>(scenario.step_count());
    for (const auto& history : load_histories) (loads_.*history.values).reserve(steps);
    if (motion_.is_free())
        for (const auto& history : motion_histories) (motions_.*history.values).reserve(steps);
    structure_contacts_.reserve(most_contacts);
    if (bed_) {
        for (const auto& history : bed_histories) (bed_loads_.*history.values).reserve(steps);
        bed_contacts_.reserve(most_contacts);
    }
    states_.resize(ice_.elements().size());
    states_before_.resize(states_.size());
    read_states();
    drift_from_start();
    sleeping_.lay_down(world_, states_, motion_.after());
    encounters_.enter(ice_.floes());
    if (ahead.next) start_window(floes, std::move(ahead));
    if (motion_.after().yaw != 0) place_structure();
}

/// Of level ice.
void Simulation::hold_edges(const FloeSet& floes) {
    const LevelHeld held = scenario_.field.level_held;
    if (!scenario_.arrangement.level() || held == LevelHeld::nowhere || scenario_.field.endless()) return;
    const SingleFloe sheet{floes.floes[0].pose, floes.shape(0), floes.material(0)};
    for (const auto& [body, form] : sheets_.fixed())
        if (form.inwards.x() != 0 || held == LevelHeld::far_end_and_sides)
            ice_.hold_edge(world_, sheet, 0, body, -form.inwards);
}

/// Ice that lies still in the water moves with it, and a sheet with what pushes it: at rest its edge would be struck.
void Simulation::drift_from_start() {
    const Vec2 current = scenario_.water.current_velocity();
    const bool pushed = scenario_.field.level_pushed && !scenario_.field.endless();  // there, ahead is pushed alone
    const Vec3 velocity(current.x() - (pushed ? scenario_.structure.speed : 0), 0, current.y());
    if (velocity.isZero(0)) return;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        states_[i].velocity = velocity;
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
    for (const auto& history : load_histories) (loads_.*history.values).assign(known, unknown);
    if (bed_)
        for (const auto& history : bed_histories) (bed_loads_.*history.values).assign(known, unknown);
    if (motion_.is_free())
        for (const auto& history : motion_histories) (motions_.*history.values).assign(known, unknown);
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
    frame.load = ice_load_.force;
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
        if (body == bed_) return touches_bed;
        const std::optional<std::size_t> index = ice_.element_of(body);
        return index ? static_cast<int>(*index) : touches_ice_sheet;
    };
    const int a = element(contact.a);
    const int b = element(contact.b);
    if (a >= 0) return {a, b, contact.point, contact.normal, contact.friction};
    return {b, a, contact.point, -contact.normal, -contact.friction};
}

void Simulation::step(const FromOutside& outside) {
    if (steps_ == scenario_.first_window_step()) astern_before_ = astern();
    move_structure(outside);
    push_resting();
    move_window();
    wake_floes();
    apply_water();
    sheets_.press(world_, time());
    world_.step();
    sweeps_ += world_.sweeps();
    ++swept_steps_;
    if (work_.looks_at(steps_)) states_before_ = states_;
    read_states();
    sheets_.read(world_, motion_.after(), step_end());
    if (work_.looks_at(steps_)) work_.add(world_, ice_, sheets_, piece_water_, motion_, states_before_, states_);
    check_wellbeing();
    if (motion_.gives_way()) sheets_.check_fixed(motion_.after(), motion_.offset().head<2>(), step_end());
    world_.read_contacts(structure_contacts_, structure_);
    read_ice_load();
    encounters_.meet(structure_contacts_, ice_);
    if (steps_ >= scenario_.first_window_step()) map_contacts();
    break_joints();
    nearby_.look(steps_, ice_, states_, sheets_.motions(), motion_.after());
    record();
}

IceAmount Simulation::astern() const {
    const IceAmount there = nearby_.astern(ice_, states_, motion_.after());
    return {left_.area + there.area, left_.floes + there.floes};
}

void Simulation::place_structure() {
    const Pose pose = motion_.after().pose();
    world_.place(structure_, {.position = pose.position,
                              .rotation = pose.orientation.toRotationMatrix(),
                              .velocity = motion_.velocity(),
                              .angular_velocity = motion_.angular_velocity()});
}

void Simulation::lead_hull(const Vec6& offset) {
    motion_.lead(offset);
    place_structure();
}

void Simulation::move_structure(const FromOutside& outside) {
    motion_.advance(ice_load_, outside);
    world_.move_structure(motion_.after().pose());
}

void Simulation::wake_floes() {
    const std::size_t before = sleeping_.awake_elements().size();
    sleeping_.wake(world_, motion_.before());
    if (sleeping_.awake_elements().size() != before) lee_.distrust();
}

void Simulation::apply_water() {
    const std::vector<IceElement>& elements = ice_.elements();
    const std::vector<std::size_t>& awake = sleeping_.awake_elements();
    lee_.follow(steps_, ice_, states_, sheets_.motions(), sleeping_);
    water_.clear();
    for (const std::size_t i : awake) {
        const BodyState& state = states_[i];
        water_.set(i, {state.position, state.rotation, state.velocity, state.angular_velocity,
                       elements[i].exposed_edges, lee_.of(i, ice_, states_)});
    }
    const Vec3& structure = motion_.before().position;
    if (motion_.is_free())
        water_.move_structure({structure.z(), motion_.before().yaw, {motion_.velocity().x(), motion_.velocity().z()}});
    if (work_.looks_at(steps_))
        work_.split_water(water_, structure.x());
    else
        water_.compute(structure.x());
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
    if (ice_.is_sheet()) piece_water_.share_out(ice_, world_, water_);
    for (std::size_t i = first_break; i < breaks.size(); ++i) {
        if (i != first_break && breaks[i].floe == breaks[i - 1].floe) continue;
        const int place = ice_.place_of(breaks[i].floe);
        if (!ice_.is_sheet()) piece_water_.share_out(place, ice_, world_, water_);
        lee_.look_from(place, ice_, states_);
    }
    if (ice_.is_sheet() && breaks.size() > first_break) lee_.distrust();  // an event names one of its two elements
}

void Simulation::read_ice_load() {
    ice_load_ = {world_.contact_force(structure_), Vec3::Zero()};
    for (const ContactForce& one : structure_contacts_) {
        const Vec3 force = (one.a == structure_ ? 1.0 : -1.0) * (one.normal + one.friction);
        ice_load_.moment += (one.point - motion_.after().position).cross(force);
    }
    if (!ice_load_.force.allFinite() || !ice_load_.moment.allFinite()) {
        throw MemberFailure(fmt::format("The load on the structure is not a number (t = {:.2f} s).", step_end()));
    }
}

void Simulation::map_contacts() {
    const StructurePose& pose = motion_.after();  // where contacts were looked for
    for (const ContactForce& one : structure_contacts_) {
        const Vec3 arm = pose.in_own_axes(one.point - pose.position);
        const double surge = -pose.in_own_axes(one.normal + one.friction).x();  // of a; on b the opposite
        contact_bins_.add(arm.x(), arm.y(), arm.z(), one.a == structure_ ? surge : -surge, one.normal.norm());
    }
    hull_loads_.add(structure_contacts_, structure_, pose, ice_load_.moment);
    ++steps_in_window_;
}

void Simulation::record() {
    const Vec3 load = motion_.after().in_own_axes(ice_load_.force);
    loads_.surge.push_back(-load.x());
    loads_.sway.push_back(load.z());
    loads_.heave.push_back(load.y());
    loads_.concentration.push_back(nearby_.concentration());
    loads_.pile_height.push_back(nearby_.height());
    loads_.pile_draught.push_back(nearby_.draught());
    if (bed_) record_bed();
    if (motion_.is_free()) record_motion();
    ++steps_;
}

void Simulation::record_bed() {
    world_.read_contacts(bed_contacts_, *bed_);
    const Vec3 force = world_.contact_force(*bed_);
    double grounded = 0;
    std::optional<std::size_t> last;  // points of an element follow each other
    for (const ContactForce& one : bed_contacts_) {
        const std::optional<std::size_t> element = ice_.element_of(one.a == *bed_ ? one.b : one.a);
        if (element && element != last) grounded += ice_.cut_element(ice_.elements()[*element]).area;
        last = element;
    }
    bed_loads_.surge.push_back(-force.x());
    bed_loads_.weight.push_back(-force.y());
    bed_loads_.grounded.push_back(grounded);
}

void Simulation::record_motion() {
    const StructurePose& pose = motion_.after();
    motions_.x.push_back(pose.position.x());
    motions_.z.push_back(pose.position.z());
    motions_.yaw.push_back(pose.yaw);
    motions_.yaw_load.push_back(ice_load_.moment.y());
    if (!motion_.moored()) return;
    const Vec6& offset = motion_.moored()->state().offset;
    const Vec3 restoring = motion_.moored()->restoring();
    motions_.surge_offset.push_back(-offset[0]);
    motions_.sway_offset.push_back(offset[1]);
    motions_.surge_mooring.push_back(restoring[0]);
    motions_.sway_mooring.push_back(-restoring[1]);
    motions_.yaw_mooring.push_back(-restoring[2]);
    if (motion_.moored()->breaks()) motions_.line_use.push_back(motion_.moored()->line_use());
    if (motion_.moored()->floats()) {
        motions_.heave.push_back(pose.position.y());
        motions_.pitch.push_back(pose.pitch);
        motions_.roll.push_back(pose.roll);
    }
    if (!motion_.moored()->has_thrusters()) return;
    const Vec3 thrust = motion_.moored()->thrust();
    motions_.surge_thrust.push_back(thrust[0]);
    motions_.sway_thrust.push_back(-thrust[1]);
    motions_.yaw_thrust.push_back(-thrust[2]);
}

// How a Simulation follows a field without end: floes come, wake and leave.

void Simulation::start_window(const FloeSet& floes, IceAhead ahead) {
    if (!ahead.joints.empty())
        ice_.join(world_, {floes.floes[0].pose, floes.shape(0), floes.material(0)}, ahead.joints);
    window_.emplace(scenario_, floes, std::move(ahead));
    for (int place = 0; place < ice_.places(); ++place) {
        ice_.set_resting(place, true);
        sleeping_.rest(world_, ice_, place, states_);
        if (scenario_.field.level_pushed) push(place);
    }
    encounters_.enter(-ice_.floes());
    move_window();
}

void Simulation::move_window() {
    if (!window_) return;
    if (!window_->moves_to(motion_.before().position.x() + pushed())) return check_way_back();
    leave_behind();
    bool came = false;
    while (enter_ahead()) came = true;
    if (came) {
        measure_places();
        piece_water_.share_out(ice_, world_, water_);
    }
    lee_.distrust();
    for (int place = 0; place < ice_.places(); ++place) {
        if (!ice_.is_there(place) || !sleeping_.rests(place) || sleeping_.middle_x(place) > window_->last()) continue;
        sleeping_.rouse(world_, place);
        ice_.set_resting(place, false);
        encounters_.enter(1);
    }
    sleeping_.list_awake();
    if (ice_.is_sheet()) piece_water_.share_out(ice_, world_, water_);
}

/// How far level ice that is pushed on the structure has come by itself, m along -x.
double Simulation::pushed() const {
    return scenario_.field.level_pushed ? scenario_.structure.speed * time() : 0;
}

/// Ice at rest ahead is what pushes.
void Simulation::push_resting() {
    if (!window_ || !scenario_.field.level_pushed) return;
    for (int place = 0; place < ice_.places(); ++place)
        if (ice_.is_there(place) && sleeping_.rests(place)) push(place);
}

void Simulation::push(int place) {
    const auto element = static_cast<std::size_t>(ice_.first_element(place));
    BodyState& state = states_[element];
    state.position.x() = sleeping_.middle_x(place) - pushed();
    state.velocity.x() = -scenario_.structure.speed;
    world_.place(ice_.elements()[element].body, state);
}

/// Only moorings, or who leads it, let a structure come so far back: of the other ways scenario/checks_field.cpp has
/// seen the whole.
void Simulation::check_way_back() const {
    const double x = motion_.before().position.x() + pushed();
    if (!window_->has_left(x)) return;
    throw MemberFailure(
        fmt::format("The structure has come back to x = {:.4g} m (t = {:.2f} s), and floes behind x = {:.4g} m "
                    "are gone from the field without end; take a larger field.behind_m or moorings that hold it.",
                    x, time(), window_->first()));
}

/// What stays in the places of floes that leave does not move.
void Simulation::leave_behind() {
    const std::vector<int> places = ice_.behind(states_, window_->first() - pushed());
    for (const int place : places) {
        encounters_.leave(place, ice_);
        for (const CutElement& one : ice_.cut(place).elements) left_.area += one.area;
        ++left_.floes;
        sleeping_.leave(place);
        for (const std::size_t i : ice_.indices(place))
            states_[i].velocity = states_[i].angular_velocity = Vec3::Zero();
    }
    ice_.leave(world_, places);
}

/// A part that finds no room ends the run, not the campaign; of the first ones the campaign hears at once.
FieldPart Simulation::next_part() {
    try {
        return window_->next_part();
    } catch (const InputError& error) {
        if (steps_ == 0) throw;
        throw MemberFailure(fmt::format("The field cannot be laid on from x = {:.4g} m (t = {:.2f} s): {}.",
                                        window_->last(), time(), error.what()));
    }
}

bool Simulation::enter_ahead() {
    const FieldPart part = next_part();
    std::vector<SingleFloe>& places = window_->places();
    for (const SingleFloe& floe : part.floes) {
        const int place = ice_.enter(world_, scenario_, floe);
        places.resize(static_cast<std::size_t>(ice_.places()));
        places[static_cast<std::size_t>(place)] = floe;
        states_.resize(ice_.elements().size());
        for (const std::size_t i : ice_.indices(place)) states_[i] = world_.state(ice_.elements()[i].body);
        ice_.set_resting(place, true);
        sleeping_.rest(world_, ice_, place, states_);
        if (scenario_.field.level_pushed) push(place);
    }
    if (!part.joints.empty()) ice_.join(world_, part.floes.front(), part.joints);
    return !part.floes.empty();
}

/// All that is kept by element, for the floes that are there now.
void Simulation::measure_places() {
    const FloeSet floes = gathered(window_->places());
    states_before_.resize(states_.size());
    water_ = make_water(by_motion(scenario_), floes, ice_);
    piece_water_ = PieceWater(scenario_, floes, ice_);
    lee_.measure(floes, ice_);
    work_.measure(floes, ice_);
}

// How a Simulation is saved, and set again.

void Encounters::archive(StateArchive& state) {
    auto& [entered, left_met, left_broken, met] = *this;
    state(entered, left_met, left_broken, met);
}

void Simulation::archive(StateArchive& state) {
    auto& [scenario, channel, wellbeing, motion, hull_loads, world, structure, bed, ice, sheets, water, piece_water,
           lee, work, nearby, left, astern_before, states, states_before, sleeping, window, encounters, ice_load, loads,
           bed_loads, motions, structure_contacts, bed_contacts, contact_bins, steps_in_window, sweeps, swept_steps,
           steps] = *this;
    state.same(window.has_value());
    if (!window) state.same(states.size());
    state(states, world, ice);
    if (window) {
        window->archive(state, ice);
        if (state.sets()) measure_places();
    }
    state(motion, hull_loads, sheets, water, piece_water, lee, work, nearby, left, astern_before, sleeping, encounters,
          ice_load, loads, bed_loads, motions, contact_bins, steps_in_window, sweeps, swept_steps, steps);
    state.list(structure_contacts, ContactForce{BodyId(0), BodyId(0)});
}

Bytes Simulation::saved() const {
    StateArchive state;
    const_cast<Simulation*>(this)->archive(state);  // which changes nothing where it does not set
    return state.take();
}

void Simulation::set(std::span<const std::byte> saved) {
    StateArchive state(saved);
    archive(state);
    state.end();
}

}  // namespace floes
