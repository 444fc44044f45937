#include "simulation/sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace floes {
namespace {

bool is_side(const IceSheet& form) {
    return form.inwards.x() == 0;
}

const char* place_of(const IceSheet& form) {
    return is_side(form) ? "a side" : "the far end";
}

}  // namespace

Sheets::Sheets(World& world, const Scenario& scenario, const Channel& channel)
    : confining_(scenario.field.confining),
      radius_(scenario.structure.shape.waterline_radius()),
      ahead_(scenario.structure.shape.waterline_ahead()) {
    for (const IceSheet& form : channel.sheets) {
        if (!give_way()) {
            world.add_fixed_box({.half_extents = form.half_extents, .pose = {.position = form.centre}});
            fixed_.push_back(form);
            continue;
        }
        const Vec3 size = 2 * form.half_extents;
        const double ice = scenario.ice.density * size.prod();
        const double load = confining_ * form.faces;
        const double skin = 0.5 * scenario.water.density * scenario.water.skin_drag * size.x() * size.z();
        const double closing = scenario.closing_speed();
        const double carried = scenario.water.added_mass_from == WaterFrom::outline ? scenario.water.added_mass_in_plane
                                                                                    : scenario.water.added_mass;
        const double mass = ice * (1 + carried) + scenario.general.time_step * load / closing;
        const BodyId body = world.add_sliding_box(
            {.half_extents = form.half_extents, .position = form.centre, .mass = mass, .axis = is_side(form) ? 2 : 0});
        sheets_.push_back({body, form, load, skin, closing});
    }
    motions_.resize(sheets_.size());
    mean_speed_.resize(sheets_.size());
}

void Sheets::place(World& world, const std::vector<SheetMotion>& motions) const {
    for (std::size_t i = 0; i < std::min(motions.size(), sheets_.size()); ++i) {
        const IceSheet& form = sheets_[i].form;
        world.place(sheets_[i].body, {.position = form.centre + motions[i].way * form.inwards,
                                      .velocity = motions[i].speed * form.inwards});
    }
}

void Sheets::press(World& world) const {
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
        const Sheet& sheet = sheets_[i];
        const double u = motions_[i].speed;
        const double load = sheet.load * (1 - std::max(u, 0.0) / sheet.closing);
        world.apply(sheet.body, {(load - sheet.skin * std::abs(u) * u) * sheet.form.inwards, Vec3::Zero()});
    }
}

void Sheets::read(const World& world, const PlanarPose& at, double time) {
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
        const IceSheet& form = sheets_[i].form;
        const BodyState state = world.state(sheets_[i].body);
        const double before = motions_[i].speed;
        motions_[i] = {(state.position - form.centre).dot(form.inwards), state.velocity.dot(form.inwards)};
        mean_speed_[i] = 0.5 * (before + motions_[i].speed);
        if (!touches(form, state.position, at)) continue;
        throw MemberFailure(fmt::format(
            "The ice sheet at {} has closed as far as the structure (t = {:.2f} s), which sheets cannot touch; take a "
            "smaller field.confining_N_m, a wider field or a higher concentration.",
            place_of(form), time));
    }
}

void Sheets::check_fixed(const PlanarPose& at, const Vec2& offset, double time) const {
    for (const IceSheet& form : fixed_) {
        if (!touches(form, form.centre, at)) continue;
        throw MemberFailure(fmt::format(
            "The moored structure has come to the ice sheet at {} (t = {:.2f} s), {:.4g} m from where its moorings "
            "would have it; take stiffer moorings or a wider field.",
            place_of(form), time, offset.norm()));
    }
}

bool Sheets::touches(const IceSheet& form, const Vec3& centre, const PlanarPose& at) const {
    const Vec3 edge = centre + form.half_extents.cwiseProduct(form.inwards);
    const Vec3 structure(at.x, 0, at.z);
    return !((structure - edge).dot(form.inwards) > (is_side(form) ? radius_ : ahead_));
}

Vec3 Sheets::velocity(BodyId body) const {
    for (std::size_t i = 0; i < sheets_.size(); ++i)
        if (sheets_[i].body == body) return mean_speed_[i] * sheets_[i].form.inwards;
    return Vec3::Zero();
}

}  // namespace floes
