#pragma once
// Where the work of the tow goes. Forces of a step are multiplied with the mean of the velocities at its beginning and
// its end, which is exactly the work they do in it. Divided by the distance towed, each share is a force, and together
// they are the mean load. Looked at in some steps of the window only: it costs more than a step.

#include <array>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "ice/ice_field.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "simulation/field_water.hpp"
#include "simulation/sheets.hpp"
#include "simulation/structure_motion.hpp"
#include "statistics/work_shares.hpp"
#include "water/water_lanes.hpp"
#include "world/world.hpp"

namespace floes {

class TowWork {
  public:
    TowWork(const Scenario& scenario, const FloeSet& floes, const IceField& ice, BodyId structure);

    /// Other floes have come: `floes` are those at the places of the ice.
    void measure(const FloeSet& floes, const IceField& ice);

    /// Whether the step with this number, from 0, is looked at.
    bool looks_at(int step) const { return step >= first_step_ && (step - first_step_) % stride == 0; }

    /// Before the water of a step that is looked at acts: what each of its terms is. `water` has the states set and the
    /// structure's axis is at x = `structure_x`; all terms are computed last.
    void split_water(WaterLanes& water, double structure_x);

    /// After the step and before joints break: from the states of its beginning and its end, in the order of
    /// ice.elements().
    void add(const World& world, const IceField& ice, const Sheets& sheets, const PieceWater& water,
             const StructureMotion& motion, std::span<const BodyState> before, std::span<const BodyState> after);

    /// Means over the steps looked at, N; of none: zeros.
    WorkShares shares() const;

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    static constexpr int stride = 5;

    Vec3 add_contacts(const World& world, const IceField& ice, const Sheets& sheets, const StructureMotion& motion);
    void add_water();
    void add_motion(const PieceWater& water, std::span<const BodyState> before, std::span<const BodyState> after);

    int first_step_;
    double time_step_;
    double gravity_;
    BodyId structure_;
    double carried_;                                             ///< mass with isotropic added mass / mass of ice
    double speed_;                                               ///< of the straight tow, m/s
    double way_ = 0;                                             ///< sum of the paces of the steps looked at, m/s
    bool paced_;                                                 ///< whether they differ from that speed
    std::vector<double> mass_;                                   ///< by element, with isotropic added mass, kg
    std::vector<double> weight_;                                 ///< by element, N
    std::vector<Vec3> inertia_;                                  ///< by element, principal, kg m²
    std::array<std::vector<Wrench>, water_terms.size()> terms_;  ///< of the water, each by element
    std::vector<Vec3> velocity_, angular_velocity_, position_;   ///< by element, mean over the step
    std::vector<ContactForce> contacts_;
    WorkShares sum_;
    int steps_ = 0;
};

}  // namespace floes
