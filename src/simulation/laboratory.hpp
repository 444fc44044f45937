#pragma once
// Laboratory tests on numerical ice: plates that bend on water, and cantilevers that break.

#include <vector>

#include "ice/failure_mode.hpp"
#include "scenario/scenario.hpp"

namespace floes {

// The plate-deflection test of Fig. 2 on numerical ice: a floating sheet of elements is loaded at its centre in
// increments, and the slope of load over deflection gives the elastic modulus that results from element size, Σ, Γ, Δt
// and the number of iterations. The sheet is one large floe: same joints, solver and joint order as a campaign.

struct PlateTest {
    double sheet = 5.4;  ///< side of the square sheet, m; a whole number of elements, at least 2
    double load = 3.0;   ///< largest total load, N, on the centre element, or on the four around the centre
    int increments = 3;  ///< equal steps up to it, each settled
};

/// The test at the size of the scenario's ice, scaled by Froude: PlateTest's own numbers where it is as thick as the
/// paper's.
PlateTest plate_test_for(const Scenario& scenario);

/// The same on the largest sheet up to that size that the scenario's elements divide.
PlateTest whole_plate_test(const Scenario& scenario);

struct PlateDeflection {
    std::vector<double> load;          ///< N, of each increment
    std::vector<double> deflection;    ///< m, of the centre of the sheet, downwards
    double slope = 0;                  ///< dP/dw0 by least squares through the origin, N/m
    double elastic_modulus = 0;        ///< Pa; load on a circle of the loaded elements' area (theory/plate.hpp)
    double elastic_modulus_point = 0;  ///< Pa; as if the load were a point: 3/16 (1 - ν²)/(ρ_w g h³) slope²
};

/// Runs the test on the scenario's ice (thickness, density, element, joint, general, water density, and ν of beams,
/// 0.3 of joints by Σ; the rest of the scenario does not matter). Throws InputError if elements do not divide the
/// sheet, the load breaks or sinks the sheet, or an increment does not settle.
PlateDeflection measure_plate_deflection(const Scenario& scenario, const PlateTest& test);

// The E-Σ curve of Fig. 2, and its inverse: the Σ that gives numerical ice a requested elastic modulus.

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

// A cantilever of beam joints beside the closed form: how far it bends under a load, and how it swings when let go.

/// Measured, and of an elastic strip of plate of the same length (theory/plate.hpp).
struct BeamStiffness {
    double deflection = 0;          ///< m, at the middle of the last element, which carries the load
    double elastic_deflection = 0;  ///< m
    double frequency = 0;           ///< 1/s, of the lowest mode
    double elastic_frequency = 0;   ///< 1/s
};

/// Dry and weightless, one element wide, clamped at the face of the first of `elements` elements. Uses ice, joint,
/// floe.element and iterations of the scenario. The swing is computed in steps of 1/400 of its period. Throws
/// InputError unless joints are of the model beam, and when the beam does not come to rest.
BeamStiffness measure_beam_stiffness(const Scenario& scenario, int elements);

// The cantilever test on numerical ice: a beam one element wide, clamped at one end, loaded at the other until a joint
// fails. Measures the strength of the beam. Also shears or crushes one element against the clamp.

enum class BeamLoad { bending, shear, compression };

struct BeamTest {
    BeamLoad load = BeamLoad::bending;
    int elements = 3;          ///< of the beam, at least 1; the load acts on the middle of the last one
    bool floating = false;     ///< on the scenario's water instead of dry and weightless
    double increment = 0.005;  ///< of the load, as a fraction of the load that the strength predicts
};

struct BeamStrength {
    FailureMode mode = FailureMode::bending;  ///< of the joint that failed first
    int joint = 0;                            ///< its index, from 0 at the clamp
    double length = 0;                        ///< m, from the load to that joint
    double load = 0;                          ///< N, at failure
    double strength =
        0;  ///< Pa, measured: bending 6 P L/(b h²), otherwise P/(b h), or P/(b h²) as Eqs. (1)-(2) are printed
    double set = 0;  ///< Pa, the scenario's strength of that kind
};

/// Raises the load in increments, each settled, until a joint fails, by stress where joint.failure says so. Uses
/// general, ice, joint, floe.element of the scenario (and water density when floating). Throws InputError when the test
/// is not possible or nothing fails.
BeamStrength measure_beam_strength(const Scenario& scenario, const BeamTest& test);

}  // namespace floes
