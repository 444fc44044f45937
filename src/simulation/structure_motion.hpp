#pragma once
// A structure on its moorings from step to step: M q̈ + C q̇ + K q = F + N(q, q̇), q its offset (shapes/moorings.hpp).
//
// K is the stiffness of moorings and water without an offset, C the linear damping; N is all else: what lines do beyond
// K, thrusters, and the water's quadratic damping. The ice load F of a step is known after it and moves the structure
// in the next one, where it is constant. K, C and F are solved without error: a direction that M, C and K couple with
// no other by statistics/oscillator.hpp, those that are coupled together by the matrix exponential of their equation.
// Quadratic damping and thrusters, which of one direction are also without error, and lines act for half the step
// before and after that (Strang's splitting, second order). So springs and water have no numerical damping and no limit
// of stability; lines and thrusters have that of the leapfrog, period > π Δt, and checks ask for fifty steps.
//
// Turns are small in all but yaw: pitch and roll are about the structure's own axes. M, C and the quadratic damping
// turn with the hull, by whole degrees; forces that depend on how fast they turn (Coriolis and Munk moments of the
// added mass) are left out. At rest the hull lies level at its draught, whatever hangs on it.
//
// The bearing of a turret resists turning by a moment of constant size, which stops the hull and never turns it.
//
// What the splitting from the ice costs: a floe of mass m that strikes the structure, mass M, is stopped as by one that
// does not give way, so the impulse is 1 + m/M times too large (checks ask for M >= 10 m of the heaviest floe). Where
// the blow turns it, M is the mass with which it answers there, 1/M = Jᵀ M⁻¹ J: less, and warnings say so. A floe that
// is pushed along does not feel it.

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "core/vector.hpp"
#include "scenario/scenario.hpp"
#include "shapes/moorings.hpp"
#include "shapes/path.hpp"
#include "simulation/record.hpp"
#include "statistics/oscillator.hpp"

namespace floes {

/// How a moored structure has moved.
struct MooredState {
    Vec6 offset = Vec6::Zero();       ///< by Motion: m, rad
    Vec6 velocity = Vec6::Zero();     ///< m/s, rad/s
    std::vector<double> broken_at{};  ///< s, of each line; NaN: it holds
};

/// Directions that M q̈ + C q̇ + K q = F couples, or one that it does not.
class LinearMotion {
  public:
    /// Of six directions those of these numbers. `damping`: of the critical one of each direction, in addition to C.
    LinearMotion(std::vector<int> directions, const Mat6& inertia, const Mat6& damping, const Mat6& stiffness,
                 double critical, double step);

    void advance(MooredState& state, const Vec6& load) const;
    /// By the force alone for a time, s.
    void accelerate(MooredState& state, const Vec6& force, double time) const;
    /// By -b |v| v alone for a time, s: m v' = -b |v| v of one direction without error.
    void slow_down(MooredState& state, const std::array<double, 6>& quadratic, double time) const;
    /// That of a direction under a force alone, m/s² or rad/s²; 0 of directions that are not of these.
    double acceleration(Motion motion, const Vec6& force) const;

  private:
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 18, 18>;  // on the stack

    std::vector<int> directions_;
    Matrix inertia_;
    Matrix inverse_;  // of it
    std::optional<OscillatorStep> alone_;
    Matrix step_;  // of offsets, velocities and load to offsets and velocities; unless alone
};

class MooredMotion {
  public:
    /// At rest without an offset. `moorings` give way and hold in all their directions; `water`: its stiffness
    /// (shapes/hydrostatics.hpp); `step`: s.
    MooredMotion(const Moorings& moorings, const Mat6& water, double step);

    const MooredState& state() const { return state_; }
    void place(const MooredState& state);

    /// A step that ends at `time` s, under a load that is constant in it, by Motion: N, N m.
    void advance(const Vec6& load, double time);

    /// Force of springs, lines and turret at the offset, on the structure, in surge, sway and yaw: N, N, N m.
    Vec3 restoring() const { return pull_of_lines().head<3>() - springs_.cwiseProduct(state_.offset.head<3>()); }

    /// Force of the thrusters, on the structure and in its own axes, ahead and towards +z without yaw: N, N, N m.
    Vec3 thrust() const;
    bool has_thrusters() const { return moorings_.thrusters.any(); }
    bool floats() const { return moorings_.floats(); }

    /// What a line pulls with; nothing where it has broken.
    std::optional<LinePull> line(std::size_t number) const;
    std::size_t lines() const { return moorings_.line_count(); }
    /// Whether a line may break.
    bool breaks() const { return breaks_; }

    /// The largest pull of each line so far, N.
    const std::vector<double>& largest_tensions() const { return largest_; }

    /// The largest pull over its break load at the end of the last step, of the lines that held until then and break at
    /// all; 0 where there are none.
    double line_use() const { return line_use_; }

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    std::vector<LinearMotion> linear_at(double heading) const;
    const std::vector<LinearMotion>& at_this_heading();
    void slow_down(double time);
    void hold();
    Vec6 friction(const Vec6& load);
    void push_back(double time);
    Vec3 in_own_axes(const Vec3& plane, double sense) const;
    void pull_beyond_linear(double time);
    void look_at_lines();
    Vec6 pull_of_lines() const;
    void break_lines(double time);

    Moorings moorings_;
    double step_;
    Vec3 inertia_ = Vec3::Zero();  ///< that a thrust along surge, sway or yaw meets, with all that moves along
    Vec3 springs_;
    Mat6 water_, stiffness_;
    bool round_;  ///< whether inertia and radiation damping are the same at all headings
    std::map<int, std::vector<LinearMotion>> linear_;  ///< by heading in whole degrees
    std::vector<ThrustLaw> thrusters_;                 ///< of surge, sway and yaw, none where it is held
    MooredState state_;
    Vec6 beyond_ = Vec6::Zero();   ///< what lines and turret pulled beyond the linear stiffness when last asked
    std::vector<LinePull> pulls_;  ///< of all lines at the offset, broken ones too
    std::vector<Vec6> level_;      ///< what they pull down and turn at rest, against which the hull lies level
    std::vector<double> largest_;
    bool breaks_;
    double line_use_ = 0;
};

/// What others do to the hull in a step, beside the ice. By default nothing.
struct FromOutside {
    /// On a hull that gives way, constant in the step: in the world's axes and about its reference point.
    Wrench load{};
    /// At the end of the step, of a hull that others lead: from where tow or path have it, by Motion, m and rad.
    Vec6 offset = Vec6::Zero();
};

// Where the structure is from step to step: on the straight tow, on its path, and beside these on its moorings, or
// where others lead it.

class StructureMotion {
  public:
    explicit StructureMotion(const Scenario& scenario);

    /// Begins a step: after() is where the structure is at its end. `ice`: its load in the step before, in the world's
    /// axes and about the reference point; only moorings ask for it.
    void advance(const Wrench& ice, const FromOutside& outside = {});

    /// At the start, without moorings: from now on others lead it, from this offset on.
    void lead(const Vec6& offset);

    /// As after `steps` steps, with the moorings in this state.
    void place(int steps, const MooredState& moored);

    const StructurePose& before() const { return before_; }  ///< at the beginning of the step
    const StructurePose& after() const { return after_; }    ///< at its end

    /// Of the reference point in the step, m/s; at the start that of the tow or path alone.
    const Vec3& velocity() const { return velocity_; }
    /// Likewise, rad/s, in the world's axes.
    const Vec3& angular_velocity() const { return angular_velocity_; }

    /// Likewise of what it is towed by, moorings or not; the rest of its velocities is how it gives way.
    const Vec3& towed() const { return towed_; }
    const Vec3& towed_turning() const { return towed_turning_; }

    /// How fast what it is towed by goes in the step, m/s.
    double pace() const { return pace_; }

    /// Whether it moves other than the straight tow.
    bool is_free() const { return !straight_ || led_; }

    /// Whether it may be elsewhere than tow or path have it: on its moorings, or where others lead it.
    bool gives_way() const { return moored_ || led_; }
    /// From there, by Motion, at after().
    const Vec6& offset() const { return moored_ ? moored_->state().offset : led_offset_; }

    /// Mooring lines that hold, at after(). The vector keeps its memory.
    void read_lines(std::vector<FrameLine>& lines) const;

    const std::optional<MooredMotion>& moored() const { return moored_; }
    MooredState moored_state() const { return moored_ ? moored_->state() : MooredState{}; }

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    PathPlace prescribed(int step) const;
    void follow(const PathPlace& place);
    Vec6 on_motions(const Wrench& load) const;
    void add(const Vec6& offset);

    double time_step_;
    Tow tow_;
    bool straight_;
    std::vector<PathPlace> places_;
    std::optional<MooredMotion> moored_;
    bool led_ = false;  ///< others lead it
    Vec6 led_offset_ = Vec6::Zero();
    int step_ = 0;
    StructurePose before_, after_;
    Vec3 velocity_ = Vec3::Zero();
    Vec3 angular_velocity_ = Vec3::Zero();
    Vec3 towed_ = Vec3::Zero();
    Vec3 towed_turning_ = Vec3::Zero();
    double pace_ = 0;
};

}  // namespace floes
