#pragma once
// Plate tests side by side on the cores of this machine.

#include <vector>

#include "laboratory/calibration.hpp"

namespace floes {

/// The point of each plan, in their order. Throws as measure_curve_point() does.
std::vector<CurvePoint> measure_curve(const std::vector<PointPlan>& plans);

}  // namespace floes
