#pragma once
// A World's step without Bullet's world: boxes meet boxes (collision/box_contacts.hpp), Bullet finds where they meet
// the structure (world/structure_contacts.hpp), and our solver does the rest (solver/lane_system.hpp). It alone knows
// where bodies are and how they move; Bullet's bodies are what it was told about them. Only for files inside this
// module.

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "collision/box_contacts.hpp"
#include "shapes/elements.hpp"
#include "solver/lane_system.hpp"
#include "world/definitions.hpp"
#include "world/state.hpp"
#include "world/structure_contacts.hpp"

namespace floes {

class LaneSolver {
  public:
    /// definition: lanes: floes side by side at most, one of lane_widths(); 0: as many as the processor has.
    LaneSolver(const WorldDefinition& definition, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);

    /// Bodies are numbered from 0 in the order in which they are added. crushing_pressure: Pa; 0: that of the law.
    /// rail: axis along which alone the body moves.
    void add_body(const btRigidBody& body, int piece, double crushing_pressure, std::optional<int> rail);

    /// The body that is moved from outside, by number.
    void set_structure(std::size_t body, const btCompoundShape& solids) {
        structure_ = body;
        structure_contacts_.set_solids(solids);
    }

    /// Water that the body carries from the next step on; with the direct solver only.
    void set_water(std::size_t body, const CarriedWater& water);

    /// Joints are numbered from 0 in the order in which they are added, and solved in that order within a floe.
    void add_joint(const JointDefinition& definition, const btRigidBody& a, const btRigidBody& b);
    void remove_joint(std::size_t joint);

    /// From the next step on; with the direct solver only.
    void soften_joint(std::size_t joint, double sound);

    /// From the next step on.
    void set_piece(std::size_t body, int piece) { boxes_.set_piece(static_cast<std::uint32_t>(body), piece); }

    /// From the next step on. Bodies that sleep are fixed in place, and their joints are left out.
    void set_asleep(std::size_t body, bool asleep);

    /// From the next step on the body, an element without joints, touches nothing and is not computed.
    void take_out(std::size_t body);

    /// Another element, or joint, under the number of one that was taken out, or removed.
    void put_in(std::size_t number, const btRigidBody& body, int piece, double crushing_pressure);
    void put_in_joint(std::size_t number, const JointDefinition& definition, const btRigidBody& a,
                      const btRigidBody& b);

    /// Sleeping bodies that an awake one or the structure touched in the last step, in the order of the contacts.
    std::vector<BodyId> touched_asleep() const;

    /// Tells the solver a pose and velocity of the body that it did not compute itself; contacts begin anew.
    void place(std::size_t body, const SolverState& state);

    /// Adds up until the coming step; the moment is about the centre of mass.
    void apply(std::size_t body, const Wrench& wrench);

    /// One step of all bodies; the structure's is where it is at the end of it.
    void step(std::deque<btRigidBody>& bodies);

    /// Whether something can move the body, which then is where state() and motion() say.
    bool is_free(std::size_t body) const { return free_[body] != 0; }
    BodyState state(std::size_t body) const;

    /// The same; none before the first step, and for a body added since.
    const BodyMotion* motion(std::size_t body) const {
        return in_system_body(body) ? system_->motions() + body : nullptr;
    }

    /// From the last step; zero before it and after removal.
    JointReaction reaction(std::size_t joint) const;

    /// What was solved in the last step, with impulses, in the order of the solve.
    std::span<const SolverContact> contacts() const { return contacts_; }

    /// In the last step.
    int sweeps() const { return sweeps_; }

  private:
    struct Body {
        SolverBody parts;  ///< awake
        SolverState start;
        double friction = 0;
        bool asleep = false;
        PrismShape prism{};                                  ///< empty of any other body
        std::array<std::uint8_t, most_corners> joints_at{};  ///< of a prism: how many joints hold others at each edge
    };

    /// Where a contact of the solve came from: a point of two boxes, or one of Bullet's with the structure.
    struct Source {
        TouchingPoint* box;
        btManifoldPoint* structure;
    };

    Body made_of(const btRigidBody& body, double crushing_pressure, std::optional<int> rail) const;
    bool cone() const { return definition_.contact.friction == Friction::cone; }
    bool acts(double distance) const;
    bool is_prism(std::uint32_t body) const { return bodies_[body].parts.is_prism; }
    bool is_inside(std::uint32_t a, std::uint32_t b, const Triple& normal) const;
    void set_section(SolverContact& contact) const;
    void hold_edge(std::uint32_t body, const SolverFrame& frame, double outward, bool held);
    bool in_system(std::size_t joint) const;
    bool in_system_body(std::size_t body) const { return system_ && body < system_->body_count(); }
    bool moves(std::uint32_t body) const { return bodies_[body].parts.inverse_mass > 0 && !bodies_[body].asleep; }
    void lay_out();
    template <class Self, class Visit>
    static void for_each_touching(Self& self, const Visit& visit);
    void read_contacts();
    void read(std::uint32_t a, std::uint32_t b, bool solvable, TouchingPoints& points);
    void read(std::uint32_t a, std::uint32_t b, bool solvable, btPersistentManifold& manifold);
    void write_contacts();
    void push_apart();

    WorldDefinition definition_;
    int width_;
    std::vector<Body> bodies_;
    std::vector<std::uint8_t> free_;
    std::vector<SolverJoint> joints_;
    std::vector<bool> removed_;
    std::optional<std::size_t> structure_;
    BoxContacts boxes_;
    StructureContacts structure_contacts_;
    std::optional<LaneSystem> system_;          ///< of the bodies and joints there were when it was laid out
    std::vector<std::size_t> joint_in_system_;  ///< of every joint; not_in_system while its floe sleeps
    bool stale_ = true;                         ///< bodies, joints or who sleeps have changed since then
    std::vector<SolverContact> contacts_;
    std::vector<SolverContact> last_;  ///< of the solve before, for the friction of the structure's points
    int sweeps_ = 0;
    std::vector<Source> sources_;  ///< of the contacts, while they are solved
};

/// Calls visit(a, b, points) for every two bodies with points, rising by (a, b): the order of the solve.
template <class Self, class Visit>
void LaneSolver::for_each_touching(Self& self, const Visit& visit) {
    const std::span<btPersistentManifold* const> structure = self.structure_contacts_.touching();
    auto next = structure.begin();
    const auto visit_structure = [&](std::pair<std::uint32_t, std::uint32_t> before) {
        for (; next != structure.end(); ++next) {
            const auto a = static_cast<std::uint32_t>((*next)->getBody0()->getUserIndex());
            const auto b = static_cast<std::uint32_t>((*next)->getBody1()->getUserIndex());
            if (std::pair(a, b) >= before) return;
            visit(a, b, **next);
        }
    };
    for (const BoxContacts::Pair& pair : self.boxes_.touching()) {
        visit_structure({pair.a, pair.b});
        visit(pair.a, pair.b, self.boxes_.points(pair));
    }
    visit_structure({~0U, ~0U});
}

}  // namespace floes
