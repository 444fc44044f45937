#pragma once
// One tow through one arrangement: the step loop and the record of it.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "ice/failure_mode.hpp"
#include "ice/ice_field.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "simulation/field_water.hpp"
#include "simulation/hull_loads.hpp"
#include "simulation/lee.hpp"
#include "simulation/moving_window.hpp"
#include "simulation/nearby_ice.hpp"
#include "simulation/record.hpp"
#include "simulation/sheets.hpp"
#include "simulation/structure_motion.hpp"
#include "simulation/tow_work.hpp"
#include "solver/solver_kind.hpp"
#include "statistics/load_map.hpp"
#include "water/water_lanes.hpp"
#include "world/state.hpp"
#include "world/world.hpp"

namespace floes {

// Which floes were computed, and which of them touched the structure: what counts of broken floes are relative to.

class Encounters {
  public:
    /// Floes from now on computed.
    void enter(int floes) { entered_ += floes; }

    /// After a step: contacts of the structure in it. Allocates nothing unless the ice has a place more.
    void meet(std::span<const ContactForce> contacts, const IceField& ice);

    /// Before the floe at this place leaves the ice.
    void leave(int place, const IceField& ice);

    int entered() const { return entered_; }
    int met(const IceField& ice) const;         ///< that touched the structure
    int met_broken(const IceField& ice) const;  ///< of these, with a failed joint

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    bool has_met(int place) const;

    int entered_ = 0;
    int left_met_ = 0, left_broken_ = 0;  // of floes that have left
    std::vector<std::uint8_t> met_;       // by place
};

// Is a run still a simulation of floating ice? Elements that explode, leave the channel, fly or sink say it is not;
// then the member fails with a reason and gives no numbers.

/// Where and how fast an element may be. m, m/s.
struct Wellbeing {
    double speed = 0;       ///< largest |velocity| of the centre of mass
    double begin = 0;       ///< least x: the channel's room before the wall sheets
    double end = 0;         ///< largest x: as far past them
    double outer_edge = 0;  ///< largest |z|: the outer edge of a wall sheet
    double top = 0;         ///< largest height: the same above the structure
    double bottom = 0;      ///< least height: the same below the structure

    Wellbeing(const Scenario& scenario, const Channel& channel);

    /// What is wrong with an element in this state ("has run away at 12 m/s ..."); nothing if it is well. NaN is not
    /// well.
    std::optional<std::string> trouble(const BodyState& state) const;
};

//   Simulation simulation(scenario, arrangement);
//   if (simulation.run(stop)) use(simulation.loads(), simulation.ice());   // throws MemberFailure when the run leaves
//   all sense
//
// After construction nothing in the loop allocates on this side of the world: histories and contacts are reserved.
// Where floes of a field without end come and leave, and the solver is laid out anew, it does.

struct SimulationState {
    int steps = 0;                    ///< completed
    std::vector<BodyState> elements;  ///< at their end, in the order of IceField::elements()
    std::vector<BreakEvent> breaks;   ///< so far, by time
    std::vector<SheetMotion> sheets;  ///< of ice sheets that give way; none: they are where they start
    MooredState moored{};             ///< of a structure that gives way
};

class Simulation;

/// Looks at a run at its start and after each step; the run does not depend on it.
using Watcher = std::function<void(const Simulation&)>;

class Simulation {
  public:
    /// Floes float at rest at their poses. Throws InputError for what the world refuses.
    /// ahead: of a field without end, where it goes on beyond these floes.
    Simulation(const Scenario& scenario, const FloeSet& floes, IceAhead ahead = {});

    /// A tow that has come as far as `state`: floes as in `floes` when their joints were made, then moved. The
    /// contacts of the last step and cracks that are not open yet are not part of a state, so the next steps differ
    /// from those of the run that it comes from as far as these matter. The histories begin with NaN for the steps that
    /// are not known here, peaks anew. Throws InputError when the state is of other floes.
    Simulation(const Scenario& scenario, const FloeSet& floes, const SimulationState& state);

    /// One time step. Throws MemberFailure, with the element, its floe and the time, when an element runs away, is gone
    /// or is no longer a number; the histories then end with the step before.
    void step(const FromOutside& outside = {});

    /// Before the first step, and before set(): others lead a hull without moorings from now on. It begins at this
    /// offset from where tow or path have it (by Motion, m and rad), and each step is told the next one.
    void lead_hull(const Vec6& offset);

    /// Steps to the end of the analysis window. False if `stop` was requested before that.
    bool run(const std::stop_token& stop, const Watcher& watch = {});

    double time() const { return steps_ * scenario_.general.time_step; }  ///< s, of the last completed step's end
    int steps() const { return steps_; }
    /// Sweeps of the solver a step, on average over all steps so far; at least one step.
    double mean_sweeps() const { return static_cast<double>(sweeps_) / static_cast<double>(swept_steps_); }
    const LoadHistory& loads() const { return loads_; }
    const BedHistory& bed_loads() const { return bed_loads_; }
    const MotionHistory& motions() const { return motions_; }
    const StructureMotion& structure() const { return motion_; }
    /// Of the ice on the hull in the last step: in the world's axes and about its reference point at the step's end.
    const Wrench& ice_load() const { return ice_load_; }
    const IceField& ice() const { return ice_; }  ///< breaks, broken floes, peak reactions
    /// Of level ice on what holds it, in the last step, N along the world's axes.
    Vec3 force_on_supports() const { return ice_.force_on_supports(world_); }

    /// Floes that were computed at any time so far: all of a field with an end.
    int floes_entered() const { return encounters_.entered(); }
    int floes_met() const { return encounters_.met(ice_); }  ///< that touched the structure so far
    int floes_met_broken() const { return encounters_.met_broken(ice_); }
    /// Floes of a field without end that rest ahead of what is computed.
    int floes_resting() const { return window_ ? sleeping_.resting() : 0; }

    /// In a field without end, what was laid at a place of the ice.
    const SingleFloe& laid(int place) const { return window_.value().places().at(static_cast<std::size_t>(place)); }

    /// Where on the structure the load acted, over the steps of the analysis window so far; at least one.
    LoadMap load_map() const { return contact_bins_.means(static_cast<std::size_t>(steps_in_window_)); }

    /// On parts of the structure, and moments, over the steps of the analysis window so far; at least one.
    const HullLoads& hull_loads() const { return hull_loads_; }

    /// What of the ice has gone astern of the structure in the analysis window so far, less what has come back.
    IceAmount fallen_astern() const { return astern() - astern_before_; }

    /// Where the work of the tow went in the analysis window so far.
    WorkShares work() const { return work_.shares(); }

    SimulationState state() const {
        return {steps_, states_, ice_.breaks(), sheets_.motions(), motion_.moored_state()};
    }

    /// Whether saved() can be called: the engine `stock` keeps much of its state to itself.
    bool can_be_saved() const { return saves_state(scenario_.general.solver); }

    /// The whole run so far, after any step: set() gives it to another simulation of the same scenario and floes, made
    /// by the same program, whose steps then have the same bits as those that would follow here.
    Bytes saved() const;

    /// To be called before the first step. Throws RunError for bytes that are not of such a run; the simulation is then
    /// of no use.
    void set(std::span<const std::byte> saved);

    /// Refills `frame` with what there is to see at time(). Vectors keep their memory.
    void read_frame(Frame& frame) const;

    /// Motion of every element at time(), in the order of ice().elements().
    const std::vector<BodyState>& element_states() const { return states_; }

    /// How the ice sheets have moved that give way, in the order of the channel's sheets.
    const std::vector<SheetMotion>& sheets() const { return sheets_.motions(); }

  private:
    void archive(StateArchive& state);
    FrameContact seen(const ContactForce& contact) const;
    double step_end() const { return (steps_ + 1) * scenario_.general.time_step; }
    void place_structure();
    void move_structure(const FromOutside& outside);
    void hold_edges(const FloeSet& floes);
    void start_window(const FloeSet& floes, IceAhead ahead);
    double pushed() const;
    void push_resting();
    void push(int place);
    void move_window();
    void check_way_back() const;
    void leave_behind();
    bool enter_ahead();
    FieldPart next_part();
    void measure_places();
    void wake_floes();
    void apply_water();
    void drift_from_start();
    void read_states();
    void check_wellbeing() const;
    void read_ice_load();
    void map_contacts();
    IceAmount astern() const;
    void break_joints();
    void share_out_water(std::size_t first_break);
    void record();
    void record_bed();
    void record_motion();

    Scenario scenario_;
    Channel channel_;
    Wellbeing wellbeing_;
    StructureMotion motion_;
    HullLoads hull_loads_;
    World world_;
    BodyId structure_;
    std::optional<BodyId> bed_;
    IceField ice_;
    Sheets sheets_;
    WaterLanes water_;
    PieceWater piece_water_;
    Lee lee_;
    TowWork work_;
    NearbyIce nearby_;
    IceAmount left_;           ///< floes that have left, all of them astern
    IceAmount astern_before_;  ///< at the start of the window
    std::vector<BodyState> states_, states_before_;
    SleepingFloes sleeping_;
    std::optional<MovingWindow> window_;  ///< of a field without end
    Encounters encounters_;
    Wrench ice_load_;  ///< of the last step, in the world's axes and about the structure's reference point
    LoadHistory loads_;
    BedHistory bed_loads_;
    MotionHistory motions_;
    std::vector<ContactForce> structure_contacts_;  ///< of the last step
    std::vector<ContactForce> bed_contacts_;        ///< likewise
    ContactBins contact_bins_;
    int steps_in_window_ = 0;
    std::int64_t sweeps_ = 0;
    int swept_steps_ = 0;
    int steps_ = 0;
};

}  // namespace floes
