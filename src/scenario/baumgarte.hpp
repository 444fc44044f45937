#pragma once
// Constraint force mixing Σ and error reduction Γ as a spring and a damper, both ways: Eqs. (4)-(5) as the paper prints
// them, and what Bullet makes of the same two numbers.
//
// Eqs. (4)-(5):   Σ = 1 / (Δt K + D),   Γ = Δt K / (Δt K + D),   with Σ in s/kg.
//
// Bullet multiplies Σ with the impulse of a row that is already scaled by its effective mass, and does not divide by
// Δt: its Σ is dimensionless, and Eq. (4) holds for each row with Σ Δt A in place of Σ, where A = J M⁻¹ Jᵀ is the
// inverse of the row's effective mass. Hence K = Γ / (Δt² Σ A) and D = (1 - Γ) / (Δt Σ A): stiffness is proportional to
// the mass of the elements and to the inverse square of the time step. Measured to five digits, alike in Bullet 2.82
// to 3.27.

namespace floes {

/// One row of a joint as a spring and a damper: K in N/m and D in N s/m, or N m/rad and N m s/rad.
struct SpringDamper {
    double stiffness = 0;
    double damping = 0;
};

/// Σ and Γ. Σ is in s/kg (or rad s/(kg m²)) in the paper's equations, and a plain number in Bullet's joints.
struct Stabilization {
    double cfm = 0;
    double erp = 0;
};

/// Eqs. (4)-(5). `time_step` in s; K and D at least 0, not both 0.
Stabilization paper_stabilization(const SpringDamper& row, double time_step);

/// Eqs. (4)-(5) solved for K and D. `time_step` in s; Σ above 0.
SpringDamper paper_spring(const Stabilization& numbers, double time_step);

/// Bullet's numbers for a joint row of inverse effective mass A (1/kg, or 1/(kg m²)).
Stabilization bullet_stabilization(const SpringDamper& row, double time_step, double inverse_mass);

/// The spring and damper that Bullet's numbers make of a joint row of inverse effective mass A (1/kg, or 1/(kg m²)).
SpringDamper bullet_spring(const Stabilization& numbers, double time_step, double inverse_mass);

/// A = J M⁻¹ Jᵀ of the rows of a joint at mid-edge between two equal square elements lying in one plane.
/// Joint axes: x from one element to the other, y up. Translations in 1/kg, rotations in 1/(kg m²).
struct JointRows {
    double axial = 0;             ///< along x
    double vertical_shear = 0;    ///< along y
    double in_plane_shear = 0;    ///< along z
    double torsion = 0;           ///< about x
    double in_plane_bending = 0;  ///< about y
    double bending = 0;           ///< about z
};

/// `side` L_e and `thickness` T_e in m, `density` in kg/m³.
JointRows joint_rows(double side, double thickness, double density);

}  // namespace floes
