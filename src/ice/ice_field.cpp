#include "ice/ice_field.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "core/error.hpp"
#include "core/state_archive.hpp"
#include "core/turn.hpp"
#include "ice/joint_stress.hpp"
#include "scenario/varied_ice.hpp"

namespace floes {

double size_of_ice(const Scenario& scenario) {
    constexpr double tank = 0.033;  // m
    return scenario.floe.thickness / tank;
}

World scenario_world(const Scenario& scenario) {
    const General& general = scenario.general;
    return World({.time_step = general.time_step,
                  .iterations = general.iterations,
                  .tolerance = general.tolerance,
                  .gravity = general.gravity / (1 + scenario.water.isotropic_mass()),  // the added mass has no weight
                  .contact = scenario.contact_law(),
                  .solver = general.solver,
                  .length_unit = size_of_ice(scenario)});
}

IceLayout::IceLayout(const FloeSet& floes) : first_joint{0} {
    std::vector<CutFloe> cuts;
    for (const FloeShape& shape : floes.shapes) cuts.push_back(shape.cut());
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const CutFloe& cut = cuts[floes.floes[i].shape];
        const int first = static_cast<int>(elements.size());
        for (const CutElement& one : cut.elements) {
            Vec3 half(0, floes.shape(i).thickness / 2, 0);
            for (const Corner& corner : one.corners)
                half = half.cwiseMax(Vec3(std::abs(corner.x), 0, std::abs(corner.z)));
            elements.push_back({static_cast<int>(i), half, one.rim, one.corners, cut.squares});
        }
        for (const CutJoint& one : cut.joints) joints.push_back({first + one.a, first + one.b, one.edge_a, one.edge_b});
        first_joint.push_back(joints.size());
    }
}

constexpr std::size_t no_element = ~std::size_t{0};

IceField::IceField(World& world, const Scenario& scenario, const FloeSet& floes)
    : time_step_(scenario.general.time_step) {
    std::vector<std::shared_ptr<const CutFloe>> cuts;
    for (const FloeShape& shape : floes.shapes) cuts.push_back(std::make_shared<const CutFloe>(shape.cut()));
    std::size_t elements = 0;
    std::size_t joints = 0;
    for (const Floe& floe : floes.floes) {
        elements += cuts[floe.shape]->elements.size();
        joints += cuts[floe.shape]->joints.size();
    }
    elements_.reserve(elements);
    joints_.reserve(joints);
    if (scenario.joint.fails_by_stress()) stress_.emplace(static_cast<std::size_t>(scenario.stress_steps()), elements);
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const Floe& floe = floes.floes[i];
        add_floe(world, scenario, {floe.pose, floes.shape(i), floes.material(i)}, cuts[floe.shape]);
    }
}

namespace {

Vec3 flat(const Corner& point) {
    return {point.x, 0, point.z};
}

Quat turned_by(double yaw) {
    const Turn half = turn_of(0.5 * yaw);
    return {half.cos, 0, half.sin, 0};
}

/// Of the joints, by number.
std::vector<JointStrength> strength_of(const SingleFloe& floe, const CutFloe& cut) {
    std::vector<JointStrength> found;
    PlacedIce ice(floe);
    for (const CutJoint& joint : cut.joints) {
        const SingleFloe& here = ice.at(joint.pivot);
        found.push_back(joint_strength(here.shape, here.material, joint.length, joint.span));
    }
    return found;
}

}  // namespace

void IceField::add_floe(World& world, const Scenario& scenario, const SingleFloe& floe,
                        std::shared_ptr<const CutFloe> cut) {
    const FloeShape& shape = floe.shape;
    const Material& material = floe.material;
    const Water& water = scenario.water;
    const auto place = static_cast<std::size_t>(
        std::ranges::find_if(
            floes_,
            [&](const Sheet& sheet) { return !sheet.there && sheet.cut->elements.size() == cut->elements.size(); }) -
        floes_.begin());
    const bool again = place < floes_.size();
    const auto first = again ? static_cast<std::size_t>(floes_[place].first) : elements_.size();
    if (!again) floes_.emplace_back();
    Sheet& sheet = floes_[place] = {
        .first = static_cast<int>(first), .number = entered_++, .cut = cut, .laid = {floe.pose.x, floe.pose.z}};
    const double pressure = scenario.contact_law(material.ice).crushing_pressure;
    const double crushing = pressure > 0 ? pressure : material.ice.compressive_strength;
    const bool on_all = water.form_drag_on == FormDragOn::every_element;
    const Quat yaw = turned_by(floe.pose.yaw);
    const Vec3 middle(floe.pose.x, shape.floating_height(material.ice, water.density), floe.pose.z);
    for (std::size_t index = 0; index < cut->elements.size(); ++index) {
        const CutElement& one = cut->elements[index];
        const unsigned every = (1U << static_cast<unsigned>(one.corners.size())) - 1;
        put_element(world, first + index,
                    {BodyId(0), static_cast<int>(place), static_cast<int>(index), static_cast<int>(first),
                     on_all ? every : one.rim},
                    {.corners = one.corners,
                     .half_thickness = shape.thickness / 2,
                     .mass = shape.element_mass(material.ice, one) * (1 + water.isotropic_mass()),
                     .pose = {middle + yaw * flat(one.centre), yaw * turned_to(one.axis)},
                     .piece = static_cast<int>(first),
                     .crushing_pressure = pressure});
        if (stress_)
            stress_->put_element(
                first + index, elements_[first + index].body, one.axis,
                {from_axes(one.corners, {}, one.axis), one.area, cut->squares ? square_patch : cell_patch,
                 material.ice.poisson_ratio, crushing, least_joint(shape.element)});
    }
    sheet.strength = floes::strength_of(floe, *cut);
    PlacedIce ice(floe);
    for (const CutJoint& joint : cut->joints) {
        const SingleFloe& here = ice.at(joint.pivot);
        const int a = sheet.first + joint.a;
        const int b = sheet.first + joint.b;
        add_joint(world, static_cast<int>(place), a, b,
                  {.a = at(a).body,
                   .b = at(b).body,
                   .pivot = middle + yaw * flat(joint.pivot),
                   .frame = yaw * turned_to(joint.normal),
                   .cfm = material.joint.cfm,
                   .erp = material.joint.erp,
                   .spring = joint_spring(here.shape, here.material, joint.length, joint.span)});
    }
}

void IceField::join(World& world, const SingleFloe& of, std::span<const CutJoint> joints) {
    sheet_ = true;
    PlacedIce ice(of);
    for (const CutJoint& one : joints) {
        const int place = place_of(one.a);
        Sheet& sheet = floes_[static_cast<std::size_t>(place)];
        const int other = floes_[static_cast<std::size_t>(place_of(one.b))].first;
        IceElement& a = elements_[static_cast<std::size_t>(sheet.first)];
        IceElement& b = elements_[static_cast<std::size_t>(other)];
        CutJoint& own = sheet.outer.emplace_back(one);
        own.a = own.b = 0;
        own.pivot = one.pivot - sheet.laid;
        const SingleFloe& here = ice.at(sheet.laid + own.pivot);
        sheet.strength.push_back(joint_strength(here.shape, here.material, own.length, own.span));
        const Vec3 middle = world.state(a.body).position - flat(sheet.cut->elements.front().centre);
        add_joint(world, place, sheet.first, other,
                  {.a = a.body,
                   .b = b.body,
                   .pivot = middle + flat(own.pivot),
                   .frame = turned_to(own.normal),
                   .cfm = of.material.joint.cfm,
                   .erp = of.material.joint.erp,
                   .spring = joint_spring(here.shape, here.material, own.length, own.span)});
        a.exposed_edges &= ~own.edge_a;
        b.exposed_edges &= ~own.edge_b;
    }
    regroup(world, 0, elements_.size());
}

void IceField::hold_edge(World& world, const SingleFloe& floe, int place, BodyId support, const Vec3& outwards) {
    const Sheet& sheet = floes_[static_cast<std::size_t>(place)];
    const Quat yaw = turned_by(floe.pose.yaw);
    const Vec3 to_floe = yaw.conjugate() * outwards;
    const Corner normal{to_floe.x(), to_floe.z()};
    double edge = 0;
    for (const Corner& corner : floe.shape.corners()) edge = std::max(edge, dot(corner, normal));
    const Vec3 middle(floe.pose.x, world.state(elements_[static_cast<std::size_t>(sheet.first)].body).position.y(),
                      floe.pose.z);
    PlacedIce ice(floe);
    for (int index = 0; index < sheet.elements(); ++index) {
        IceElement& element = elements_[static_cast<std::size_t>(sheet.first + index)];
        const CutElement& one = cut_element(element);
        const Outline corners = from_axes(one.corners, one.centre, one.axis);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            if ((one.rim >> k & 1U) == 0) continue;
            const Corner& from = corners[k];
            const Corner& to = corners[(k + 1) % corners.size()];
            const double rounding = 1e-6 * floe.shape.element;
            if (std::min(dot(from, normal), dot(to, normal)) < edge - rounding) continue;
            const double span = edge - dot(one.centre, normal);  // from the centre to the clamp
            const Corner along = 0.5 * (from + to) - (0.5 * span) * normal;
            const SingleFloe& here = ice.at(along);
            const double length = std::hypot(to.x - from.x, to.z - from.z);
            const Quat axes = yaw * turned_to(normal);
            supports_.push_back({world.add_joint({.a = element.body,
                                                  .b = support,
                                                  .pivot = middle + yaw * flat(along),
                                                  .frame = axes,
                                                  .spring = joint_spring(here.shape, here.material, length, span)}),
                                 axes});
            element.exposed_edges &= ~(1U << k);
        }
    }
}

Vec3 IceField::force_on_supports(const World& world) const {
    Vec3 sum = Vec3::Zero();
    for (const Support& one : supports_) sum -= one.axes * world.reaction(one.joint).force();
    for (const Joint& joint : joints_) {
        if (!sheet_) break;
        const auto rests = [&](int element) { return floes_[static_cast<std::size_t>(at(element).floe)].rests; };
        if (rests(joint.a) == rests(joint.b)) continue;
        const Vec3 on_a = turned_to(cut_joint(joint).normal) * world.reaction(joint.id).force();
        sum += rests(joint.a) ? on_a : Vec3(-on_a);
    }
    return sum;
}

/// Tells the stress of a joint that was just made.
void IceField::feel(const Joint& joint) {
    const CutJoint& cut = cut_joint(joint);
    const double thickness = strength_of(joint).section.thickness;
    const auto of = [&](int element, double way, unsigned edge) {
        const Corner beside = floes_[static_cast<std::size_t>(at(element).floe)].laid - floe_of(joint).laid;
        const Corner centre = cut_element(at(element)).centre + beside;
        return ElementJoint{way * cut.normal, cut.pivot - centre, cut.length, cut.span, thickness, edge};
    };
    stress_->put_joint(joint.place, joint.id, static_cast<std::size_t>(joint.a), of(joint.a, 1, cut.edge_a),
                       static_cast<std::size_t>(joint.b), of(joint.b, -1, cut.edge_b));
}

/// At the end, or in place of an element that has left.
void IceField::put_element(World& world, std::size_t at, const IceElement& element,
                           const ElementDefinition& definition) {
    if (at < elements_.size()) {
        const BodyId body = elements_[at].body;
        world.put_in(body, definition);
        elements_[at] = element;
        elements_[at].body = body;
        return;
    }
    const BodyId body = world.add_element(definition);
    element_of_body_.resize(std::max(element_of_body_.size(), body.index() + 1), no_element);
    element_of_body_[body.index()] = elements_.size();
    elements_.push_back(element);
    elements_.back().body = body;
}

/// The next one of the floe at this place, under a free id or a new one. Joints of a floe have rising ids if they are
/// free, so that they are solved in their order, as if new.
void IceField::add_joint(World& world, int place, int a, int b, const JointDefinition& definition) {
    std::size_t made = joint_ids_.size();
    if (free_joints_.empty()) {
        joint_ids_.push_back(world.add_joint(definition));
    } else {
        made = free_joints_.back();
        free_joints_.pop_back();
        world.put_in(joint_ids_[made], definition);
    }
    std::vector<std::size_t>& of_floe = floes_[static_cast<std::size_t>(place)].joints;
    joints_.push_back({joint_ids_[made], place, static_cast<int>(of_floe.size()), a, b, made});
    of_floe.push_back(made);
    if (stress_) feel(joints_.back());
}

std::optional<std::size_t> IceField::element_of(BodyId body) const {
    if (body.index() >= element_of_body_.size() || element_of_body_[body.index()] == no_element) return {};
    return element_of_body_[body.index()];
}

int IceField::break_joints(World& world, double time) {
    const std::size_t before = breaks_.size();
    auto kept = joints_.begin();
    if (stress_) stress_->read(world);
    for (Joint& joint : joints_) {
        const std::optional<FailureMode> mode = floe_of(joint).rests ? std::nullopt : failing(world, joint);
        if (!mode) {
            *kept++ = joint;
            continue;
        }
        fail(world, joint, {time, number_of(joint.floe), joint.number, *mode});
    }
    joints_.erase(kept, joints_.end());
    split_broken(world, before);
    return static_cast<int>(breaks_.size() - before);
}

double IceField::joint_power(const World& world, std::span<const BodyState> before, std::span<const Vec3> velocity,
                             std::span<const Vec3> angular_velocity) const {
    double sum = 0;
    for (const Joint& joint : joints_) {
        const auto a = static_cast<std::size_t>(joint.a);
        const auto b = static_cast<std::size_t>(joint.b);
        const JointReaction reaction = world.reaction(joint.id);
        const CutJoint& cut = cut_joint(joint);
        const Corner beside = cut.pivot - floe_of(joint).cut->elements[static_cast<std::size_t>(cut.a)].centre;
        const Mat3 frame = floe_axes(joint.a, before[a]) * turned_to(cut.normal).toRotationMatrix();  // joint -> world
        const Vec3 pivot =
            before[a].position + 0.5 * cut.span * frame.col(0) + cross(cut.normal, beside) * frame.col(2);
        const Vec3 force = frame * reaction.force();
        const Vec3 moment = frame * reaction.moment();
        const Vec3 at_a = velocity[a] + angular_velocity[a].cross(pivot - before[a].position);
        const Vec3 at_b = velocity[b] + angular_velocity[b].cross(pivot - before[b].position);
        sum += force.dot(at_a - at_b) + moment.dot(angular_velocity[a] - angular_velocity[b]);
    }
    return sum;
}

void IceField::repeat_breaks(World& world, std::span<const BreakEvent> breaks) {
    const std::size_t before = breaks_.size();
    for (const BreakEvent& event : breaks) {
        const auto joint = std::ranges::find_if(joints_, [&](const Joint& live) {
            return number_of(live.floe) == event.floe && live.number == event.joint;
        });
        if (joint == joints_.end()) {
            throw InputError(fmt::format("Joint {} of floe {} cannot break at t = {:.2f} s: there is no such joint.",
                                         event.joint, event.floe, event.time));
        }
        fail(world, *joint, event);
        joints_.erase(joint);
    }
    split_broken(world, before);
}

void IceField::fail(World& world, const Joint& joint, const BreakEvent& event) {
    world.remove_joint(joint.id);
    if (stress_) failed_.push_back(joint.place);
    for (const int element : {joint.a, joint.b}) {
        Sheet& sheet = floes_[static_cast<std::size_t>(at(element).floe)];
        sheet.cracked = sheet.broken = true;
    }
    expose_edges(joint);
    breaks_.push_back(event);
}

void IceField::split_broken(World& world, std::size_t first_break) {
    for (const std::size_t joint : failed_) stress_->remove_joint(joint);
    failed_.clear();
    if (sheet_ && first_break < breaks_.size()) return regroup(world, 0, elements_.size());
    for (std::size_t i = first_break; i < breaks_.size(); ++i) {
        if (i != first_break && breaks_[i].floe == breaks_[i - 1].floe) continue;
        const Sheet& sheet = floes_[static_cast<std::size_t>(place_of(breaks_[i].floe))];
        regroup(world, static_cast<std::size_t>(sheet.first), static_cast<std::size_t>(sheet.elements()));
    }
}

void IceField::expose_edges(const Joint& joint) {
    const CutJoint& cut = cut_joint(joint);
    elements_[static_cast<std::size_t>(joint.a)].exposed_edges |= cut.edge_a;
    elements_[static_cast<std::size_t>(joint.b)].exposed_edges |= cut.edge_b;
}

/// Finds the pieces of these elements, which no joint connects to others.
void IceField::regroup(World& world, std::size_t first, std::size_t count) {
    Components pieces(count);
    for (const Joint& joint : joints_) {
        const std::size_t a = static_cast<std::size_t>(joint.a) - first;
        if (a < count) pieces.connect(a, static_cast<std::size_t>(joint.b) - first);
    }
    for (std::size_t index = 0; index < count; ++index) {
        IceElement& element = elements_[first + index];
        const auto piece = static_cast<int>(first + pieces.first(index));
        if (piece == element.piece) continue;
        element.piece = piece;
        world.set_piece(element.body, piece);
    }
}

int IceField::enter(World& world, const Scenario& scenario, const SingleFloe& floe) {
    const int number = entered_;
    add_floe(world, scenario, floe, std::make_shared<const CutFloe>(floe.shape.cut()));
    return place_of(number);
}

std::vector<int> IceField::behind(std::span<const BodyState> states, double x) const {
    // Of a sheet a piece that is held goes element by element, others as a whole.
    const std::vector<bool> held = held_pieces();
    std::vector<bool> is_ahead(elements_.size());  // by the first element of a piece or, without a sheet, of a floe
    const auto first_of = [&](const IceElement& element) {
        return static_cast<std::size_t>(sheet_ ? element.piece : floes_[static_cast<std::size_t>(element.floe)].first);
    };
    for (std::size_t i = 0; i < elements_.size(); ++i)
        if (is_there(elements_[i].floe) && !(states[i].position.x() < x)) is_ahead[first_of(elements_[i])] = true;
    std::vector<int> found;
    for (int place = 0; place < places(); ++place) {
        if (!is_there(place) || rests(place)) continue;
        const auto first = static_cast<std::size_t>(first_element(place));
        const bool alone = sheet_ && held[first_of(elements_[first])];
        if (alone ? states[first].position.x() < x : !is_ahead[first_of(elements_[first])]) found.push_back(place);
    }
    return found;
}

void IceField::leave(World& world, std::span<const int> places) {
    if (sheet_) {
        const std::map<int, double> pieces = loose_pieces(places);
        left_.pieces += static_cast<int>(pieces.size());
        for (const auto& [piece, area] : pieces) left_.areas.push_back({0, area});
    }
    for (const int place : places) {
        Sheet& sheet = floes_[static_cast<std::size_t>(place)];
        left_.broken += sheet.broken ? 1 : 0;
        left_.cracked += sheet.cracked ? 1 : 0;
        if (!sheet_) {
            const int pieces = pieces_at(sheet);
            left_.split += pieces > 1 ? 1 : 0;
            left_.pieces += pieces;
            add_piece_areas(sheet, left_.areas);
        }
        sheet.there = false;
    }
    const auto has_left = [&](const Joint& joint) {
        return !is_there(at(joint.a).floe) || !is_there(at(joint.b).floe);
    };
    for (const Joint& joint : joints_) {
        if (!has_left(joint)) continue;
        world.remove_joint(joint.id);
        if (stress_) stress_->remove_joint(joint.place);
        if (sheet_) expose_edges(joint);
    }
    std::erase_if(joints_, has_left);
    for (const int place : places) {
        const Sheet& sheet = floes_[static_cast<std::size_t>(place)];
        free_joints_.insert(free_joints_.end(), sheet.joints.begin(), sheet.joints.end());
        for (int index = 0; index < sheet.elements(); ++index)
            world.take_out(elements_[static_cast<std::size_t>(sheet.first + index)].body);
    }
    std::ranges::sort(free_joints_, std::ranges::greater());
    if (sheet_ && !places.empty()) regroup(world, 0, elements_.size());
}

std::vector<bool> IceField::held_pieces() const {
    std::vector<bool> held(elements_.size());
    for (const IceElement& element : elements_)
        if (is_there(element.floe) && rests(element.floe)) held[static_cast<std::size_t>(element.piece)] = true;
    return held;
}

/// Areas of the sheet's pieces that have broken off, of the floes at these places.
std::map<int, double> IceField::loose_pieces(std::span<const int> places) const {
    const std::vector<bool> held = held_pieces();
    std::map<int, double> found;
    for (const int place : places) {
        const IceElement& element = elements_[static_cast<std::size_t>(first_element(place))];
        if (is_there(place) && !held[static_cast<std::size_t>(element.piece)])
            found[element.piece] += cut_element(element).area;
    }
    return found;
}

std::vector<int> IceField::all_places() const {
    std::vector<int> all(floes_.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

int IceField::place_of(int number) const {
    const auto at = static_cast<std::size_t>(number);
    if (at < floes_.size() && floes_[at].number == number) return number;  // always, where none leaves
    return static_cast<int>(std::ranges::find(floes_, number, &Sheet::number) - floes_.begin());
}

int IceField::pieces_at(const Sheet& sheet) const {
    std::set<int> pieces;
    for (int index = 0; index < sheet.elements(); ++index)
        pieces.insert(elements_[static_cast<std::size_t>(sheet.first + index)].piece);
    return static_cast<int>(pieces.size());
}

int IceField::broken_floes() const {
    const auto broken = [](const Sheet& sheet) { return sheet.there && sheet.broken; };
    return left_.broken + static_cast<int>(std::ranges::count_if(floes_, broken));
}

int IceField::split_floes() const {
    const auto split = [&](const Sheet& sheet) { return sheet.there && pieces_at(sheet) > 1; };
    return left_.split + static_cast<int>(std::ranges::count_if(floes_, split));
}

int IceField::pieces() const {
    int found = left_.pieces;
    if (sheet_) return found + static_cast<int>(loose_pieces(all_places()).size()) + 1;
    for (const Sheet& sheet : floes_)
        if (sheet.there) found += pieces_at(sheet);
    return found;
}

/// Nothing of a floe in one piece.
void IceField::add_piece_areas(const Sheet& sheet, std::vector<PieceArea>& areas) const {
    const auto first = static_cast<std::size_t>(sheet.first);
    std::map<int, double> of_piece;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sheet.elements()); ++i)
        of_piece[elements_[first + i].piece] += sheet.cut->elements[i].area;
    if (of_piece.size() == 1) return;
    for (const auto& [piece, area] : of_piece) areas.push_back({sheet.number, area});
}

std::vector<PieceArea> IceField::piece_areas() const {
    std::vector<PieceArea> areas = left_.areas;
    if (sheet_) {
        for (const auto& [piece, area] : loose_pieces(all_places())) areas.push_back({0, area});
        return areas;
    }
    for (const Sheet& sheet : floes_)
        if (sheet.there) add_piece_areas(sheet, areas);
    std::ranges::stable_sort(areas, {}, &PieceArea::floe);
    return areas;
}

int IceField::cracked_floes() const {
    const auto cracked = [](const Sheet& sheet) { return sheet.there && sheet.cracked; };
    return left_.cracked + static_cast<int>(std::ranges::count_if(floes_, cracked));
}

// How joints of an IceField fail: at once by moment, or as cracks by stress.

namespace {

Vec2 horizontal(const Vec3& v) {
    return {v.x(), v.z()};
}

}  // namespace

IceField::Turned IceField::turned(const World& world, const Joint& joint) const {
    const BodyState a = world.state(at(joint.a).body);
    const BodyState b = world.state(at(joint.b).body);
    const Mat3 axes = floe_axes(joint.a, a);
    const Mat3 between = axes.transpose() * floe_axes(joint.b, b);
    const Vec2 angles(0.5 * (between(2, 1) - between(1, 2)), 0.5 * (between(1, 0) - between(0, 1)));
    const double angle = angles.norm();
    if (!(angle > 0)) return {};
    return {angle, angles.dot(horizontal(axes.transpose() * (b.angular_velocity - a.angular_velocity))) / angle};
}

std::optional<FailureMode> IceField::failing(World& world, Joint& joint) {
    const JointStrength& strength = strength_of(joint);
    if (!stress_) {
        const JointReaction reaction = world.reaction(joint.id);
        peaks_ = raised(peaks_, reaction);
        return failure(reaction, strength.thresholds);
    }
    peaks_ = raised(peaks_, stress_->reaction(joint.place));
    if (joint.crack) return crack_on(world, joint);
    if (!may_fail(stress_->reaction(joint.place), stress_->across(joint.place), stress_->most_by_contacts(joint.place),
                  strength.section, strength.thresholds))
        return std::nullopt;
    const JointLoad load = stress_->load(joint.place);
    const Utilisation used = utilisation(load, strength.section, strength.thresholds);
    if (!(used.share > 1)) return std::nullopt;
    if (used.mode != FailureMode::bending) return used.mode;
    if (strength.crack_energy > 0 && is_pulled_apart(load, strength.section)) return FailureMode::tension;
    const Turned now = turned(world, joint);
    const double smooth = fibre_tension(smoothed(load), strength.section).stress / strength.section.flexural_strength;
    const double energy = strength.crack_energy * fibre_tension(load, strength.section).facing;
    const double over = cracking(used.share, smooth, strength.stiffness, now.angle, energy, strength.length_over_span);
    // A bend that has not the energy leaves what else fails the joint.
    if (!(over > 1)) return failure(without_bending(load.reaction), strength.thresholds);
    for (const int end : {joint.a, joint.b})
        floes_[static_cast<std::size_t>(elements_[static_cast<std::size_t>(end)].floe)].cracked = true;
    joint.crack.emplace(cohesive_law(strength.stiffness, now.angle / over, energy));
    return crack_on(world, joint);
}

std::optional<FailureMode> IceField::crack_on(World& world, Joint& joint) {
    const Turned now = turned(world, joint);
    Crack& crack = *joint.crack;
    const double sound = crack.sound();
    const double energy = crack.energy();
    crack.follow(now.angle, now.rate, time_step_);
    fracture_work_ += crack.energy() - energy;
    if (crack.is_open()) return FailureMode::bending;
    if (crack.sound() < sound) world.soften_joint(joint.id, crack.sound());
    // Cracked ice is still pulled apart and shears off, and a thrust still crushes it.
    const JointStrength& strength = strength_of(joint);
    if (is_pulled_apart(stress_->load(joint.place), strength.section)) return FailureMode::tension;
    return failure(without_bending(stress_->reaction(joint.place)), strength.thresholds);
}

void IceField::read_utilisation(const World& world, std::vector<double>& worst) const {
    worst.assign(elements_.size(), 0.0);
    for (const Joint& joint : joints_) {
        double used = 0;
        if (!stress_)
            used = utilisation(world.reaction(joint.id), strength_of(joint).thresholds);
        else if (joint.crack)
            used = 2 - joint.crack->sound();
        else
            used = utilisation(stress_->load(joint.place), strength_of(joint).section, strength_of(joint).thresholds)
                       .share;
        for (const int index : {joint.a, joint.b}) {
            double& element = worst[static_cast<std::size_t>(index)];
            element = std::max(element, used);
        }
    }
}

Mat3 IceField::floe_axes(int element, const BodyState& state) const {
    const Corner& axis = cut_element(at(element)).axis;
    return state.rotation * turned_to(axis).toRotationMatrix().transpose();
}

void IceField::Joint::archive(StateArchive& state) {
    auto& [joint, of, in_floe, one, other, among, cracks] = *this;
    state(joint, of, in_floe, one, other, among);
    state.maybe(cracks, Crack({}));
}

void IceField::Sheet::archive(StateArchive& state) {
    auto& [element, entry, elements_of, strengths, made, to_others, middle, has_cracked, has_broken, is_there,
           is_at_rest] = *this;
    state(element, entry, made, to_others, has_cracked, has_broken, is_there,
          is_at_rest);  // the others follow from the floe
}

void IceField::archive(StateArchive& state) {
    auto& [sheets, elements, element_of_body, joint_ids, supports, free_joints, entered, sheet, left, joints, breaks,
           peaks, time_step, stress, failed, fracture_work] = *this;
    state.list(sheets, Sheet{0, 0, nullptr});
    state.list(elements, IceElement{BodyId(0)});
    state.list(joint_ids, JointId(0));
    state.list(joints, Joint{JointId(0), 0, 0, 0, 0, 0});
    state(element_of_body, free_joints, entered, sheet, left, breaks, peaks, fracture_work);
    if (stress) stress->archive(state);
}

void IceField::set_floe(int place, const SingleFloe& floe) {
    Sheet& sheet = floes_[static_cast<std::size_t>(place)];
    sheet.cut = std::make_shared<const CutFloe>(floe.shape.cut());
    sheet.strength = floes::strength_of(floe, *sheet.cut);
    sheet.laid = {floe.pose.x, floe.pose.z};
    if (sheet.outer.empty()) return;
    PlacedIce ice(floe);
    for (const CutJoint& joint : sheet.outer) {
        const SingleFloe& here = ice.at(sheet.laid + joint.pivot);
        sheet.strength.push_back(joint_strength(here.shape, here.material, joint.length, joint.span));
    }
}

}  // namespace floes
