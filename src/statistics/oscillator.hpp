#pragma once
// A mass on a spring and a damper under a load that is known beforehand: a hull on its moorings, in one direction.
//
//   m ẍ + c ẋ + k x = F(t),   ω² = k / m,   c = 2 ζ m ω
//
// A stored load is a mean over each interval, so F is taken as constant there, which keeps its impulse. Then y = x -
// F/k moves freely, and the state at the end of an interval of length h follows from that at its beginning without
// error:
//
//   y' = e^(-ζωh) ( (cos ω_d h + ζω s) y + s v ),   v' = e^(-ζωh) ( -ω² s y + (cos ω_d h - ζω s) v ),
//   s = sin(ω_d h) / ω_d,   ω_d = ω √(1 - ζ²)
//
// (free motion of a damped mass from y and v). There is no time step to choose and no numerical damping.

#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "statistics/load_statistics.hpp"

namespace floes {

struct Oscillator {
    double stiffness = 0;      ///< k, N/m, >= 0; 0: a free mass, of which no damping is the critical one: it has none
    double mass = 0;           ///< m, kg, > 0; of a floating hull with its added mass
    double damping_ratio = 0;  ///< ζ, c over the critical one, in [0, 1)

    double angular_frequency() const { return std::sqrt(stiffness / mass); }  ///< ω, rad/s
    /// 2π/ω, s: the natural period without damping; infinite of a free mass.
    double period() const { return 2 * std::numbers::pi / angular_frequency(); }
    double damping() const { return 2 * damping_ratio * mass * angular_frequency(); }  ///< c, N s/m
    /// ζω, 1/s: free motion falls as e^(-ζωt).
    double decay_rate() const { return damping_ratio * angular_frequency(); }
};

struct OscillatorState {
    double offset = 0;    ///< x, m, positive along the load
    double velocity = 0;  ///< ẋ, m/s
};

/// What an interval of `step` s makes of a state under a constant load. Throws ContractError as motion_under().
class OscillatorStep {
  public:
    OscillatorStep(const Oscillator& oscillator, double step);

    /// The state at the end of the interval; load: N.
    OscillatorState after(const OscillatorState& before, double load) const {
        if (stiffness_ == 0) {
            const double faster = load * velocity_of_load_;
            return {before.offset + offset_of_velocity_ * (before.velocity + 0.5 * faster), before.velocity + faster};
        }
        const double rest = load / stiffness_;
        const double aside = before.offset - rest;
        return {rest + offset_of_offset_ * aside + offset_of_velocity_ * before.velocity,
                velocity_of_offset_ * aside + velocity_of_velocity_ * before.velocity};
    }

  private:
    double stiffness_;
    double offset_of_offset_ = 1, offset_of_velocity_ = 0, velocity_of_offset_ = 0, velocity_of_velocity_ = 1;
    double velocity_of_load_ = 0;  ///< of a free mass
};

/// The states at the ends of the intervals, in their order: between two ends, the offset may be larger by at most
/// 1 - cos(ωh/2) of its swing, which is 1.2 % where a period has 20 intervals. `load`: N, constant in each interval of
/// `step` s, > 0; `start`: before the first. Throws ContractError for an oscillator or a step outside these
/// ranges.
std::vector<OscillatorState> motion_under(const Oscillator& oscillator, std::span<const double> load, double step,
                                          OscillatorState start = {});

// How a moored structure moved in the window and what its moorings bore, as single numbers.

/// Signs as in simulation/record.hpp. All NaN without moorings.
struct MooredResponse {
    Swing surge_offset;                                                 ///< m
    Swing sway_offset;                                                  ///< m
    Swing yaw;                                                          ///< rad
    Swing surge_mooring;                                                ///< N
    Swing sway_mooring;                                                 ///< N
    Swing heave{};                                                      ///< m; NaN without heave, pitch and roll
    Swing pitch{};                                                      ///< rad
    Swing roll{};                                                       ///< rad
    Swing surge_thrust{};                                               ///< N; NaN without thrusters
    Swing sway_thrust{};                                                ///< N
    Swing yaw_thrust{};                                                 ///< N m
    double thrust_at_limit = std::numeric_limits<double>::quiet_NaN();  ///< share of the window in any direction
    double mean_maximum = std::numeric_limits<double>::quiet_NaN();  ///< of the surge mooring force, over segments, N
    double rms_velocity = std::numeric_limits<double>::quiet_NaN();  ///< in surge, relative to the anchors, m/s
    double line_tension = std::numeric_limits<double>::quiet_NaN();  ///< the largest of any line over the run, N
    double broken_lines = std::numeric_limits<double>::quiet_NaN();  ///< at the end of the run
};

/// Root of the mean square of the changes between values over `step` s; at least two values.
double rms_rate(std::span<const double> values, double step);

}  // namespace floes
