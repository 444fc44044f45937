#include "simulation/sheets.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/state_archive.hpp"

namespace floes {

namespace {

/// Floes pass round the structure and stay between walls. 1 m in the paper's tank. Of level ice whatever may pile up.
double room_for_a_floe(const Scenario& scenario, const FloeSet& floes) {
    const bool sheet = scenario.arrangement.level() && scenario.field.endless();
    return 5 * (sheet ? std::max(scenario.floe.breadth, largest_side(floes)) : largest_side(floes)) / 3;
}

/// Length of the sides of a field without end, m. The same for every run, or the bits of a load would tell how long
/// its run is; twice the longest tow (scenario/checks_field.cpp).
constexpr double without_end = 2e5;

/// How far wind and current can take floes beside what the tow pushes, at most: with the current, and by the wind
/// against skin drag alone.
double drift_of(const Scenario& scenario) {
    const Water& water = scenario.water;
    const double duration = scenario.analysis.steady_start + scenario.analysis.window;
    const double least_drag = 0.5 * water.density * std::max(water.skin_drag, 1e-3);
    return duration * (water.current + std::sqrt(scenario.wind.stress().norm() / least_drag));
}

}  // namespace

Channel make_channel(const Scenario& scenario, const FloeSet& floes) {
    const Field& field = scenario.field;
    const bool closed = field.far_end == FarEnd::ice_sheet;
    const double towed = scenario.towed();
    Channel channel;
    channel.room = room_for_a_floe(scenario, floes);
    const double came = field.endless() ? without_end / 2 : towed;
    channel.begin = scenario.structure.start - scenario.structure.shape.largest_radius() - channel.room -
                    (field.level_pushed ? came : 0.0);
    channel.end = scenario.field_end() + field.sheet_width + (closed ? 0.0 : towed);
    if (field.endless()) channel.end = channel.begin + without_end;
    channel.inner_edge = field.half_width;
    channel.outer_edge = field.half_width + field.sheet_width;
    const bool moves = field.confining > 0;
    const double drift = drift_of(scenario);
    if (moves || field.sides == FieldSides::open || drift > 0) channel.drift = drift + towed;
    const Vec2 along{channel.begin, channel.end};
    const double height = scenario.floe.floating_height(scenario.ice, scenario.water.density);
    const auto add = [&](const Vec2& x, const Vec2& z, const Vec3& inwards, double faces) {
        channel.sheets.push_back({{x.mean(), height, z.mean()},
                                  {0.5 * (x.y() - x.x()), 0.5 * scenario.floe.thickness, 0.5 * (z.y() - z.x())},
                                  inwards,
                                  faces});
    };
    if (field.sides == FieldSides::ice_sheet) {
        const double faces = scenario.field_length();
        add(along, {channel.inner_edge, channel.outer_edge}, -Vec3::UnitZ(), faces);
        add(along, {-channel.outer_edge, -channel.inner_edge}, Vec3::UnitZ(), faces);
    }
    if (closed) {  // a sheet that moves leaves no gap at the corners when the sides give way
        const double edge = moves ? channel.outer_edge : channel.inner_edge;
        add({scenario.field_end(), channel.end}, {-edge, edge}, -Vec3::UnitX(), 2 * channel.inner_edge);
    }
    return channel;
}

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
      push_(scenario.field.level_pushed ? scenario.structure.speed : 0),
      radius_(scenario.structure.shape.waterline_radius()) {
    if (!scenario.structure.shape.is_of_revolution())
        for (const std::vector<Vec2>& outline : scenario.structure.shape.waterlines())
            for (const Vec2& corner : outline) waterline_.push_back({corner.x(), 0, corner.y()});
    const double closing = give_way() ? scenario.closing_speed() : 0;
    for (const IceSheet& form : channel.sheets) {
        if (!give_way()) {
            fixed_.push_back(
                {world.add_fixed_box({.half_extents = form.half_extents, .pose = {.position = form.centre}}), form});
            continue;
        }
        const Vec3 size = 2 * form.half_extents;
        const double ice = scenario.ice.density * size.prod();
        const double load = confining_ * form.faces;
        const double skin = 0.5 * scenario.water.density * scenario.water.skin_drag * size.x() * size.z();
        const double carried = scenario.water.added_mass_from == WaterFrom::outline ? scenario.water.added_mass_in_plane
                                                                                    : scenario.water.added_mass;
        const double mass = ice * (1 + carried) + scenario.general.time_step * load / closing;
        const BodyId body = world.add_sliding_box(
            {.half_extents = form.half_extents, .position = form.centre, .mass = mass, .axis = is_side(form) ? 2 : 0});
        sheets_.push_back({body, form, load, skin, closing});
    }
    if (scenario.field.sides == FieldSides::wall && scenario.structure.shape.waterline_radius() < channel.inner_edge)
        for (const double side : {-1.0, 1.0})
            walls_.push_back({.centre = side * channel.inner_edge * Vec3::UnitZ(), .inwards = -side * Vec3::UnitZ()});
    motions_.resize(push_ > 0 ? fixed_.size() : sheets_.size());
    mean_speed_.resize(sheets_.size());
}

void Sheets::place(World& world, const std::vector<SheetMotion>& motions) const {
    for (std::size_t i = 0; i < std::min(motions.size(), sheets_.size()); ++i) {
        const IceSheet& form = sheets_[i].form;
        world.place(sheets_[i].body, {.position = form.centre + motions[i].way * form.inwards,
                                      .velocity = motions[i].speed * form.inwards});
    }
}

void Sheets::press(World& world, double time) {
    for (std::size_t i = 0; i < fixed_.size() && push_ > 0; ++i) {
        const auto& [body, form] = fixed_[i];
        const Vec3 along = -Vec3::UnitX();
        world.place(body, {.position = form.centre + push_ * time * along, .velocity = push_ * along});
        motions_[i] = {push_ * time * along.dot(form.inwards), push_ * along.dot(form.inwards)};
    }
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
        const Sheet& sheet = sheets_[i];
        const double u = motions_[i].speed;
        const double load = sheet.load * (1 - std::max(u, 0.0) / sheet.closing);
        world.apply(sheet.body, {(load - sheet.skin * std::abs(u) * u) * sheet.form.inwards, Vec3::Zero()});
    }
}

void Sheets::read(const World& world, const StructurePose& at, double time) {
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

void Sheets::check_fixed(const StructurePose& at, const Vec2& offset, double time) const {
    const auto check = [&](const IceSheet& form, const char* what) {
        if (!touches(form, form.centre, at)) return;
        throw MemberFailure(fmt::format(
            "The structure has come to the {} at {} (t = {:.2f} s), {:.4g} m from where its tow alone would have it; "
            "take stiffer moorings or a wider field.",
            what, place_of(form), time, offset.norm()));
    };
    for (const auto& [body, form] : fixed_) check(form, "ice sheet");
    for (const IceSheet& wall : walls_) check(wall, "wall");
}

bool Sheets::touches(const IceSheet& form, const Vec3& centre, const StructurePose& at) const {
    const Vec3 edge = centre + form.half_extents.cwiseProduct(form.inwards);
    const auto clear = [&](const Vec3& from_axis, double radius) {
        return (at.position + from_axis - edge).dot(form.inwards) > radius;
    };
    if (waterline_.empty()) return !clear(Vec3::Zero(), radius_);
    const Quat turn = turned_about_y(at.yaw);
    return !std::ranges::all_of(waterline_, [&](const Vec3& corner) { return clear(turn * corner, 0); });
}

Vec3 Sheets::velocity(BodyId body) const {
    for (std::size_t i = 0; i < sheets_.size(); ++i)
        if (sheets_[i].body == body) return mean_speed_[i] * sheets_[i].form.inwards;
    return Vec3::Zero();
}

void Sheets::archive(StateArchive& state) {
    auto& [confining, push, radius, waterline, fixed, walls, sheets, motions, mean_speed] = *this;
    state(motions, mean_speed);
}

}  // namespace floes
