#pragma once
// What another engine needs to step the same scene: bodies, joints that still hold, fixed boxes, the structure.

#include <memory>
#include <utility>
#include <vector>

#include "scene.hpp"
#include "shapes/convex_solid.hpp"
#include "simulation/sheets.hpp"
#include "water/water_model.hpp"
#include "world/engine.hpp"
#include "world/state.hpp"

namespace floes::bench {

struct PeerJoint {
    int a = 0;
    int b = 0;
    Pose in_a;  ///< joint -> element a
    Pose in_b;
};

struct PeerScene {
    Scenario scenario;
    std::vector<BodyState> elements;
    std::vector<std::uint8_t> exposed_edges;
    std::vector<PeerJoint> joints;
    std::vector<std::pair<int, int>> diagonals;  ///< elements of one piece that meet at a corner only
    std::vector<IceSheet> sheets;
    std::vector<ConvexSolid> structure;
    double structure_x = 0;
    MaterialFriction friction;
};

PeerScene peer_scene(const Scene& scene);

/// The default scenario's water.
WaterModel peer_water(const Scenario& scenario);

/// An engine with the scene in it. One step: structure moved, water on every element, iterations as the scenario has
/// them. No joint breaks and no joint reaction is read.
class Peer {
  public:
    virtual ~Peer() = default;
    virtual void step() = 0;
    virtual void set_iterations(int iterations) = 0;  ///< of the coming steps
    virtual int contacts() const = 0;                 ///< points of the last step
    virtual double structure_x() const = 0;
    virtual std::vector<Vec3> velocities() const = 0;  ///< of the elements, m/s
};

/// Bullet as its users write it: btDiscreteDynamicsWorld, btFixedConstraint, a hull for the structure.
std::unique_ptr<Peer> make_bullet(const PeerScene& scene);

/// ODE: dWorldQuickStep, fixed joints, boxes, an upright cylinder for the structure. ODE has no cone.
std::unique_ptr<Peer> make_ode(const PeerScene& scene);

}  // namespace floes::bench
