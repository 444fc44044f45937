#pragma once
// The plate-deflection test of Fig. 2 on numerical ice: a floating sheet of elements is loaded at its centre in
// increments, and the slope of load over deflection gives the elastic modulus that results from element size, Σ, Γ, Δt
// and the number of iterations. The sheet is one large floe: same joints, solver and joint order as a campaign.

#include <vector>

#include "scenario/scenario.hpp"

namespace floes {

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

}  // namespace floes
