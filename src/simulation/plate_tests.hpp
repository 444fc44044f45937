#pragma once
// Waiting for rest: a laboratory test takes a reading only when further steps no longer change it.

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "ice/scenario_world.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// Steps between two observations, and the largest number of observations.
inline constexpr int steps_between_looks = 25;
inline constexpr int most_looks = 400;

/// Calls advance() until observe() (m) changes by no more than 1e-7 of its distance from `origin` between two
/// observations, twice in a row, because a turning point is not rest. At `origin` itself rounding is left: 1e-15 m
/// times size_of_ice(). Returns the last observation, or nothing if it never settles.
template <class Advance, class Observe>
std::optional<double> settle(Advance&& advance, Observe&& observe, double origin, double size) {
    double reading = observe();
    int quiet = 0;
    for (int look = 0; look < most_looks; ++look) {
        for (int step = 0; step < steps_between_looks; ++step) advance();
        const double before = std::exchange(reading, observe());
        if (!std::isfinite(reading)) return std::nullopt;
        quiet = std::abs(reading - before) <= 1e-7 * std::abs(reading - origin) + 1e-15 * size ? quiet + 1 : 0;
        if (quiet == 2) return reading;
    }
    return std::nullopt;
}

/// Drag that brings a dry square element of this mass (kg) and side (m) to rest: a tenth of its momentum goes in each
/// step (s). Only the state at rest matters, and that does not depend on it.
inline Wrench settling_drag(const BodyState& body, double mass, double side, double time_step) {
    constexpr double loss = 0.1;
    const double moment_of_inertia = mass * side * side / 12;  // the smallest of a flat box, so that no axis gains
    return {.force = -loss * mass / time_step * body.velocity,
            .moment = -loss * moment_of_inertia / time_step * body.angular_velocity};
}

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

/// Runs the test on the scenario's ice (thickness, density, element, joint, general, water density; ν = 0.3; the rest
/// of the scenario does not matter). Throws InputError if elements do not divide the sheet, the load breaks or sinks
/// the sheet, or an increment does not settle.
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

}  // namespace floes
