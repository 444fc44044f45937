#pragma once
// Lindqvist (1989), "A straightforward method for calculation of ice resistance of ships": the load of level ice on a
// sloping hull by crushing at the stem, bending along the waterline and submergence of the broken ice. SI units,
// angles in rad.
//
// Only bending depends on the elastic modulus, as 1/√E, so the load is a + b/√E and decreases with E.

namespace floes {

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

}  // namespace floes
