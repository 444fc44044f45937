#pragma once
// What computes a World: Bullet's own world, or ours. A World checks what it is told, and speaks to its engine in the
// engine's units (FroudeUnits, world.cpp). Only for files inside this module.

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/error.hpp"
#include "shapes/convex_solid.hpp"
#include "solver/carried_water.hpp"
#include "solver/solver_parts.hpp"
#include "world/definitions.hpp"
#include "world/state.hpp"

namespace floes {

/// Bodies and joints are numbered from 0 in the order in which they are added. What an engine does not override its
/// solver refuses (solver/solver_kind.hpp), so that nobody asks for it.
class Engine {
  public:
    Engine() = default;
    virtual ~Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// A body without mass never moves by itself. rail: the world's axis along which alone it moves.
    virtual void add_body(const ElementDefinition& body, std::optional<int> rail) = 0;
    virtual void add_structure(std::span<const ConvexSolid> solids, const Pose& pose) = 0;
    virtual void move_structure(const Pose& pose) = 0;
    virtual void add_plane(const PlaneDefinition&) { refuse(); }

    virtual void add_joint(const JointDefinition& joint) = 0;
    virtual void remove_joint(JointId joint) = 0;
    virtual void set_piece(BodyId body, int piece) = 0;
    virtual void place(BodyId body, const BodyState& state) = 0;

    virtual void soften_joint(JointId, double) { refuse(); }
    virtual void set_water(BodyId, const CarriedWater&) { refuse(); }
    virtual void set_asleep(BodyId, bool) { refuse(); }
    virtual std::vector<BodyId> touched_asleep() const { return {}; }
    virtual void take_out(BodyId) { refuse(); }
    virtual void put_in(BodyId, const ElementDefinition&) { refuse(); }
    virtual void put_in(JointId, const JointDefinition&) { refuse(); }

    virtual void apply(BodyId body, const Wrench& wrench) = 0;
    virtual void step() = 0;

    virtual BodyState state(BodyId body) const = 0;
    virtual JointReaction reaction(JointId joint) const = 0;

    /// What was solved in the last step, with impulses, in the order of the solve.
    virtual std::span<const SolverContact> contacts() const = 0;

    virtual int sweeps() const = 0;

    virtual void archive(StateArchive&) { refuse(); }

  private:
    [[noreturn]] static void refuse() { throw RunError("The world's solver cannot do this."); }
};

/// Coulomb friction in Bullet is the product of the two bodies' material coefficients, so the two coefficients of
/// contact fix the two materials.
struct MaterialFriction {
    double ice = 0;        ///< sqrt(f_ii)
    double structure = 0;  ///< f_is / sqrt(f_ii)
};

/// The material coefficients that give the coefficients of contact of a law that World accepts.
inline MaterialFriction material_friction(const ContactLaw& law) {
    if (law.ice_ice_friction == 0) return {0, 0};
    const double ice = std::sqrt(law.ice_ice_friction);
    return {ice, law.ice_structure_friction / ice};
}

/// Ice sheets that give way and the structure do not touch each other; elements' pieces are numbers of elements.
inline constexpr int sheet_piece = std::numeric_limits<int>::max();

/// Bullet's own world, whole: its joints, contacts and solver.
std::unique_ptr<Engine> make_bullet_engine(const WorldDefinition& definition);

/// Ours: floes side by side (solver/lane_system.hpp).
std::unique_ptr<Engine> make_lane_engine(const WorldDefinition& definition);

}  // namespace floes
