#pragma once
// What a World keeps behind its door: Bullet's world for the stock solver, our own solver for the others. Only for
// world.cpp, behind world.hpp.

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "world/bullet_settings.hpp"
#include "world/fixed_joint.hpp"
#include "world/froude_units.hpp"
#include "world/kinematic_turn.hpp"
#include "world/lane_solver.hpp"
#include "world/material_friction.hpp"
#include "world/ordered_dynamics_world.hpp"
#include "world/piece_dispatcher.hpp"
#include "world/prism_hull.hpp"
#include "world/rigid_body.hpp"
#include "world/solid_shape.hpp"

namespace floes {

// Everything here, solvers included, is in `units`. Members are destroyed in reverse order: the world before what it
// refers to.
class World::Bullet {
  public:
    explicit Bullet(const WorldDefinition& given)
        : units(given.length_unit), definition(units.to_own(given)), friction(material_friction(given.contact)) {
        set_up(world.getSolverInfo(), definition);
        world.setGravity({0, -definition.gravity, 0});
        world.setForceUpdateAllAabbs(false);  // fixed boxes do not move
        if (definition.solver != SolverKind::stock) {
            world.getDispatchInfo().m_useContinuous = false;  // nothing swept
            lanes.emplace(definition, dispatcher, world.getDispatchInfo());
        }
    }

    ~Bullet() { remove_pairs(broadphase, dispatcher); }

    btRigidBody& body(BodyId id) { return bodies[id.index()]; }
    const btRigidBody& body(BodyId id) const { return bodies[id.index()]; }

    /// Adds any body. Worlds in different threads share one datum, which is never read: Bullet's counter of bodies.
    BodyId add_body(btCollisionShape* shape, double mass, const Pose& pose, double material, int piece, int flags,
                    double crushing_pressure, std::optional<int> rail = {}) {
        const BodyId id(bodies.size());
        btRigidBody& added = bodies.emplace_back(parts_of_body(shape, mass, pose, material, !rail));
        added.setCollisionFlags(added.getCollisionFlags() | flags);
        added.setActivationState(DISABLE_DEACTIVATION);  // floes as slow as the tow would fall asleep
        added.setUserIndex(static_cast<int>(id.index()));
        if (rail) {
            btVector3 along(0, 0, 0);
            along[*rail] = 1;
            added.setLinearFactor(along);
            added.setFlags(BT_DISABLE_WORLD_GRAVITY);
        }
        if (lanes) {
            lanes->add_body(added, piece, crushing_pressure, rail);
        } else {
            world.addRigidBody(&added);
            added.setUserIndex2(piece);
        }
        return id;
    }

    void give_back_shape(BodyId element) {
        const btCollisionShape* shape = body(element).getCollisionShape();
        if (shape->getShapeType() == BOX_SHAPE_PROXYTYPE)
            boxes.give_back(shape);
        else
            hulls.give_back(shape);
    }

    /// A box or a prism under the id of an element that was taken out.
    template <class Definition>
    void make_anew(BodyId element, btCollisionShape* shape, const Definition& of) {
        floes::make_anew(body(element), parts_of_body(shape, of.mass, of.pose, friction.ice, true));
        lanes->put_in(element.index(), body(element), of.piece, of.crushing_pressure);
    }

    FroudeUnits units;
    WorldDefinition definition;
    MaterialFriction friction;
    btDefaultCollisionConfiguration configuration;
    PieceDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver stock;
    BoxShapes boxes;
    PrismHulls hulls;
    std::deque<SolidShape> solids;
    std::optional<btCompoundShape> structure_shape;
    std::deque<btRigidBody> bodies;  // where there are lanes as they were added, apart from those near the structure
    std::optional<BodyId> structure;
    KinematicTurn turn;  // of the structure
    std::size_t joint_count = 0;
    std::vector<std::unique_ptr<FixedJoint>> joints;  // of the stock solver; null once removed
    OrderedDynamicsWorld world{&dispatcher, &broadphase, &stock, &configuration};  // empty where there are lanes
    std::optional<LaneSolver> lanes;                                               // computes the step when present
};

}  // namespace floes
