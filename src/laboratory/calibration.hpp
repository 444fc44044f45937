#pragma once
// The E-Σ curve of Fig. 2, and its inverse: the Σ that gives numerical ice a requested elastic modulus.

#include <vector>

#include "laboratory/plate_deflection.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// One plate test and everything on which its modulus depends. SI.
struct CurvePoint {
    double sheet = 0;
    double element = 0;
    double thickness = 0;
    double time_step = 0;
    double erp = 0;
    int iterations = 0;
    double cfm = 0;
    double slope = 0;                  ///< N/m
    double elastic_modulus = 0;        ///< Pa, load on a patch
    double elastic_modulus_point = 0;  ///< Pa, as if the load were a point
    JointModel model = JointModel::cfm;
    double set_modulus = 0;  ///< Pa, E of beam joints
};

/// One plate test to be made.
struct PointPlan {
    Scenario scenario;
    PlateTest test;
};

/// The curve of Fig. 2 for the scenario's ice: Σ from vanishing_cfm to 0.06 on a sheet of 13 elements square, which is
/// the paper's smaller sheet to a whole number of elements.
std::vector<PointPlan> curve_plans(const Scenario& scenario);

/// The scenario with beam joints of this modulus (Pa), solved exactly.
Scenario with_beam_joints(Scenario scenario, double elastic_modulus);

/// measure_plate_deflection() on the scenario's ice; throws as it does.
CurvePoint measure_curve_point(const Scenario& scenario, const PlateTest& test);

/// The scenario with everything that does not affect a plate test set to its default: equal for two scenarios exactly
/// if they share a calibration. Keeps general, ice, joint (except Σ, which the test varies), element and water density.
Scenario plate_scenario(const Scenario& scenario);

/// Σ so small that only the sweeps limit the stiffness: E there is the ceiling of element size, Δt, Γ and iterations.
inline constexpr double vanishing_cfm = 1e-10;

struct Calibration {
    double cfm = 0;                 ///< gives the requested modulus within 1 %
    double ceiling = 0;             ///< Pa, E at vanishing_cfm
    std::vector<CurvePoint> curve;  ///< all points measured, by ascending Σ
};

/// The Σ that gives the scenario's ice `elastic_modulus` (Pa, patch load). Throws InputError if the modulus is above
/// the ceiling (set by unconverged Gauss-Seidel) or so small that Σ would have to be 0.9 or more, or if joints do not
/// follow Σ.
Calibration calibrate_cfm(const Scenario& scenario, const PlateTest& test, double elastic_modulus);

}  // namespace floes
