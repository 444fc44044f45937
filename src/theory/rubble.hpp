#pragma once
// Broken ice that lies still, in closed form: how deep a pile floats, when it grounds, and what it presses with. Per
// width across the tow, SI units, angles in rad.

#include "core/units.hpp"

namespace floes {

/// What a pile is made of, and how steeply its sides stand.
struct PiledIce {
    double porosity = 0.3;             ///< e, of the pile, below 1
    double angle = 30 * unit::degree;  ///< θ of the keel's slope from the horizontal, above 0 and below 90 degrees
    double ice_density = 900;          ///< ρ_i, kg/m³
    double water_density = 1000;       ///< ρ_w, above ρ_i
    double gravity = 9.81;             ///< m/s²

    double lift() const;    ///< (1 - e)(ρ_w - ρ_i) g: by which a unit volume of keel presses upwards, N/m³
    double weight() const;  ///< (1 - e) ρ_i g: of a unit volume of sail, N/m³
};

/// Depth (m) of the keel of a pile that floats against a wall. `ice`: the area of its section without pores, m².
/// `wall_angle`: α, from the horizontal, of a wall whose foot stands out below the ice: what is under water, the share
/// ρ_i/ρ_w of ice/(1 - e), is the triangle ½ d² (cot θ - cot α). Throws InputError unless θ < α.
double keel_depth(const PiledIce& pile, double ice, double wall_angle);

/// Length (m) of a sheet of the thickness T (m) that has to be broken until its pile touches a bed at this depth (m).
double length_until_grounded(const PiledIce& pile, double thickness, double depth, double wall_angle);

/// Force (N/m) on an upright wall without friction of a pile without cohesion that is just about to give way towards
/// it, or is pushed back by it (Rankine): ½ K (lift d² + weight s²), K = tan²(45° ∓ φ/2), for a keel d and a sail s
/// deep and high with level surfaces. `friction_angle`: φ.
struct RubblePressure {
    double active = 0;
    double passive = 0;
};
RubblePressure rubble_pressure(const PiledIce& pile, double keel, double sail, double friction_angle);

}  // namespace floes
