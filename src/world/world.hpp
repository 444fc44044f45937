#pragma once
// The rigid-body world, the only door to Bullet. Two engines compute it, Bullet's own and ours (world/engine.hpp). One
// step reads:
//
//   world.move_structure(pose at the end of the step);
//   world.apply(body, wrench);             // as often as needed, adds up
//   world.step();
//   world.state(body); world.reaction(joint); world.contact_force(body);
//   world.remove_joint(joint); world.set_piece(body, piece);   // in force from the next step on
//
// A World gives the same bits whatever ran before it, in this thread or another: it sorts what it solves by the ids of
// its bodies and by the order of its joints. Different Worlds may be used in different threads at the same time.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shapes/convex_solid.hpp"
#include "solver/carried_water.hpp"
#include "world/definitions.hpp"
#include "world/state.hpp"

namespace floes {

class World {
  public:
    /// Throws InputError when a value is outside the range that its field states; so do the add_ functions.
    explicit World(const WorldDefinition& definition);
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    BodyId add_element(const ElementDefinition& element);
    BodyId add_fixed_box(const FixedBoxDefinition& box);
    BodyId add_sliding_box(const SlidingBoxDefinition& box);

    /// The structure: convex solids in its own axes, together not necessarily convex. Driven by move_structure, never
    /// pushed back. At most one in a World.
    BodyId add_structure(std::span<const ConvexSolid> solids, const Pose& pose);

    /// Elements alone touch it. Throws InputError with the stock solver.
    BodyId add_plane(const PlaneDefinition& plane);

    /// Joints are solved in the order in which they are added.
    JointId add_joint(const JointDefinition& joint);

    /// Removes the joint; the order of the others stays. Its reaction reads zero from then on.
    void remove_joint(JointId joint);

    /// A joint that cracks: from the next step on it has this share of the stiffness with which it was made against
    /// bending and torsion. Throws InputError with other solvers than direct, and unless 0 < sound <= 1.
    void soften_joint(JointId joint, double sound);

    /// Bodies of the same piece >= 0 do not collide; no_piece for none. In force from the next step on.
    void set_piece(BodyId body, int piece);

    /// Water that moves with an element from the next step on; none at first. Throws InputError with other solvers than
    /// direct, and for a value that is negative or not finite where that makes no sense.
    void set_water(BodyId body, const CarriedWater& water);

    /// Puts a body into a state that it does not come to by itself. Contacts that it had begin anew; joints pull
    /// towards the configuration in which they were made.
    void place(BodyId body, const BodyState& state);

    /// A sleeping body stays exactly where it is put and is fixed to whoever touches it, and costs next to nothing.
    /// With the direct solver others may be joined to it; else all bodies that joints connect sleep or none. Throws
    /// InputError with the stock solver.
    void set_asleep(BodyId body, bool asleep);

    /// Takes an element out of the world: from now on it touches nothing and costs next to nothing. Its joints must
    /// have been removed. Throws InputError with the stock solver.
    void take_out(BodyId element);

    /// Another element under the id of one that was taken out; it carries no water yet.
    void put_in(BodyId element, const ElementDefinition& definition);

    /// Another joint under the id of one that was removed. Throws InputError as add_joint does.
    void put_in(JointId joint, const JointDefinition& definition);

    /// Sleeping bodies that the structure or an awake element touched in the last step (nearer than a contact point
    /// lives, some millimetres for elements of 0.2 m), in the order of the contacts; a body may come more than once.
    std::vector<BodyId> touched_asleep() const;

    /// Where the structure is at the end of the coming step, with the solids' axes turned by the orientation. Its
    /// velocities in that step are the differences over Δt.
    void move_structure(const Pose& pose);

    /// Adds a force at the centre of mass and a moment (world axes, N, N m) for the coming step only.
    void apply(BodyId body, const Wrench& wrench);

    /// Advances by one time step.
    void step();

    BodyState state(BodyId body) const;

    /// Sweeps that the last step took; with a tolerance fewer than the definition's iterations.
    int sweeps() const;

    /// From the last step; zero before the first one and after removal.
    JointReaction reaction(JointId joint) const;

    /// Force of all contacts (normal and friction) on the body in the last step, world axes, N.
    Vec3 contact_force(BodyId body) const;

    /// Refills `found` with every contact that exerted a force in the last step, or with those of one body, in the
    /// order of the solve. Points are those that the step began with.
    void read_contacts(std::vector<ContactForce>& found, std::optional<BodyId> of = {}) const;

    /// Everything that its next steps depend on, saved or set (core/state_archive.hpp); between two steps, or where no
    /// step was made. The world that is set began like this one. Throws RunError where saves_state(solver) is false.
    void archive(StateArchive& state);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace floes
