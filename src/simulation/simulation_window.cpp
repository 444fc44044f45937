// How a Simulation follows a field without end: floes come, wake and leave.

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "simulation/field_water.hpp"
#include "simulation/simulation.hpp"

namespace floes {

void Simulation::start_window(const FloeSet& floes, IceAhead ahead) {
    window_.emplace(scenario_, floes, std::move(ahead));
    for (int place = 0; place < ice_.places(); ++place) {
        ice_.set_resting(place, true);
        sleeping_.rest(world_, ice_, place, states_);
    }
    encounters_.enter(-ice_.floes());
    move_window();
}

void Simulation::move_window() {
    if (!window_) return;
    if (!window_->moves_to(motion_.before().x)) return check_way_back();
    leave_behind();
    bool came = false;
    while (enter_ahead()) came = true;
    if (came) measure_anew();
    for (int place = 0; place < ice_.places(); ++place) {
        if (!ice_.is_there(place) || !sleeping_.rests(place) || sleeping_.middle_x(place) > window_->last()) continue;
        sleeping_.rouse(world_, place);
        ice_.set_resting(place, false);
        encounters_.enter(1);
    }
    sleeping_.list_awake();
}

/// Only moorings let a structure come so far back: of the other ways scenario/checks_endless.cpp has seen the whole.
void Simulation::check_way_back() const {
    const double x = motion_.before().x;
    if (!window_->has_left(x)) return;
    throw MemberFailure(
        fmt::format("The moored structure has come back to x = {:.4g} m (t = {:.2f} s), and floes behind x = {:.4g} m "
                    "are gone from the field without end; take a larger field.behind_m or moorings that hold it.",
                    x, time(), window_->first()));
}

/// Floes of which no element is in the window any more. What stays in their places does not move.
void Simulation::leave_behind() {
    for (int place = 0; place < ice_.places(); ++place) {
        if (!ice_.is_there(place) || sleeping_.rests(place)) continue;
        const auto first = static_cast<std::size_t>(ice_.first_element(place));
        const auto count = static_cast<std::size_t>(ice_.elements(place));
        const auto elements = std::span(states_).subspan(first, count);
        const auto is_in = [&](const BodyState& one) { return one.position.x() >= window_->first(); };
        if (std::ranges::any_of(elements, is_in)) continue;
        encounters_.leave(place, ice_);
        ice_.leave(world_, place);
        sleeping_.leave(place);
        for (BodyState& one : elements) one.velocity = one.angular_velocity = Vec3::Zero();
    }
}

/// A part that finds no room ends the run, not the campaign; of the first ones the campaign hears at once.
std::vector<SingleFloe> Simulation::next_part() {
    try {
        return window_->next_part();
    } catch (const InputError& error) {
        if (steps_ == 0) throw;
        throw MemberFailure(fmt::format("The field cannot be laid on from x = {:.4g} m (t = {:.2f} s): {}.",
                                        window_->last(), time(), error.what()));
    }
}

bool Simulation::enter_ahead() {
    const std::vector<SingleFloe> part = next_part();
    std::vector<SingleFloe>& places = window_->places();
    for (const SingleFloe& floe : part) {
        const int place = ice_.enter(world_, scenario_, floe);
        places.resize(static_cast<std::size_t>(ice_.places()));
        places[static_cast<std::size_t>(place)] = floe;
        states_.resize(ice_.elements().size());
        const auto first = static_cast<std::size_t>(ice_.first_element(place));
        for (std::size_t i = first; i < first + static_cast<std::size_t>(ice_.elements(place)); ++i)
            states_[i] = world_.state(ice_.elements()[i].body);
        ice_.set_resting(place, true);
        sleeping_.rest(world_, ice_, place, states_);
    }
    return !part.empty();
}

/// All that is kept by element, for the floes that are there now.
void Simulation::measure_anew() {
    const FloeSet floes = gathered(window_->places());
    states_before_.resize(states_.size());
    water_ = make_water(scenario_, floes, ice_);
    piece_water_ = PieceWater(scenario_, floes);
    for (int place = 0; place < ice_.places(); ++place)
        if (ice_.is_there(place)) piece_water_.share_out(place, ice_, world_, water_);
    work_.measure(floes, ice_);
}

}  // namespace floes
