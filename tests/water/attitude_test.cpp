// The water on an element at any attitude: tilted, on edge, on a corner and turned over.

#include "water/water_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floes {
namespace attitude_test {

constexpr double weight = 9810;  // ρ_w g, N/m³
constexpr double side = 0.2;
constexpr double thickness = 0.05;
constexpr double whole = side * side * thickness;

Mat3 turned(double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// A square; or a triangle, about its centroid.
WaterModel model_of(bool triangle, const Water& water) {
    if (!triangle) return {water, 9.81, {side, thickness}, 1.8, 0, 0};
    const Outline outline{{-0.1, -0.05}, {0.14, -0.05}, {-0.04, 0.1}};
    const Measures measures = measures_of(outline);
    const CutElement element = cut_into_cells(in_axes(outline, measures.centroid, long_axis(measures)), 1).elements[0];
    return {water, 9.81, element, thickness, 1, 0, 0, Vec2::Zero()};
}

Wrench buoyancy(const WaterModel& model, double height, const Mat3& rotation) {
    return model.wrench({.position = {0, height, 0}, .rotation = rotation}, 0);
}

const Water still{.flow = WaterFlow::still};

// On edge, the lower edge d under water: ρ g L T d, at d/2.
TEST(Attitude, OnEdgeAnElementDisplacesWhatStandsInTheWater) {
    const WaterModel model = model_of(false, still);
    for (const double d : {0.01, 0.1, 0.19})
        for (const double sign : {-1.0, 1.0}) {
            const Wrench found = buoyancy(model, side / 2 - d, turned(sign * std::numbers::pi / 2, Vec3::UnitX()));
            EXPECT_NEAR(found.force.y(), weight * side * thickness * d, 1e-10);
            EXPECT_NEAR(found.moment.norm(), 0, 1e-12);
        }
}

// On a corner, d under water: the tetrahedron d³/(6 c₁ c₂ c₃) with the cosines of the three edges from the vertical,
// and its centroid d/4 below the water, above the corner by the mean of the corners that the water cuts.
TEST(Attitude, OnACornerAnElementDisplacesATetrahedron) {
    const WaterModel model = model_of(false, still);
    const Mat3 rotation = turned(0.5, Vec3(1, 0, 0.6));
    const Vec3 up = rotation.transpose() * Vec3::UnitY();
    const Vec3 half(side / 2, thickness / 2, side / 2);
    const Vec3 corner = -half.cwiseProduct(up.cwiseSign());
    const double d = 0.01;
    const double height = -d - (rotation * corner).y();  // of the centre
    const double volume = d * d * d / (6 * std::abs(up.prod()));
    Vec3 centroid = corner;
    for (int k = 0; k < 3; ++k) centroid[k] += d / up[k] / 4;
    const Vec3 arm = rotation * centroid;
    const Wrench found = buoyancy(model, height, rotation);
    EXPECT_NEAR(found.force.y() / (weight * volume), 1, 1e-9);
    EXPECT_NEAR(found.moment.x(), -arm.z() * weight * volume, 1e-11);
    EXPECT_NEAR(found.moment.z(), arm.x() * weight * volume, 1e-11);
}

// What is under water and what would be of the element turned over, at the opposite height, make up the whole.
TEST(Attitude, WetAndDryPartsMakeUpTheElement) {
    const WaterModel model = model_of(false, still);
    for (double angle = 0; angle < std::numbers::pi; angle += 0.1)
        for (const double height : {-0.08, -0.02, 0.0, 0.01}) {
            const Mat3 rotation = turned(angle, Vec3(1, 0.2, 0.4));
            const Wrench one = buoyancy(model, height, rotation);
            const Wrench other = buoyancy(model, -height, turned(std::numbers::pi, Vec3::UnitX()) * rotation);
            EXPECT_NEAR(one.force.y() + other.force.y(), weight * whole, 1e-11);
        }
}

// Buoyancy has a potential, so ∂F_y/∂θ = ∂M/∂y about any horizontal axis, at any attitude, of a triangle too.
TEST(Attitude, BuoyancyKeepsEnergy) {
    constexpr double step = 1e-6;
    for (const bool triangle : {false, true}) {
        const WaterModel model = model_of(triangle, still);
        for (double angle = 0.05; angle < std::numbers::pi; angle += 0.15)
            for (const double height : {-0.03, 0.0, 0.02})
                for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0.6, 0, 0.8)}) {
                    const Mat3 rotation = turned(angle, axis) * turned(0.7, Vec3::UnitY());
                    const auto lift = [&](double by) {
                        return buoyancy(model, height, turned(by, axis) * rotation).force.y();
                    };
                    const auto moment = [&](double by) {
                        return buoyancy(model, height + by, rotation).moment.dot(axis);
                    };
                    const double of_turn = (lift(step) - lift(-step)) / (2 * step);
                    const double of_rise = (moment(step) - moment(-step)) / (2 * step);
                    EXPECT_NEAR(of_turn, of_rise, 1e-3) << angle << " " << height;
                }
    }
}

// Half an element that stands in the water has half its drag along the normal, and a face half under water half its
// form drag.
TEST(Attitude, DragIsThatOfWhatIsUnderWater) {
    const WaterModel model = model_of(false, {.flow = WaterFlow::still, .skin_drag = 0});
    const Mat3 upright = turned(std::numbers::pi / 2, Vec3::UnitX());
    ElementState state{.rotation = upright, .velocity = -0.3 * upright.col(1)};
    const double pressure = 0.5 * 1000 * 0.09;
    const double buoyant = buoyancy(model, 0, upright).force.y();
    const Vec3 lift(0, buoyant, 0);
    EXPECT_LT((model.wrench(state, 0, 0).force - lift - pressure * side * side / 2 * upright.col(1)).norm(), 1e-9);
    state.velocity = {0.3, 0, 0};
    state.exposed_edges = 1;
    const Wrench form = model.wrench(state, 0, 0);
    EXPECT_NEAR(form.force.x(), -pressure * side / 2 * thickness, 1e-9);
    EXPECT_NEAR(form.moment.z(), -pressure * side / 2 * thickness * side / 4, 1e-9);
}

}  // namespace attitude_test
}  // namespace floes
