#pragma once
// Loads of ice in closed form: pressure over area, level ice, small floes, and the hybrid model of both.

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/units.hpp"
#include "scenario/scenario.hpp"

namespace floes {

// The usual pressure of ice over area, for local design: ISO 19906:2010 (A.8.2.5) for thick, massive ice, after D. M.
// Masterson, R. M. W. Frederking, B. Wright, T. Kärnä and W. P. Maddock, "A revised ice pressure-area curve", POAC
// 2007. Neither is open; the numbers are as the literature quotes them, and 7.40 A^-0.70 meets 1.48 at 10 m².
//
// It is a line above measurements at full scale (their mean and three standard deviations), most of multi-year ice that
// crushes, and says nothing of floes that bend or of model ice.

/// Pa, of the pressure averaged over an area, m², above 0.
inline double pressure_of_area(double area) {
    constexpr double bend = 10;  // m²
    return area <= bend ? 7.40e6 * std::pow(area, -0.70) : 1.48e6;
}

// Lindqvist (1989), "A straightforward method for calculation of ice resistance of ships": the load of level ice on a
// sloping hull by crushing at the stem, bending along the waterline and submergence of the broken ice. SI units,
// angles in rad.
//
// Only bending depends on the elastic modulus, as 1/√E, so the load is a + b/√E and decreases with E.

/// The hull at the waterline. The normal's angle ψ follows from the two others: tan ψ = tan φ / sin α.
struct IceHull {
    double breadth = 0;         ///< B, m
    double length = 0;          ///< L, m
    double draught = 0;         ///< T, m
    double stem_angle = 0;      ///< φ, of the stem from the horizontal, below 90 degrees
    double entrance_angle = 0;  ///< α, of the waterline from the centreline; 90 degrees is a transverse wall
    double friction = 0;        ///< μ of ice on hull

    double normal_angle() const;  ///< ψ, of the hull's normal from the vertical
};

/// The ice.
struct LevelIce {
    double thickness = 0;         ///< h, m
    double bending_strength = 0;  ///< σ_b, Pa
    double elastic_modulus = 0;   ///< E, Pa
    double density = 0;           ///< ρ_i, kg/m³
    double water_density = 1000;  ///< ρ_w, kg/m³
    double poisson_ratio = 0.3;   ///< ν
    double gravity = 9.81;        ///< m/s²
};

/// The parts of the load at a speed, N.
struct LindqvistLoad {
    double crushing = 0;
    double bending = 0;
    double submergence = 0;

    double total() const { return crushing + bending + submergence; }
};

/// R = (R_c + R_b)(1 + 1.4 v/√(g h)) + R_s (1 + 9.4 v/√(g L)), part by part; `speed` in m/s, >= 0. Throws InputError
/// for a hull on which ice jams instead of breaking: μ sin φ >= cos ψ.
LindqvistLoad lindqvist_load(const IceHull& hull, const LevelIce& ice, double speed);

// Kashtelyan, Poznyak and Ryvlin (1968): the load of small floes that do not break, as the sum of a static, a
// dissipative (~ speed) and an impact part (~ speed²). The authors fitted the three coefficients to ships; no
// accessible source gives their values, so they are arguments here. SI units, angles in rad.

/// k1, k2, k3: the weights of the parts. They include concentration and channel width.
struct KprCoefficients {
    double static_part = 0;
    double dissipative = 0;
    double impact = 0;
};

struct KprLoad {
    double static_part = 0;  ///< N
    double dissipative = 0;
    double impact = 0;

    double total() const { return static_part + dissipative + impact; }
};

/// Floes of `floe_length` r (m). With Fr = V/√(g L) and the waterline coefficient a_H = π/4 of a circular bow:
///   k1 ρ_i g √(r h) (B/2)² (1 + 2 μ a_H L/B)  +  k2 ρ_i g r h B (μ + a_H tan α₀) Fr  +  k3 ρ_i g r h L tan² α₀ Fr².
/// α₀ = 45 degrees: the mean entrance angle of a circular waterline.
KprLoad kpr_load(const KprCoefficients& coefficients, const IceHull& hull, const LevelIce& ice, double floe_length,
                 double speed);

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

// The hybrid model of Uto et al. (2015) as the paper uses it: the mean load is the smaller of the load that breaks the
// floes (limit stress, Lindqvist) and the load that pushes them aside (limit momentum, KPR). R_F = min(R_LS, R_LM),
// R_LS = IC R_LF (Eq. (6)), R_LM = R_SF (Eq. (7)).

class HybridModel {
  public:
    /// `ice` without its modulus, which is the argument of the functions below. `concentration` IC in (0, 1],
    /// `floe_length` m, `speed` m/s. Throws InputError as lindqvist_load() does.
    HybridModel(const IceHull& hull, const LevelIce& ice, double concentration, double floe_length, double speed);

    /// The same with the KPR static coefficient k1 that makes both limits cross at a modulus (Pa), k2 = k3 = 0: one
    /// free constant from one known value, which is a calibration and not a test. At model speed the other two parts
    /// are below 1 % of the static one.
    HybridModel crossing_at(double elastic_modulus) const;
    HybridModel with(const KprCoefficients& coefficients) const;

    LindqvistLoad limit_stress(double elastic_modulus) const;  ///< R_LS by component, N; E in Pa, > 0
    double limit_momentum() const;                             ///< R_LM, N
    double load(double elastic_modulus) const;                 ///< R_F, N

    /// The modulus (Pa) at which both limits are equal: floes break above it. Empty if R_LM is below R_LS at any E.
    std::optional<double> crossing() const;

    const KprCoefficients& coefficients() const { return coefficients_; }

  private:
    IceHull hull_;
    LevelIce ice_;
    double concentration_;
    double floe_length_;
    double speed_;
    KprCoefficients coefficients_;
};

// The hybrid model over the elastic modulus for a scenario: Fig. 8.

/// Loads at one modulus, N.
struct HybridPoint {
    double elastic_modulus = 0;        ///< Pa
    double characteristic_length = 0;  ///< of a floating plate of this modulus, m
    LindqvistLoad limit_stress;        ///< by component
    double limit_momentum = 0;
    double load = 0;  ///< the smaller of the two limits
};

struct HybridCurve {
    IceHull hull;
    KprCoefficients coefficients;
    std::vector<HybridPoint> points;
    std::optional<double> crossing;  ///< Pa; none when floes are pushed aside at any modulus
};

/// The ship dimensions of Lindqvist's formula for a body of revolution: breadth and length are the waterline diameter,
/// the ice meets the wall squarely (α = 90 degrees), and the wall angle is the one just above the waterline (Table 2).
/// Throws InputError if the wall is vertical or overhangs there.
IceHull hull_of(const Scenario& scenario);

/// The ice of the scenario's floes, without a modulus.
LevelIce level_ice_of(const Scenario& scenario);

/// The model without KPR coefficients. Throws InputError as hull_of() and lindqvist_load() do.
HybridModel hybrid_model(const Scenario& scenario);

/// The curve at these moduli (Pa, > 0), in their order.
HybridCurve hybrid_curve(const Scenario& scenario, const HybridModel& model, std::span<const double> moduli);

}  // namespace floes
