#include "driver/measure_curve.hpp"

#include <tbb/parallel_for.h>

namespace floes {

std::vector<CurvePoint> measure_curve(const std::vector<PointPlan>& plans) {
    std::vector<CurvePoint> curve(plans.size());
    tbb::parallel_for(std::size_t{0}, plans.size(),
                      [&](std::size_t i) { curve[i] = measure_curve_point(plans[i].scenario, plans[i].test); });
    return curve;
}

}  // namespace floes
