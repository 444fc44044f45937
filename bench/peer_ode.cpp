#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "peer.hpp"

namespace floes::bench {

namespace {

Vec3 vector_of(const dReal* v) {
    return {v[0], v[1], v[2]};
}

class OdePeer final : public Peer {
  public:
    explicit OdePeer(const PeerScene& scene)
        : scene_(scene), water_(peer_water(scene.scenario)), x_(scene.structure_x) {
        const Scenario& scenario = scene.scenario;
        dWorldSetGravity(world_, 0, -scenario.general.gravity, 0);
        dWorldSetQuickStepNumIterations(world_, scenario.general.iterations);
        const double side = scenario.floe.element;
        const double thickness = scenario.floe.thickness;
        dMass mass;
        dMassSetBox(&mass, scenario.ice.density, side, thickness, side);
        for (const BodyState& state : scene.elements) {
            const dBodyID body = dBodyCreate(world_);
            bodies_.push_back(body);
            dBodySetMass(body, &mass);
            dBodySetPosition(body, state.position.x(), state.position.y(), state.position.z());
            const Quat q(state.rotation);
            const dQuaternion turn{q.w(), q.x(), q.y(), q.z()};
            dBodySetQuaternion(body, turn);
            dBodySetLinearVel(body, state.velocity.x(), state.velocity.y(), state.velocity.z());
            dBodySetAngularVel(body, state.angular_velocity.x(), state.angular_velocity.y(),
                               state.angular_velocity.z());
            dGeomSetBody(dCreateBox(space_, side, thickness, side), body);
        }
        for (const PeerJoint& joint : scene.joints) {
            const dJointID fixed = dJointCreateFixed(world_, nullptr);
            dJointAttach(fixed, at(joint.a), at(joint.b));
            dJointSetFixed(fixed);
        }
        for (const auto& [a, b] : scene.diagonals) diagonals_.insert(std::minmax(at(a), at(b)));
        for (const IceSheet& sheet : scene.sheets) {
            const Vec3 sides = 2 * sheet.half_extents;
            const dGeomID box = dCreateBox(space_, sides.x(), sides.y(), sides.z());
            dGeomSetPosition(box, sheet.centre.x(), sheet.centre.y(), sheet.centre.z());
        }
        add_structure();
    }

    ~OdePeer() override {
        dJointGroupDestroy(contact_joints_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }

    OdePeer(const OdePeer&) = delete;
    OdePeer& operator=(const OdePeer&) = delete;

    void step() override {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const dBodyID body = bodies_[i];
            const dReal* r = dBodyGetRotation(body);
            ElementState state{vector_of(dBodyGetPosition(body)), Mat3(), vector_of(dBodyGetLinearVel(body)),
                               vector_of(dBodyGetAngularVel(body)), scene_.exposed_edges[i]};
            state.rotation << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
            const Wrench w = water_.wrench(state, x_);
            dBodyAddForce(body, w.force.x(), w.force.y(), w.force.z());
            dBodyAddTorque(body, w.moment.x(), w.moment.y(), w.moment.z());
        }
        contacts_ = 0;
        dSpaceCollide(space_, this, &OdePeer::touch);
        dRandSetSeed(1);  // QuickStep shuffles its rows
        dWorldQuickStep(world_, scene_.scenario.general.time_step);
        dJointGroupEmpty(contact_joints_);
        x_ = dBodyGetPosition(structure_)[0];
    }

    int contacts() const override { return contacts_; }
    double structure_x() const override { return x_; }

    void set_iterations(int iterations) override { dWorldSetQuickStepNumIterations(world_, iterations); }

    std::vector<Vec3> velocities() const override {
        std::vector<Vec3> found;
        for (const dBodyID body : bodies_) found.push_back(vector_of(dBodyGetLinearVel(body)));
        return found;
    }

  private:
    /// ODE is started once in a process and never ended: the next peer needs it again.
    static dWorldID make_world() {
        static const int started = dInitODE2(0);
        (void)started;
        return dWorldCreate();
    }

    dBodyID at(int i) const { return bodies_[static_cast<std::size_t>(i)]; }

    void add_structure() {
        const double radius = scene_.scenario.structure.shape.waterline_radius();
        structure_ = dBodyCreate(world_);
        dBodySetKinematic(structure_);
        dBodySetPosition(structure_, x_, 0, 0);
        dMatrix3 upright;
        dRFromAxisAndAngle(upright, 1, 0, 0, std::acos(0.0));
        dBodySetRotation(structure_, upright);
        dBodySetLinearVel(structure_, scene_.scenario.structure.speed, 0, 0);
        dGeomSetBody(dCreateCylinder(space_, radius, 0.565), structure_);
    }

    static void touch(void* self, dGeomID a, dGeomID b) { static_cast<OdePeer*>(self)->touch(a, b); }

    void touch(dGeomID geom_a, dGeomID geom_b) {
        const dBodyID a = dGeomGetBody(geom_a);
        const dBodyID b = dGeomGetBody(geom_b);
        if (a == nullptr && b == nullptr) return;
        if (a != nullptr && b != nullptr) {
            if (dAreConnected(a, b) != 0 || diagonals_.contains(std::minmax(a, b))) return;
        }
        std::array<dContact, 8> points;
        const int count = dCollide(geom_a, geom_b, static_cast<int>(points.size()), &points[0].geom, sizeof(dContact));
        const bool structure = a == structure_ || b == structure_;
        for (int i = 0; i < count; ++i) {
            dContact& point = points[static_cast<std::size_t>(i)];
            point.surface = {};
            point.surface.mode = dContactApprox1;
            point.surface.mu =
                structure ? scene_.scenario.contact.ice_structure_friction : scene_.scenario.contact.ice_ice_friction;
            dJointAttach(dJointCreateContact(world_, contact_joints_, &point), a, b);
        }
        contacts_ += count;
    }

    PeerScene scene_;
    WaterModel water_;
    dWorldID world_ = make_world();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    dJointGroupID contact_joints_ = dJointGroupCreate(0);
    std::vector<dBodyID> bodies_;
    std::set<std::pair<dBodyID, dBodyID>> diagonals_;
    dBodyID structure_ = nullptr;
    int contacts_ = 0;
    double x_;
};

}  // namespace

std::unique_ptr<Peer> make_ode(const PeerScene& scene) {
    return std::make_unique<OdePeer>(scene);
}

}  // namespace floes::bench
