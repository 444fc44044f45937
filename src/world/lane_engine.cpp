// Our own world: ice meets ice (collision/ice_contacts.hpp) and the structure (world/hull_contacts.hpp), and our solver
// does the rest (solver/lane_system.hpp), which alone knows where bodies are and how they move.

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <iterator>
#include <utility>

#include "collision/ice_contacts.hpp"
#include "core/state_archive.hpp"
#include "shapes/elements.hpp"
#include "solver/lane_system.hpp"
#include "solver/lane_width.hpp"
#include "solver/slip_friction.hpp"
#include "world/bullet_shapes.hpp"
#include "world/engine.hpp"
#include "world/hull_contacts.hpp"
#include "world/plane_contacts.hpp"

namespace floes {
namespace {

constexpr std::size_t not_in_system = static_cast<std::size_t>(-1);

std::uint32_t number_of(BodyId body) {
    return static_cast<std::uint32_t>(body.index());
}

/// At rest there.
SolverState state_at(const Pose& pose) {
    const btTransform place = to_bullet(pose);
    return {array_of(place.getOrigin()), rows_of(place.getBasis()), {}, {}};
}

SolverState solver_state(const BodyState& state) {
    SolverState to;
    Eigen::Map<Vec3>(to.position.data()) = state.position;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(to.rotation.data()) = state.rotation;
    Eigen::Map<Vec3>(to.velocity.data()) = state.velocity;
    Eigen::Map<Vec3>(to.angular_velocity.data()) = state.angular_velocity;
    return to;
}

BodyState body_state(const double* position, const double* rotation, const double* velocity,
                     const double* angular_velocity) {
    return {Eigen::Map<const Vec3>(position), Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation),
            Eigen::Map<const Vec3>(velocity), Eigen::Map<const Vec3>(angular_velocity)};
}

/// The state with its pose moved by a velocity and angular velocity that only open a penetration (split impulse).
SolverState pushed(SolverState state, const std::array<double, 6>& push, double time_step) {
    btTransform after;
    btTransformUtil::integrateTransform(
        transform_of(state.position.data(), state.rotation.data()), {push[0], push[1], push[2]},
        btVector3(push[3], push[4], push[5]) * btContactSolverInfo().m_splitImpulseTurnErp, time_step, after);
    state.position = array_of(after.getOrigin());
    state.rotation = rows_of(after.getBasis());
    return state;
}

/// The turn from one rotation to another as a vector, rad; exactly zero where they are equal.
Vec3 turn_between(const Quat& before, const Quat& after) {
    if (before.coeffs() == after.coeffs()) return Vec3::Zero();
    Quat turn = after * before.conjugate();
    if (turn.w() < 0) turn.coeffs() *= -1;
    const double sine = turn.vec().norm();
    return sine > 0 ? Vec3(turn.vec() * (2 * std::atan2(sine, turn.w()) / sine)) : Vec3::Zero();
}

void merge(std::span<const Touching> one, std::span<const Touching> other, std::vector<Touching>& to) {
    to.clear();
    std::merge(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(to));
}

class LaneEngine final : public Engine {
  public:
    explicit LaneEngine(const WorldDefinition& definition)
        : definition_(definition),
          friction_(material_friction(definition.contact)),
          width_(lane_kernels(definition.lanes > 0 ? definition.lanes : lane_widths().back()).width) {}

    void add_body(const ElementDefinition& body, std::optional<int> rail) override {
        IceShape& shape = shapes_.emplace_back(body.corners, body.half_thickness);
        shape_of_.push_back(&shape);
        const Body& made = bodies_.emplace_back(made_of(body, shape, rail));
        ice_.add(contact_element(shape, made, body.piece));
        loose_.push_back(body.mass > 0 && !rail ? LooseElement(shape) : LooseElement());
        hull_.add();
        planes_.add();
        stale_ = true;
    }

    void add_structure(std::span<const ConvexSolid> solids, const Pose& pose) override {
        structure_ = static_cast<std::uint32_t>(bodies_.size());
        structure_pose_ = structure_last_ = pose;
        add_without_shape(pose).friction = friction_.structure;
        hull_.set_structure(*structure_, solids, definition_.contact.normal);
    }

    void move_structure(const Pose& pose) override { structure_pose_ = pose; }

    void add_plane(const PlaneDefinition& plane) override {
        const auto& [point, normal, friction] = plane;
        planes_.add_plane(static_cast<std::uint32_t>(bodies_.size()), {point.x(), point.y(), point.z()},
                          {normal.x(), normal.y(), normal.z()});
        add_without_shape({.position = point}).friction = friction;
    }

    void add_joint(const JointDefinition& joint) override {
        joints_.push_back(joint_of(joint));
        removed_.push_back(false);
        hold_edges(joints_.back(), true);
        stale_ = true;
    }

    void remove_joint(JointId joint) override {
        if (removed_[joint.index()]) return;
        removed_[joint.index()] = true;
        hold_edges(joints_[joint.index()], false);
        if (in_system(joint)) system_->remove_joint(joint_in_system_[joint.index()]);
    }

    void soften_joint(JointId joint, double sound) override {
        joints_[joint.index()].sound = sound;
        if (in_system(joint)) system_->soften_joint(joint_in_system_[joint.index()], sound);
    }

    void set_piece(BodyId body, int piece) override { ice_.set_piece(number_of(body), piece); }

    void place(BodyId body, const BodyState& state) override {
        bodies_[body.index()].start = solver_state(state);
        if (in_system(body)) system_->set_state(body.index(), bodies_[body.index()].start);
        ice_.move(number_of(body), store_);
        forget_contacts(body);
        if (structure_ == number_of(body))
            structure_pose_ = structure_last_ = {state.position, Quat(state.rotation).normalized()};
    }

    void set_water(BodyId body, const CarriedWater& water) override {
        bodies_[body.index()].parts.water = water;
        if (!stale_ && in_system(body)) system_->set_water(body.index(), water);  // a new system takes it from `parts`
    }

    void set_asleep(BodyId body, bool asleep) override {
        bodies_[body.index()].asleep = asleep;
        ice_.set_asleep(number_of(body), asleep);
        stale_ = true;
    }

    std::vector<BodyId> touched_asleep() const override {
        std::vector<BodyId> touched;
        for (const Touching& pair : touching_) {
            if (bodies_[pair.a].asleep == bodies_[pair.b].asleep) continue;
            const auto [asleep, awake] = bodies_[pair.a].asleep ? std::pair(pair.a, pair.b) : std::pair(pair.b, pair.a);
            if (moves(awake) || structure_ == awake) touched.emplace_back(asleep);  // at walls and the bed they lie
        }
        return touched;
    }

    void take_out(BodyId body) override {
        bodies_[body.index()].asleep = true;
        ice_.take_out(number_of(body), store_);
        loose_[body.index()] = LooseElement();
        forget_contacts(body);
        stale_ = true;
    }

    void put_in(BodyId body, const ElementDefinition& element) override {
        const std::size_t number = body.index();
        IceShape& shape = *shape_of_[number];
        std::destroy_at(&shape);
        std::construct_at(&shape, element.corners, element.half_thickness);
        bodies_[number] = made_of(element, shape, {});
        if (in_system(body)) system_->set_state(number, bodies_[number].start);
        ice_.put_in(number_of(body), contact_element(shape, bodies_[number], element.piece), store_);
        loose_[number] = LooseElement(shape);
        forget_contacts(body);
        stale_ = true;
    }

    void put_in(JointId joint, const JointDefinition& definition) override {
        joints_[joint.index()] = joint_of(definition);
        removed_[joint.index()] = false;
        if (in_system(joint)) joint_in_system_[joint.index()] = not_in_system;  // until it is laid out anew
        hold_edges(joints_[joint.index()], true);
        stale_ = true;
    }

    void apply(BodyId body, const Wrench& wrench) override {
        if (!in_system(body)) lay_out();
        if (const int rail = bodies_[body.index()].parts.rail; rail >= 0) {
            std::array<double, 3> along{};
            along[static_cast<std::size_t>(rail)] = wrench.force[rail];
            system_->add_force(body.index(), along, {});
            return;
        }
        system_->add_force(body.index(), {wrench.force.x(), wrench.force.y(), wrench.force.z()},
                           {wrench.moment.x(), wrench.moment.y(), wrench.moment.z()});
    }

    void step() override {
        if (stale_) lay_out();
        carry_structure();
        find_contacts();
        system_->prepare(definition_.time_step);
        read_contacts();
        sweeps_ = system_->solve(contacts_, definition_.contact, {definition_.iterations, definition_.tolerance});
        write_contacts();
        push_apart();
        system_->advance();
    }

    BodyState state(BodyId body) const override {
        if (bodies_[body.index()].parts.inverse_mass > 0 && in_system(body)) {
            const BodyMotion& motion = system_->motions()[body.index()];
            return body_state(motion.position, motion.rotation, motion.velocity, motion.angular_velocity);
        }
        const SolverState& start = bodies_[body.index()].start;
        return body_state(start.position.data(), start.rotation.data(), start.velocity.data(),
                          start.angular_velocity.data());
    }

    JointReaction reaction(JointId joint) const override {
        if (!in_system(joint)) return {};
        const auto [force, moment] = system_->reaction(joint_in_system_[joint.index()]);
        return {.axial = force[0],
                .shear_vertical = force[1],
                .shear_in_plane = force[2],
                .torsion = moment[0],
                .in_plane_bending = moment[1],
                .bending = moment[2]};
    }

    std::span<const SolverContact> contacts() const override { return contacts_; }
    int sweeps() const override { return sweeps_; }

    void archive(StateArchive& state) override {
        auto& [definition, friction, width, shapes, shape_of, loose, bodies, joints, removed, structure, structure_pose,
               structure_last, store, ice, hull, planes, system, joint_in_system, stale, on_fixed, touching, contacts,
               sources, sweeps] = *this;
        std::vector<bool> is_loose;
        for (const LooseElement& one : loose) is_loose.push_back(one.shape != nullptr);
        state(bodies, joints, removed, structure_pose, structure_last, sweeps, is_loose);
        if (state.sets()) set_shapes(is_loose);
        bool laid_out = system.has_value();
        if (!state.sets() && laid_out && stale) throw RunError("A world can be saved after a step only.");
        state(laid_out);
        if (laid_out) {
            if (state.sets()) {
                system.reset();
                lay_out();
            }
            system->archive(state);
        }
        state(store, ice, touching, contacts, hull, planes);
    }

  private:
    struct Body {
        SolverBody parts;   ///< awake
        SolverState start;  ///< where it was put last; where it is, if nothing moves it
        double friction = 0;
        bool asleep = false;
        std::array<std::uint8_t, most_corners> joints_at{};  ///< how many joints hold others at each edge of a prism
        Outline corners{};                                   ///< of its shape; empty: structure or plane
        double half_thickness = 0;                           ///< likewise
    };

    /// What points of a pair with one normal, from b to a, have in common.
    struct Line {
        Triple normal{};
        bool inside = false;  ///< it leaves a prism where that is covered
        std::array<std::optional<PrismSections>, 2> sections{};
    };

    /// What only elements touch.
    Body& add_without_shape(const Pose& pose) {
        shape_of_.push_back(nullptr);
        Body& made = bodies_.emplace_back();
        made.start = state_at(pose);
        made.parts.crushing_pressure = std::numeric_limits<double>::infinity();  // it does not crush
        ice_.add({.shape = {}, .fixed = true, .piece = sheet_piece});
        loose_.emplace_back();
        hull_.add();
        planes_.add();
        stale_ = true;
        return made;
    }

    Body made_of(const ElementDefinition& element, const IceShape& shape, std::optional<int> rail) const {
        Body made;
        if (element.mass > 0) {
            const double inverse_mass = 1.0 / element.mass;
            made.parts.inverse_mass = inverse_mass;
            made.parts.weight = -definition_.gravity * (1.0 / inverse_mass);
            const btVector3 inertia = shape.inertia(element.mass);
            for (int k = 0; k < 3; ++k) made.parts.inverse_inertia[static_cast<std::size_t>(k)] = 1.0 / inertia[k];
            if (rail) {
                made.parts.rail = *rail;
                made.parts.weight = 0;
                made.parts.inverse_inertia.fill(inverse_mass / (1e3 * off_rail));
            }
        }
        made.parts.half_extent = shape.prism().half_extent;
        made.parts.is_prism = !shape.prism().is_box;
        made.parts.crushing_pressure = element.crushing_pressure;
        made.start = state_at(element.pose);
        made.friction = friction_.ice;
        made.corners = element.corners;
        made.half_thickness = element.half_thickness;
        return made;
    }

    ContactElement contact_element(const IceShape& shape, const Body& body, int piece) const {
        const bool fixed = body.parts.inverse_mass == 0 || body.parts.rail >= 0;
        return {shape.prism(), shape.reach(), fixed, body.parts.rail >= 0 ? no_piece : piece};
    }

    SolverJoint joint_of(const JointDefinition& definition) const {
        const btTransform at = to_bullet(Pose{definition.pivot, definition.frame});
        const auto frame_in = [&](BodyId body) {
            const SolverState state = state_now(body);
            const btTransform frame = transform_of(state.position.data(), state.rotation.data()).inverse() * at;
            return SolverFrame{rows_of(frame.getBasis()), array_of(frame.getOrigin())};
        };
        return {number_of(definition.a), number_of(definition.b), frame_in(definition.a), frame_in(definition.b),
                definition.cfm,          definition.erp,          definition.spring};
    }

    /// The edge on which a joint lies has the joint's x axis as its normal: out of a, and into b.
    void hold_edges(const SolverJoint& joint, bool held) {
        hold_edge(joint.a, joint.in_a, 1, held);
        hold_edge(joint.b, joint.in_b, -1, held);
    }

    void hold_edge(std::uint32_t number, const SolverFrame& frame, double outward, bool held) {
        Body& body = bodies_[number];
        if (!(body.parts.inverse_mass > 0)) return;  // nothing leaves it
        const auto& r = frame.rotation;
        const int edge = edge_towards(ice_.shape(number), {outward * r[0], outward * r[3], outward * r[6]});
        if (edge < 0) return;
        std::uint8_t& joints = body.joints_at[static_cast<std::size_t>(edge)];
        joints = static_cast<std::uint8_t>(joints + (held ? 1 : -1));
    }

    bool cone() const { return definition_.contact.friction == Friction::cone; }

    /// Crushing needs overlap: a point without any exerts nothing. Rigid contacts act before they touch.
    bool acts(double distance) const { return definition_.contact.normal == NormalLaw::rigid || distance < 0; }

    /// A prism is covered where the normal leaves it through an edge at which a joint holds another element of its
    /// floe. Boxes have their sections in the kernels, and those that are awake what covers them, too.
    Line line_of(const Touching& pair, const Triple& normal) const {
        Line line{.normal = normal};
        const bool prisms = bodies_[pair.a].parts.is_prism || bodies_[pair.b].parts.is_prism;
        for (const std::size_t side : {0, 1}) {
            const std::uint32_t number = side == 0 ? pair.a : pair.b;
            const PrismShape& prism = ice_.shape(number);
            if (prism.empty()) continue;  // the structure: flat and unbounded
            const Triple inwards =
                (side == 0 ? 1 : -1) * into({&prism, nullptr, system_->motions()[number].rotation}, normal);
            if (prisms && definition_.contact.normal != NormalLaw::rigid) line.sections[side].emplace(prism, inwards);
            const Body& body = bodies_[number];
            if (definition_.contact.internal_edges || !(body.parts.is_prism || body.asleep)) continue;
            const int edge = edge_towards(prism, -1 * inwards);
            line.inside = line.inside || (edge >= 0 && body.joints_at[static_cast<std::size_t>(edge)] > 0);
        }
        return line;
    }

    /// The smaller of the sections that crush.
    static void set_section(SolverContact& contact, const Line& line) {
        for (const std::optional<PrismSections>& sections : line.sections) {
            if (!sections) continue;
            const PrismSection section = sections->crushed(-contact.distance);
            if (contact.section >= 0 && contact.section <= section.area) continue;
            contact.section = section.area;
            contact.section_growth = section.growth;
        }
    }

    /// How fast two surfaces slide on each other at the beginning of the step, m/s.
    double slip_speed(const Touching& pair, const TouchingPoint& point) const {
        const auto velocity = [&](std::uint32_t number, const Triple& at) {
            const BodyMotion& motion = system_->motions()[number];
            return std::to_array(motion.velocity) +
                   cross(std::to_array(motion.angular_velocity), at - std::to_array(motion.position));
        };
        const Triple sliding = cross(velocity(pair.a, point.on_a) - velocity(pair.b, point.on_b), point.normal);
        return std::sqrt(dot(sliding, sliding));
    }

    /// Coefficient of friction at a point, which remembers how fast it slides.
    double friction_of(const Touching& pair, TouchingPoint& point) const {
        if (planes_.is_plane(pair.a)) return bodies_[pair.a].friction;
        const ContactLaw& law = definition_.contact;
        const SlipLaw slip = slip_law(law, pair.solid >= 0);
        // Friction that does not know the speed is Bullet's product of two materials, to the last bit.
        if (slip.effect == SlipEffect::constant) return bodies_[pair.a].friction * bodies_[pair.b].friction;
        const double speed = slip_speed(pair, point);
        point.remembered_slip = remembered_slip(law.slip, speed, point.remembered_slip, definition_.time_step);
        return friction_coefficient(slip, law.slip, speed, point.remembered_slip);
    }

    bool in_system(JointId joint) const {
        return joint.index() < joint_in_system_.size() && joint_in_system_[joint.index()] != not_in_system;
    }

    bool in_system(BodyId body) const { return system_ && body.index() < system_->body_count(); }
    bool moves(std::uint32_t body) const { return bodies_[body].parts.inverse_mass > 0 && !bodies_[body].asleep; }
    SolverState state_now(BodyId body) const {
        return in_system(body) ? system_->state(body.index()) : bodies_[body.index()].start;
    }
    /// All but those that ice_ forgets by itself.
    void forget_contacts(BodyId body) {
        hull_.move(number_of(body), store_);
        planes_.move(number_of(body), store_);
        std::erase_if(touching_,
                      [&](const Touching& pair) { return pair.a == body.index() || pair.b == body.index(); });
    }

    /// Those of the bodies, where they are not there yet.
    void set_shapes(const std::vector<bool>& is_loose) {
        loose_.resize(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Body& body = bodies_[i];
            if (i >= shape_of_.size()) {
                shape_of_.push_back(&shapes_.emplace_back(body.corners, body.half_thickness));
            } else if (IceShape* shape = shape_of_[i]) {
                std::destroy_at(shape);
                std::construct_at(shape, body.corners, body.half_thickness);
            }
            loose_[i] = is_loose[i] ? LooseElement(*shape_of_[i]) : LooseElement();
        }
    }

    void lay_out() {
        std::vector<SolverBody> bodies;
        for (const Body& body : bodies_) {
            bodies.push_back(body.parts);
            bodies.back().water = {};  // see below
            if (!body.asleep) continue;
            bodies.back() = {};
            bodies.back().half_extent = body.parts.half_extent;
            bodies.back().crushing_pressure = body.parts.crushing_pressure;
            bodies.back().is_prism = body.parts.is_prism;
        }
        std::vector<SolverJoint> awake;
        std::vector<std::size_t> last;  // where they were in the system before
        joint_in_system_.resize(joints_.size(), not_in_system);
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            const std::size_t before = std::exchange(joint_in_system_[i], not_in_system);
            if (bodies_[joints_[i].a].asleep && bodies_[joints_[i].b].asleep) continue;
            joint_in_system_[i] = awake.size();
            awake.push_back(joints_[i]);
            last.push_back(before);
        }
        std::optional<LaneSystem> before = std::move(system_);
        system_.emplace(bodies, awake, width_, definition_.solver);
        const std::size_t known = before ? before->body_count() : 0;
        if (before) system_->take_over(std::move(*before), last);
        for (std::size_t i = known; i < bodies_.size(); ++i) system_->set_state(i, bodies_[i].start);
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            if (removed_[i] && in_system(JointId(i))) system_->remove_joint(joint_in_system_[i]);
        }
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (moves(static_cast<std::uint32_t>(i)) && bodies_[i].parts.water != CarriedWater{})
                system_->set_water(i, bodies_[i].parts.water);
        }
        stale_ = false;
        contacts_.reserve(4 * bodies_.size());
        sources_.reserve(4 * bodies_.size());
        on_fixed_.reserve(4 * bodies_.size());
        touching_.reserve(8 * bodies_.size());
    }

    /// The structure is where it will be at the end of the step, with the velocity that leads there.
    void carry_structure() {
        if (!structure_) return;
        const btTransform before = to_bullet(structure_last_);
        const btTransform after = to_bullet(structure_pose_);
        const Vec3 turn =
            turn_between(structure_last_.orientation, structure_pose_.orientation) / definition_.time_step;
        bodies_[*structure_].start = {array_of(after.getOrigin()),
                                      rows_of(after.getBasis()),
                                      array_of((after.getOrigin() - before.getOrigin()) / definition_.time_step),
                                      {turn.x(), turn.y(), turn.z()}};
        system_->set_state(*structure_, bodies_[*structure_].start);
        structure_last_ = structure_pose_;
    }

    void find_contacts() {
        ice_.find(system_->motions(), store_);
        hull_.find(loose_, system_->motions(), store_);
        planes_.find(loose_, system_->motions(), store_);
        merge(hull_.touching(), planes_.touching(), on_fixed_);
        merge(on_fixed_, ice_.touching(), touching_);
    }

    void read_contacts() {
        contacts_.clear();
        sources_.clear();
        for (const Touching& pair : touching_) read(pair);
    }

    void read(const Touching& pair) {
        // Of the last impulse, for normal rows to start from; cones take the whole of it, or contacts near sliding
        // creep.
        const double kept = cone() ? 1.0 : btContactSolverInfo().m_warmstartingFactor;
        const bool solvable = moves(pair.a) || moves(pair.b);
        TouchingPoints& points = store_[pair.points];
        Line line;
        for (int i = 0; i < points.count(); ++i) {
            TouchingPoint& point = points[i];
            const bool acting = solvable && acts(point.distance);
            if (acting && line.normal != point.normal) line = line_of(pair, point.normal);
            if (!acting || line.inside) {
                if (solvable) point.impulse = 0;
                point.slide = {};
                point.friction_impulse = 0;
                point.remembered_slip = -1;
                continue;
            }
            contacts_.push_back({.a = pair.a,
                                 .b = pair.b,
                                 .on_a = point.on_a,
                                 .on_b = point.on_b,
                                 .normal = point.normal,
                                 .distance = point.distance,
                                 .friction = friction_of(pair, point),
                                 .impulse = point.impulse * kept,
                                 .solid = planes_.is_plane(pair.a) ? -1 : pair.solid});
            set_section(contacts_.back(), line);
            sources_.push_back(&point);
            if (!cone()) continue;
            contacts_.back().slide = point.slide;
            contacts_.back().friction_impulse = point.friction_impulse;
        }
    }

    void write_contacts() {
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            sources_[i]->impulse = contacts_[i].impulse;
            sources_[i]->slide = contacts_[i].slide;
            sources_[i]->friction_impulse = contacts_[i].friction_impulse;
        }
    }

    void push_apart() {
        if (!system_->pushed()) return;
        ice_.distrust();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            std::array<double, 6> push = system_->push(i);
            for (std::size_t k = 0; k < 6 && bodies_[i].parts.rail >= 0; ++k)
                if (k != static_cast<std::size_t>(bodies_[i].parts.rail)) push[k] = 0;
            if (push == std::array<double, 6>{}) continue;
            system_->set_state(i, pushed(system_->state(i), push, definition_.time_step));
            hull_.distrust(static_cast<std::uint32_t>(i));
        }
    }

    WorldDefinition definition_;
    MaterialFriction friction_;
    int width_;
    std::deque<IceShape> shapes_;  ///< of all but the structure; their addresses stay
    std::vector<IceShape*> shape_of_;
    std::vector<LooseElement> loose_;  ///< by body
    std::vector<Body> bodies_;
    std::vector<SolverJoint> joints_;
    std::vector<bool> removed_;
    std::optional<std::uint32_t> structure_;
    Pose structure_pose_;  ///< at the end of the coming step
    Pose structure_last_;  ///< at the end of the last one
    ContactStore store_;
    IceContacts ice_;
    HullContacts hull_;
    PlaneContacts planes_;
    std::optional<LaneSystem> system_;          ///< of the bodies and joints there were when it was laid out
    std::vector<std::size_t> joint_in_system_;  ///< of every joint; not_in_system while its floe sleeps
    bool stale_ = true;                         ///< bodies, joints or who sleeps have changed since then
    std::vector<Touching> on_fixed_;            ///< what touches structure or planes
    std::vector<Touching> touching_;            ///< all that touches, in the order of the solve
    std::vector<SolverContact> contacts_;
    std::vector<TouchingPoint*> sources_;  ///< of the contacts, while they are solved
    int sweeps_ = 0;
};

}  // namespace

std::unique_ptr<Engine> make_lane_engine(const WorldDefinition& definition) {
    return std::make_unique<LaneEngine>(definition);
}

}  // namespace floes
