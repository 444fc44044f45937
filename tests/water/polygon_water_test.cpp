// The water on polygons: as on squares where they are squares.

#include "water/water_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "water/floating_plate.hpp"

namespace floes {
namespace polygon_water_test {

CutFloe cut_square(double side, double element) {
    const double half = side / 2;
    return cut_into_cells(Outline{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, element);
}

ElementState state_of(int number) {
    ElementState state;
    const double k = number;
    state.position = {1.1 + 0.2 * k, -0.02 + 0.004 * k, 0.3 - 0.1 * k};
    state.rotation =
        (Eigen::AngleAxisd(0.4 * k, Vec3::UnitY()) * Eigen::AngleAxisd(0.15 * k, Vec3::UnitX())).toRotationMatrix();
    state.velocity = {0.1, -0.05 * k, 0.2};
    state.angular_velocity = {0.3, -0.2, 0.1 * k};
    return state;
}

TEST(PolygonWater, OnASquareIsThatOfTheSquare) {
    Water water;
    water.current = 0.05;
    water.turning = 0.3;
    const CutElement element = cut_square(0.2, 0.2).elements.front();
    const double mass = 930 * 0.04 * 0.033;
    const Vec2 wind(0.3, -0.1);
    WaterModel square(water, 9.81, {0.2, 0.033}, mass, 0.6, 0.1, wind);
    WaterModel polygon(water, 9.81, element, 0.033, mass, 0.6, 0.1, wind);
    ASSERT_FALSE(polygon.plan().empty()) << "or the square is compared with itself";
    EXPECT_NEAR(polygon.damping(), square.damping(), 1e-12);
    for (int number = 0; number < 16; ++number) {
        ElementState state = state_of(number % 8);
        state.exposed_edges = 15;
        if (number == 8)
            for (WaterModel* one : {&square, &polygon})
                one->flow_round(std::vector<FlowEllipse>{{0.2, 0.1, 1, 0.4}, {-1, 0, 0.3, 0.3}});
        const Wrench a = square.wrench(state, 0.4);
        const Wrench b = polygon.wrench(state, 0.4);
        EXPECT_LT((a.force - b.force).norm(), 1e-12 * (1 + a.force.norm()));
        EXPECT_LT((a.moment - b.moment).norm(), 1e-12 * (1 + a.moment.norm()));
    }
}

/// ρ g V upwards, and the righting moment of the waterplane, at a small tilt about any axis.
TEST(PolygonWater, RightsATriangleAsItsWaterplaneDoes) {
    Water water;
    water.form_drag = water.skin_drag = water.heave_drag = 0;
    const Outline outline{{-0.1, -0.05}, {0.14, -0.05}, {-0.04, 0.1}};
    const Measures measures = measures_of(outline);
    const CutElement element = cut_into_cells(in_axes(outline, measures.centroid, long_axis(measures)), 1).elements[0];
    const WaterModel polygon(water, 9.81, element, 0.05, 1, 0, 0, Vec2::Zero());
    const double draught = 0.03;
    const double g = 9.81 * water.density;
    for (const double angle : {0.0, 0.7, 2.0}) {
        const Vec3 axis(std::cos(angle), 0, std::sin(angle));
        const double tilt = 1e-4;
        ElementState state;
        state.position.y() = 0.025 - draught;
        state.rotation = Eigen::AngleAxisd(tilt, axis).toRotationMatrix();
        const Wrench wrench = polygon.wrench(state, 0, 0);
        EXPECT_NEAR(wrench.force.y(), g * element.area * draught, 1e-6);
        const Vec3 about(element.zz * axis.x(), 0, element.xx * axis.z());  // waterplane tensor times the axis
        const double lever = draught / 2 - 0.025;                           // of the middle of what is under water
        const Vec3 expected = -tilt * g * (about + element.area * draught * lever * axis);
        EXPECT_LT((wrench.moment - expected).norm(), 1e-3 * expected.norm());
    }
}

TEST(PolygonWater, IsSharedOutAmongSquaresAsAmongSquares) {
    const WaterBody water{1000, 9.81, 0.1};
    const CutFloe floe = cut_into_squares(3, 3, 0.2);
    std::vector<const CutElement*> elements;
    std::vector<Vec2> centres;
    for (const CutElement& one : floe.elements) {
        elements.push_back(&one);
        centres.emplace_back(one.centre.x, one.centre.z);
    }
    const std::vector<ElementWater> polygons = water_of_piece(elements, 0.03, water);
    const std::vector<ElementWater> squares = water_of_piece(centres, 0.2, 0.03, water);
    for (std::size_t i = 0; i < squares.size(); ++i) {
        const CarriedWater& a = squares[i].carried;
        const CarriedWater& b = polygons[i].carried;
        EXPECT_NEAR(polygons[i].damping, squares[i].damping, 1e-10);
        for (const auto part : {&CarriedWater::in_plane, &CarriedWater::yaw, &CarriedWater::normal, &CarriedWater::x,
                                &CarriedWater::z, &CarriedWater::xx, &CarriedWater::xz, &CarriedWater::zz})
            EXPECT_NEAR(a.*part, b.*part, 1e-10);
    }
}

}  // namespace polygon_water_test
}  // namespace floes
