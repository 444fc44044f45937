#pragma once
// Level ice without an end on a sloping wall, and on a vertical one, as ISO 19906 has them. Sloping: K. R. Croasdale
// and A. B. Cammaert, "An improved method for the calculation of ice loads on sloping structures in first-year ice",
// Hydrotechnical Construction 28 (1994) 174-179 (ISO 19906:2010, A.8.2.4.4). Crushing: A.8.2.4.3.3. Neither the
// standard nor the paper is open; the formulas are as OpenFAST's module IceFloe has them, whose figures the tests
// repeat. SI units, angles in rad.
//
// They hold for a sheet of level ice that goes on coming, on a plane wall that is wide against the thickness: the load
// when the sheet breaks by bending, while the rubble of the broken ice lies on the wall. They are no formulas for
// floes, and none for a round hull: there the ice also clears sideways. ISO's model of a slope gave 1.6 times what was
// measured in 50 events at the Confederation Bridge (Croasdale and others, OTC 27385, 2016).

#include "core/units.hpp"
#include "theory/lindqvist.hpp"

namespace floes {

/// The broken ice on the wall. Defaults: the worked example of IceFloe, for want of an open source that recommends
/// some.
struct Rubble {
    double height = 3;                          ///< h_r above the water, m
    double porosity = 0.3;                      ///< e, 0 to 1
    double angle = 40 * unit::degree;           ///< θ of its surface from the horizontal: 40 degrees
    double friction_angle = 45 * unit::degree;  ///< φ inside it: 45 degrees
    double cohesion = 0;                        ///< c, Pa
    double ice_friction = 0.05;                 ///< μ_i of ice on ice
};

/// The horizontal load by part, N. With w the breadth, α the wall's angle, μ the friction on it,
/// ξ = (sin α + μ cos α) / (cos α - μ sin α), r = 1 - tan θ / tan α, q = ρ_i g (1 - e) and the length of the crack
/// l_c = w + π² L / 4, L = (E h³ / (12 ρ_w g (1 - ν²)))^¼:
struct SlopingLoad {
    double breaking = 0;  ///< H_B = 0.68 ξ σ_f (ρ_w g h⁵ / E)^¼ l_c: the sheet breaks
    double pushing = 0;   ///< H_P = w h_r² μ_i q r² / (2 tan θ): it is pushed through the rubble
    double lifting = 0;  ///< H_L = w h_r ξ r (½ h_r q (cot θ - cot α + r tan φ) + c): rubble is lifted and sheared
    /// H_R = w P / (cos α - μ sin α): blocks go up the wall below the rubble, with
    /// P = ½ (μ_i + μ) q h_r² r (μ_i sin α (cot θ - cot α) + cos α cot α) + h_r h ρ_i g (sin α + μ cos α) / sin α
    double ride_up = 0;
    double turning = 0;  ///< H_T = 1.5 w h² ρ_i g cos α / (sin α - μ cos α): blocks turn at the top of the slope
    double thrust = 1;   ///< 1 / (1 - H_B / (σ_f l_c h)): the load compresses the sheet, which then bears more bending

    double total() const { return (breaking + pushing + lifting + ride_up + turning) * thrust; }
};

/// `hull`: its breadth, stem angle and friction. Throws InputError for rubble that is none (check_rubble()),
/// and for a wall on which such ice does not break by bending: cos α <= μ sin α, sin α <= μ cos α, or
/// H_B >= σ_f l_c h.
SlopingLoad sloping_load(const IceHull& hull, const LevelIce& ice, const Rubble& rubble);

/// Throws InputError unless height, cohesion and friction are not negative, the porosity is in [0, 1), the friction
/// angle in [0°, 90°), and the rubble's angle above 0 and not above the wall's: a pile that is steeper than its wall
/// has no weight on it.
void check_rubble(const Rubble& rubble, double wall_angle);

/// Level ice that crushes on a vertical wall, N: C_R (h/h₁)^n (w/h)^m w h with h₁ = 1 m, m = -0.16 and n = -0.5 + h/(5
/// m) below 1 m, -0.3 from there. `strength`: C_R, Pa, of a region's ice. For w/h above 2; at sea, not in a tank.
double crushing_load(double breadth, double thickness, double strength);

}  // namespace floes
