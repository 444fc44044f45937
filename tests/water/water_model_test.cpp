#include "water/water_model.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/units.hpp"
#include "water/floating_plate.hpp"

namespace floes {
namespace water_model_test {

constexpr double gravity = 9.81;
constexpr ElementShape shape{0.2, 0.033};
constexpr double radius = 0.614;
constexpr double speed = 0.07;

double mass_of(double density) {
    return density * shape.side * shape.side * shape.thickness;
}

double draught_of(double density) {
    return density / 1000 * shape.thickness;
}

Water still_water() {
    Water water;
    water.flow = WaterFlow::still;
    water.heave_damping_from = water.added_mass_from = WaterFrom::share;
    return water;
}

Wrench wrench(const Water& water, const ElementState& state) {
    return WaterModel(water, gravity, shape, mass_of(930), radius, speed).wrench(state, 0);
}

/// On an element at rest in still water there is no drag.
Wrench buoyancy(ElementState state) {
    state.velocity.setZero();
    state.angular_velocity.setZero();
    return wrench(still_water(), state);
}

/// All but buoyancy.
Wrench drag(const Water& water, const ElementState& state) {
    const Wrench all = wrench(water, state);
    const Wrench hydrostatic = buoyancy(state);
    return {all.force - hydrostatic.force, all.moment - hydrostatic.moment};
}

Mat3 turned(double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

TEST(Buoyancy, CarriesTheElementAtItsDraught) {
    ElementState state;
    state.position.y() = 0.5 * shape.thickness - draught_of(930);
    const Wrench floating = buoyancy(state);
    EXPECT_NEAR(floating.force.y(), mass_of(930) * gravity, 1e-12);
    EXPECT_NEAR(floating.moment.norm(), 0, 1e-14);
}

TEST(Buoyancy, IsThatOfTheWholeVolumeUnderWaterAndNothingAbove) {
    for (const double angle : {0.0, 0.4, 1.3, std::numbers::pi / 2, 2.5, std::numbers::pi}) {
        ElementState state;
        state.rotation = turned(angle, Vec3(1, 0.2, 0.7).normalized());
        state.position = {3, -1, 2};
        const Wrench sunk = buoyancy(state);
        EXPECT_NEAR(sunk.force.y(), mass_of(1000) * gravity, 1e-12);
        EXPECT_NEAR(sunk.moment.norm(), 0, 1e-14);
        state.position.y() = 1;
        EXPECT_EQ(buoyancy(state).force, Vec3::Zero());
    }
}

TEST(Buoyancy, UpsideDownIsTheSameElement) {
    ElementState state;
    state.position.y() = -0.005;
    const Wrench upright = buoyancy(state);
    state.rotation = turned(std::numbers::pi, Vec3::UnitZ());
    const Wrench inverted = buoyancy(state);
    EXPECT_NEAR((upright.force - inverted.force).norm(), 0, 1e-10);
    EXPECT_NEAR(inverted.moment.norm(), 0, 1e-14);
}

// Metacentric stiffness: M/θ = -(ρ_w g L⁴/12 - ρ_w g L² d (T - d)/2), the centre of buoyancy lying (T - d)/2 below the
// centre of mass.
TEST(Buoyancy, HasTheMetacentricStiffnessInPitchAndRoll) {
    const double draught = draught_of(930);
    const double side = shape.side;
    const double rise = 0.5 * (shape.thickness - draught);
    const double stiffness = 1000 * gravity * (std::pow(side, 4) / 12 - side * side * draught * rise);
    const double angle = 1e-6;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.6, 0, 0.8)}) {
        ElementState state;
        state.position.y() = 0.5 * shape.thickness - draught;
        state.rotation = turned(angle, axis);
        const Wrench tilted = buoyancy(state);
        EXPECT_NEAR(tilted.moment.dot(axis) / angle, -stiffness, 1e-6 * stiffness);
    }
}

// Wall-sided formula, exact at finite tilt while neither face crosses the surface: M = -ρ g V sinθ (BM (1 + tan²θ/2) -
// BG).
TEST(Buoyancy, FollowsTheWallSidedFormulaAtFiniteTilt) {
    const double draught = 0.5 * shape.thickness;
    const double volume = shape.side * shape.side * draught;
    const double metacentre = std::pow(shape.side, 4) / 12 / volume;
    const double centre = 0.5 * (shape.thickness - draught);
    for (const double angle : {1 * unit::degree, 5 * unit::degree, 9 * unit::degree}) {
        ElementState state;  // the surface passes through the centre of mass: displaced volume stays T/2 L²
        state.rotation = turned(angle, Vec3::UnitZ());
        const Wrench tilted = buoyancy(state);
        const double expected = -1000 * gravity * volume * std::sin(angle) *
                                (metacentre * (1 + 0.5 * std::pow(std::tan(angle), 2)) - centre);
        EXPECT_NEAR(tilted.force.y(), 1000 * gravity * volume, 1e-11);
        EXPECT_NEAR(tilted.moment.z(), expected, 1e-12);
    }
}

TEST(Drag, VanishesWithoutRelativeMotion) {
    ElementState state;
    state.exposed_edges = 15;
    const Wrench hydrostatic = wrench(still_water(), state);
    EXPECT_EQ(hydrostatic.force.x(), 0);
    EXPECT_NEAR(hydrostatic.force.y(), 0.5 * mass_of(1000) * gravity, 1e-14);
    EXPECT_EQ(hydrostatic.force.z(), 0);
    EXPECT_NEAR(hydrostatic.moment.norm(), 0, 1e-14);
}

TEST(Drag, DryElementsFeelNone) {
    ElementState state;
    state.position.y() = 1;
    state.velocity = {1, 2, 3};
    state.angular_velocity = {1, 1, 1};
    state.exposed_edges = 15;
    EXPECT_EQ(wrench({}, state).force, Vec3::Zero());
    EXPECT_EQ(wrench({}, state).moment, Vec3::Zero());
}

// A towed element: only the exposed leading face pushes back, ½ ρ C_d L d v²; the flow pushes inward.
TEST(Drag, FormDragActsOnExposedFacesThatMeetTheFlow) {
    Water water = still_water();
    water.skin_drag = 0;
    water.heave_drag = 0;
    water.heave_damping = 0;
    const double draught = draught_of(930);
    ElementState state;
    state.position.y() = 0.5 * shape.thickness - draught;
    state.velocity = {0.3, 0, 0};
    const double full = 0.5 * 1000 * 1.0 * shape.side * draught * 0.09;

    state.exposed_edges = 0b1110;  // all but the leading +x face
    EXPECT_NEAR(drag(water, state).force.norm(), 0, 1e-9);
    state.exposed_edges = 0b0001;
    const Wrench exerted = drag(water, state);
    EXPECT_NEAR(exerted.force.x(), -full, 1e-9);
    // at the middle of the wetted depth, below the centre of mass: the push against the tow turns the bow down
    EXPECT_NEAR(exerted.moment.z(), -0.5 * (shape.thickness - draught) * full, 1e-9);
    state.velocity = {0, 0, -0.3};
    state.exposed_edges = 0b1000;
    EXPECT_NEAR(drag(water, state).force.z(), full, 1e-9);
}

// In the lee an edge meets S_c u + (1 - S_c) v_b, here of water at rest behind ice that moves at 0.1 m/s.
TEST(Drag, FormDragInTheLeeIsThatOfWhatComesThrough) {
    const Water water{.flow = WaterFlow::still, .form_drag = 1, .skin_drag = 0, .heave_drag = 0};
    ElementState state;
    state.velocity = {0.3, 0, 0};
    state.exposed_edges = 0b0101;
    state.position.y() = -1;
    const double full = 0.5 * 1000 * shape.side * shape.thickness * 0.09;
    EXPECT_NEAR(drag(water, state).force.x(), -full, 1e-12);
    std::array<EdgeShelter, 4> edges{};
    state.shelter = edges;
    EXPECT_NEAR(drag(water, state).force.x(), -full, 1e-12);
    edges[2] = {0, 0};  // of an edge that does not meet the flow
    edges[0] = {0.4, 0.6 * 0.1};
    const double meets = (0.3 - 0.06) / 0.3;
    EXPECT_NEAR(drag(water, state).force.x(), -meets * meets * full, 1e-12);
}

// The middle of its leading face lies on the structure's axis, where the water moves with the structure.
TEST(Drag, IsRelativeToTheStructureOnItsAxis) {
    const Water water{
        .form_drag = 1, .skin_drag = 0, .heave_drag = 0, .heave_damping_from = WaterFrom::share, .heave_damping = 0};
    ElementState state;
    state.position = {-0.5 * shape.side, -1, 0};
    state.velocity = {0.3, 0, 0};
    state.exposed_edges = 0b0001;
    const double slower = 0.3 - speed;
    EXPECT_NEAR(drag(water, state).force.x(), -0.5 * 1000 * shape.side * shape.thickness * slower * slower, 1e-12);
}

TEST(Drag, SkinDragIsQuadraticOnTheLowerFace) {
    Water water = still_water();
    water.skin_drag = 0.01;
    ElementState state;
    state.velocity = {0.3, 0, 0.4};
    const Wrench exerted = drag(water, state);
    const double expected = 0.5 * 1000 * 0.01 * shape.side * shape.side * 0.25;
    EXPECT_NEAR(exerted.force.x(), -0.6 * expected, 1e-14);
    EXPECT_NEAR(exerted.force.z(), -0.8 * expected, 1e-14);
    EXPECT_NEAR(exerted.moment.z(), -0.5 * shape.thickness * 0.6 * expected, 1e-14);
    state.rotation = turned(std::numbers::pi, Vec3::UnitX());
    EXPECT_NEAR((drag(water, state).force - exerted.force).norm(), 0, 1e-12);
}

TEST(Drag, HeaveDragIsQuadraticPlusAFractionOfCritical) {
    const Water water = still_water();
    ElementState state;
    state.velocity = {0, -0.2, 0};
    const double area = shape.side * shape.side;
    const double critical = 2 * std::sqrt(1000 * gravity * area * mass_of(930));
    const double expected = 0.5 * 1000 * water.heave_drag * area * 0.04 + water.heave_damping * critical * 0.2;
    const Wrench exerted = drag(water, state);
    EXPECT_NEAR(exerted.force.y(), expected, 1e-12);
    EXPECT_NEAR(exerted.moment.norm(), 0, 1e-14);
}

TEST(Drag, CriticalDampingCountsTheAddedMass) {
    Water water = still_water();
    water.heave_drag = 0;
    water.added_mass = 3;
    ElementState state;
    state.velocity = {0, -0.2, 0};
    const double critical = 2 * std::sqrt(1000 * gravity * shape.side * shape.side * 4 * mass_of(930));
    EXPECT_NEAR(drag(water, state).force.y(), water.heave_damping * critical * 0.2, 1e-12);
}

// Waves: an element alone radiates as a plate of its own size, or as much as it is told; under water and dry not at
// all.
TEST(Drag, MakesWavesOnlyWhereIceCutsTheSurface) {
    Water water = still_water();
    water.heave_damping_from = WaterFrom::outline;
    water.heave_drag = 0;
    ElementState state;
    state.position.y() = 0.5 * shape.thickness - draught_of(930);
    state.velocity = {0, -0.2, 0};
    const std::vector<ElementWater> alone =
        water_of_piece(std::vector<Vec2>{{0, 0}}, shape.side, draught_of(930), {.density = 1000, .gravity = gravity});
    EXPECT_NEAR(drag(water, state).force.y(), alone[0].damping * 0.2, 1e-12);
    const WaterModel model(water, gravity, shape, mass_of(930), radius, speed);
    const double buoyant = buoyancy(state).force.y();
    EXPECT_NEAR(model.wrench(state, 0, 7.0).force.y() - buoyant, 7.0 * 0.2, 1e-12);
    state.position.y() = -0.5 * shape.thickness - 1e-6;
    EXPECT_NEAR(drag(water, state).force.y(), 0, 1e-12);
    state.position.y() = -3;
    EXPECT_NEAR(drag(water, state).force.y(), 0, 1e-12);
    // Half under: the two columns that cut the surface damp.
    state.position.y() = -0.5 * shape.thickness;
    state.rotation = turned(0.05, Vec3::UnitZ());
    EXPECT_NEAR((model.wrench(state, 0, 8.0).force - model.wrench(state, 0, 0.0).force).dot(state.rotation.col(1)),
                4.0 * 0.2 * std::cos(0.05), 1e-12);
}

// Linear part alone: the moment of four dampers c/4 at ±L/√12 is c L²/12 times the angular velocity.
TEST(Drag, RollIsDampedLikeHeave) {
    Water water = still_water();
    water.heave_drag = 0;
    water.skin_drag = 0;
    ElementState state;
    state.angular_velocity = {0.1, 0, 0};
    const double side = shape.side;
    const double damping = 2 * water.heave_damping * std::sqrt(1000 * gravity * side * side * mass_of(930));
    EXPECT_NEAR(drag(water, state).moment.x(), -damping * side * side / 12 * 0.1, 1e-13);
}

TEST(Drag, AFloeAheadOfTheStructureIsPushedAway) {
    ElementState state;
    state.position = {2.0, -0.015, 0};
    state.exposed_edges = 15;
    EXPECT_GT(drag({}, state).force.x(), 0);
    state.position.x() = -2.0;
    EXPECT_GT(drag({}, state).force.x(), 0);  // and drawn along behind it
    state.position = {0, -0.015, 2.0};
    EXPECT_LT(drag({}, state).force.x(), 0);  // and back past its sides
}

}  // namespace water_model_test
}  // namespace floes
