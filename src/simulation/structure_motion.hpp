#pragma once
// Where the structure is from step to step: on the straight tow, on its path, and beside these on its moorings.

#include <optional>
#include <vector>

#include "core/vector.hpp"
#include "scenario/scenario.hpp"
#include "simulation/frame.hpp"
#include "simulation/moored_motion.hpp"
#include "structure/tow.hpp"

namespace floes {

class StructureMotion {
  public:
    explicit StructureMotion(const Scenario& scenario);

    /// Begins a step: after() is where the structure is at its end. `load`: of the ice in the step before, N, N and N m
    /// about the axis; only moorings ask for it.
    void advance(const Vec3& load);

    /// As after `steps` steps, with the moorings in this state.
    void place(int steps, const MooredState& moored);

    const PlanarPose& before() const { return before_; }  ///< at the beginning of the step
    const PlanarPose& after() const { return after_; }    ///< at its end

    /// In the step, m/s; at the start that of the tow or path alone.
    const Vec3& velocity() const { return velocity_; }
    double turning() const { return turning_; }  ///< rad/s about +y

    /// How fast what it is towed by goes in the step, m/s.
    double pace() const { return pace_; }

    /// Whether it moves other than the straight tow.
    bool is_free() const { return !straight_; }

    /// A vector in the world's axes as ahead, up and across in the structure's at after(); towards +z without yaw.
    Vec3 in_own_axes(const Vec3& vector) const;

    /// Mooring lines that hold, at after(). The vector keeps its memory.
    void read_lines(std::vector<FrameLine>& lines) const;

    const std::optional<MooredMotion>& moored() const { return moored_; }
    MooredState moored_state() const { return moored_ ? moored_->state() : MooredState{}; }

  private:
    PathPlace prescribed(int step) const;
    void follow(const PathPlace& place);
    void add_offset();

    double time_step_;
    Tow tow_;
    bool straight_;
    std::vector<PathPlace> places_;
    std::optional<MooredMotion> moored_;
    int step_ = 0;
    PlanarPose before_, after_;
    Vec3 velocity_ = Vec3::Zero();
    double turning_ = 0;
    double pace_ = 0;
};

}  // namespace floes
