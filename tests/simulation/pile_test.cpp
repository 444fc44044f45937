// Broken ice comes to rest: heaps on a bed, and under a cover in water. What they press with, and that they stay.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "core/units.hpp"
#include "shapes/convex_solid.hpp"
#include "shapes/elements.hpp"
#include "simulation/simulation.hpp"
#include "support/crushing_ice.hpp"
#include "support/level_ice.hpp"
#include "water/water_model.hpp"
#include "world/world.hpp"

namespace floes {
namespace pile_test {

constexpr double gravity = 9.81;
constexpr double half_thickness = 0.02;
constexpr double density = 900;
constexpr double tolerance = 1e-4;  // m/s

WorldDefinition definition() {
    WorldDefinition made{.time_step = 0.01, .iterations = 500, .tolerance = tolerance, .solver = SolverKind::direct};
    made.contact = test::crushing_ice(46e3, 0.3, 0.1);
    return made;
}

/// Cells of ice, of 0.1 m.
struct Heap {
    World world{definition()};
    std::vector<ElementDefinition> cells;
    std::vector<BodyId> bodies;
    std::vector<WaterModel> water;

    void add(const Vec3& place, const CutElement& cell) {
        ElementDefinition made;
        made.corners = cell.corners;
        made.half_thickness = half_thickness;
        made.mass = density * cell.area * 2 * half_thickness;
        made.pose = {place,
                     Quat(Eigen::AngleAxisd(0.3 * static_cast<double>(cells.size()), Vec3(0.2, 1, 0.1).normalized()))};
        bodies.push_back(world.add_element(made));
        cells.push_back(made);
        const Water still{.flow = WaterFlow::still};
        water.emplace_back(still, gravity, cell, 2 * half_thickness, made.mass, 0.0, 0.0);
    }

    double mass() const {
        double sum = 0;
        for (const ElementDefinition& cell : cells) sum += cell.mass;
        return sum;
    }

    /// The largest speed of a cell, m/s.
    double speed() const {
        double most = 0;
        for (const BodyId body : bodies) most = std::max(most, world.state(body).velocity.norm());
        return most;
    }

    /// Height of the highest corner above the plane y = 0, `up` +1, or of the lowest below it, -1; and of the last ones
    /// behind it.
    std::pair<double, double> reach(double up) const {
        double most = -1e9;
        double least = 1e9;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const BodyState state = world.state(bodies[i]);
            for (const Corner& corner : cells[i].corners)
                for (const double y : {-half_thickness, half_thickness}) {
                    const double at = up * (state.position + state.rotation * Vec3(corner.x, y, corner.z)).y();
                    most = std::max(most, at);
                    least = std::min(least, at);
                }
        }
        return {most, least};
    }

    void step(bool under_water) {
        for (std::size_t i = 0; under_water && i < bodies.size(); ++i) {
            const BodyState state = world.state(bodies[i]);
            world.apply(bodies[i], water[i].wrench({.position = state.position - Vec3(0, 100, 0),
                                                    .rotation = state.rotation,
                                                    .velocity = state.velocity,
                                                    .angular_velocity = state.angular_velocity},
                                                   0));
        }
        world.step();
    }
};

/// Thirty cells in a tower, on one another with gaps, on the bed, `up` +1, or below a cover of ice at y = 0.
Heap tower(double up) {
    Heap heap;
    heap.world.add_plane({.normal = {0, up, 0}, .friction = 0.3});
    const double half = 0.35;
    const CutFloe cut = cut_into_cells(Outline{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, 0.1);
    for (std::size_t i = 0; i < 30; ++i) {
        const CutElement& cell = cut.elements.at(i % cut.elements.size());
        const double k = static_cast<double>(i);
        heap.add({0.14 * (static_cast<double>(i % 3) - 1), up * (0.08 + 0.07 * std::floor(k / 6)),
                  0.14 * (static_cast<double>(i / 3 % 2) - 0.5)},
                 cell);
    }
    return heap;
}

class PileOf : public testing::TestWithParam<double> {};

// Dry under gravity, and in water under a tenth of it upwards: after fifteen seconds nothing falls any more, all of the
// weight or lift is on the plane, and no cell is behind it. What is left is the solver's: where its sweeps end at a
// tolerance, a cell that is hardly held creeps at up to some of these.
TEST_P(PileOf, ComesToRest) {
    const double up = GetParam();
    const bool under_water = up < 0;
    Heap heap = tower(up);
    for (int step = 0; step < 1500; ++step) heap.step(under_water);
    double fastest = 0;
    for (int step = 0; step < 500; ++step) {
        heap.step(under_water);
        fastest = std::max(fastest, heap.speed());
    }
    RecordProperty("fastest_m_s", std::to_string(fastest));
    EXPECT_LT(fastest, 5 * tolerance);
    const double load = under_water ? heap.mass() * (1000 / density - 1) * gravity : heap.mass() * gravity;
    EXPECT_NEAR(-up * heap.world.contact_force(BodyId(0)).y() / load, 1, 1e-3);
    const auto [height, through] = heap.reach(up);
    RecordProperty("height_m", std::to_string(height));
    EXPECT_GT(through, -half_thickness) << "corners that fell on the plane are crushed, and no cell is behind it";
    EXPECT_GT(height, 4 * half_thickness) << "more than two layers";
    EXPECT_LT(height, 0.4) << "no tower";
}

INSTANTIATE_TEST_SUITE_P(Pile, PileOf, testing::Values(1.0, -1.0));

// W tan α, where nothing rubs.
TEST(Pile, OnASmoothSlopePressesAWallAsAWedge) {
    for (const double angle : {0.3, 0.8}) {
        World world(definition());
        world.add_plane({.normal = {-std::sin(angle), std::cos(angle), 0}});
        const BodyId wall = world.add_plane({.normal = {1, 0, 0}});
        ElementDefinition made{.corners = corners_of(0.1, 0.1), .half_thickness = 0.02, .mass = 0.72};
        made.pose.orientation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
        made.pose.position = made.pose.orientation * Vec3(0.1 + 0.04 * std::tan(angle), 0.02, 0);
        const BodyId body = world.add_element(made);
        for (int step = 0; step < 1000; ++step) world.step();
        EXPECT_NEAR(-world.contact_force(wall).x(), 0.72 * gravity * std::tan(angle), 1e-3) << angle;
        EXPECT_LT(world.state(body).velocity.norm(), 1e-6);
    }
}

// Along the slope W (sin α + μ cos α) / (cos α - μ sin α) by a horizontal force: a hundredth less does not move it up.
TEST(Pile, IsPushedUpASlopeByItsWeightAndFriction) {
    const double angle = 0.7;
    const double friction = 0.15;
    const double expected =
        (std::sin(angle) + friction * std::cos(angle)) / (std::cos(angle) - friction * std::sin(angle));
    for (const double share : {0.99, 1.01}) {
        World world(definition());
        world.add_plane({.normal = {-std::sin(angle), std::cos(angle), 0}, .friction = friction});
        ElementDefinition made{.corners = corners_of(0.1, 0.1), .half_thickness = 0.02, .mass = 0.72};
        made.pose.orientation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
        made.pose.position = made.pose.orientation * Vec3(0, 0.02, 0);
        const BodyId body = world.add_element(made);
        Vec3 start = Vec3::Zero();
        for (int step = 0; step < 500; ++step) {
            if (step == 10) start = world.state(body).position;  // ice that crushes bears from its first overlap on
            // At the foot of its middle on the slope, where it tips it about nothing.
            const Vec3 force(share * expected * made.mass * gravity, 0, 0);
            const Vec3 arm = world.state(body).rotation * Vec3(0, -0.02, 0);
            world.apply(body, {force, arm.cross(force)});
            world.step();
        }
        const double way = (world.state(body).position - start).x();
        if (share < 1)
            EXPECT_LT(std::abs(way), 1e-4);
        else
            EXPECT_GT(way, 0.3);
    }
}

// ρ_i/ρ_w of its height.
TEST(Pile, FloatsAsDeepAsItIsHeavy) {
    World world(definition());
    const CutElement plate = cut_into_cells(corners_of(0.15, 0.15), 0.3).elements.at(0);
    const Water still{.flow = WaterFlow::still};
    const int layers = 6;
    const double mass = density * plate.area * 2 * half_thickness;
    const WaterModel water(still, gravity, plate, 2 * half_thickness, mass, 0.0, 0.0);
    std::vector<BodyId> pile;
    for (int k = 0; k < layers; ++k) {
        ElementDefinition made{.corners = plate.corners, .half_thickness = half_thickness, .mass = mass};
        made.pose.position = {0, 2.001 * half_thickness * (k - layers) + half_thickness, 0};
        pile.push_back(world.add_element(made));
    }
    for (int step = 0; step < 3000; ++step) {
        for (const BodyId body : pile) {
            const BodyState state = world.state(body);
            world.apply(body, water.wrench({.position = state.position,
                                            .rotation = state.rotation,
                                            .velocity = state.velocity,
                                            .angular_velocity = state.angular_velocity},
                                           0));
        }
        world.step();
    }
    const double height = 2 * half_thickness * layers;
    const double lowest = world.state(pile.front()).position.y() - half_thickness;
    const double highest = world.state(pile.back()).position.y() + half_thickness;
    EXPECT_NEAR(highest - lowest, height, 0.01 * height) << "its layers lie on one another";
    EXPECT_NEAR(-lowest / height, density / 1000, 0.005);
}

// Ride-up: a layer of loose pieces on a plate of the hull, pushed up from below, takes W (sin α + μ cos α) along the
// plate, which then bears W cos α (sin α + μ cos α) horizontally.
TEST(Pile, ALayerRidesUpAPlateByItsWeightAndFriction) {
    const double angle = 50 * unit::degree;
    const double friction = 0.1;
    const Vec3 up_slope(std::cos(angle), std::sin(angle), 0);
    const Vec3 out(-std::sin(angle), std::cos(angle), 0);
    for (const double share : {0.99, 1.01}) {
        World world(definition());
        const double far = 20;
        const std::vector<Vec3> corners{Vec3(0, 0, -1) - far * up_slope,
                                        Vec3(0, 0, -1) + far * up_slope,
                                        Vec3(0, 0, 1) - far * up_slope,
                                        Vec3(0, 0, 1) + far * up_slope,
                                        Vec3(far, -far, -1),
                                        Vec3(far, -far, 1)};
        const BodyId plate =
            world.add_structure(std::vector<ConvexSolid>{ConvexSolid(convex_hull(corners))}, {Vec3::Zero()});
        for (const double side : {-1.0, 1.0})  // a row of pieces that is pressed gives way sideways
            world.add_plane({.point = {0, 0, 0.1 * side}, .normal = {0, 0, -side}});
        std::vector<BodyId> layer;
        double weight = 0;
        for (int k = 0; k < 6; ++k) {
            ElementDefinition piece{.corners = corners_of(0.1, 0.1), .half_thickness = half_thickness, .mass = 0.72};
            piece.pose.orientation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
            piece.pose.position = half_thickness * out + 0.2 * k * up_slope;
            weight += piece.mass * gravity;
            layer.push_back(world.add_element(piece));
        }
        const double along = weight * (std::sin(angle) + friction * std::cos(angle));
        Vec3 start = Vec3::Zero();
        Vec3 borne = Vec3::Zero();
        for (int step = 0; step < 500; ++step) {
            if (step == 100) start = world.state(layer.back()).position;  // pressed together, and moving or not
            world.apply(layer.front(), {share * along * up_slope, Vec3::Zero()});
            world.step();
            if (step >= 100) borne += world.contact_force(plate) / 400;
        }
        const double way = (world.state(layer.back()).position - start).dot(up_slope);
        if (share < 1) {
            EXPECT_LT(std::abs(way), 2e-3);
        } else {
            EXPECT_GT(way, 0.3);
            EXPECT_NEAR(borne.x() / (std::cos(angle) * along), 1, 5e-3);
        }
        for (const BodyId piece : layer) {
            EXPECT_NEAR(world.state(piece).position.dot(out), half_thickness, 1e-3) << "it lies on the plate";
        }
    }
}

// A sheet that is pushed through a pile: it takes the friction of ice on ice times the weight on it, which the smooth
// wall then bears that holds the pile back.
TEST(Pile, BrakesASheetBelowItByItsWeightTimesFriction) {
    Heap heap;
    const BodyId wall = heap.world.add_plane({.point = {0.6, 0, 0}, .normal = {-1, 0, 0}});
    for (const double side : {-1.0, 1.0}) heap.world.add_plane({.point = {0, 0, 0.25 * side}, .normal = {0, 0, -side}});
    const BodyId sheet = heap.world.add_sliding_box(
        {.half_extents = {3, half_thickness, 0.3}, .position = {0, -half_thickness, 0}, .mass = 1e6, .axis = 0});
    BodyState pushed = heap.world.state(sheet);
    pushed.velocity = {0.05, 0, 0};
    heap.world.place(sheet, pushed);
    const CutFloe cut = cut_into_cells(Outline{{-0.35, -0.35}, {0.35, -0.35}, {0.35, 0.35}, {-0.35, 0.35}}, 0.1);
    for (std::size_t i = 0; i < 30; ++i) {
        heap.add({0.14 * static_cast<double>(i % 3), 0.08 + 0.07 * std::floor(static_cast<double>(i) / 6),
                  0.14 * (static_cast<double>(i / 3 % 2) - 0.5)},
                 cut.elements.at(i % cut.elements.size()));
    }
    double borne = 0;
    double weight = 0;
    for (int step = 0; step < 3000; ++step) {
        heap.step(false);
        if (step < 1500) continue;
        borne += heap.world.contact_force(wall).x() / 1500;
        weight -= heap.world.contact_force(sheet).y() / 1500;
    }
    EXPECT_NEAR(weight / (heap.mass() * gravity), 1, 1e-3);
    EXPECT_LT(borne / (0.3 * weight), 1.001);
    EXPECT_GT(borne / (0.3 * weight), 0.97) << "pieces that still turn over slide less";
    EXPECT_GT(heap.reach(1).first, 4 * half_thickness) << "more than two layers";
}

// A strip that a wall bends down grounds on a shallow bed, which then bears weight and thrust; a saved run goes on with
// the same bits.
TEST(Bed, BearsIceThatIsPushedUnder) {
    Scenario scenario = test::level_strip(120 * std::numbers::pi / 180, 0.3);
    scenario.structure.start = -0.003;
    scenario.structure.speed = 0.05;
    scenario.water.depth = 0.12;
    const Arrangement sheet = make_arrangement(scenario, 1, 0);
    Simulation whole(scenario, sheet);
    Simulation first(scenario, sheet);
    while (whole.time() < 6) {
        whole.step();
        if (whole.time() < 4) first.step();
    }
    const BedHistory& bed = whole.bed_loads();
    ASSERT_EQ(bed.weight.size(), whole.loads().surge.size());
    EXPECT_EQ(bed.weight.front(), 0);
    EXPECT_GT(*std::ranges::max_element(bed.weight), 1);
    EXPECT_LT(*std::ranges::min_element(bed.surge), -1) << "the wall pushes it over the bed";
    for (std::size_t k = 0; k < bed.weight.size(); ++k)
        EXPECT_LE(std::abs(bed.surge[k]), scenario.water.bed_friction * bed.weight[k] + 1e-3) << k;
    EXPECT_GT(*std::ranges::max_element(bed.grounded), 0.01);
    double lowest = 0;
    for (const BodyState& one : whole.element_states()) lowest = std::min(lowest, one.position.y());
    EXPECT_GT(lowest, -0.12);
    Simulation second(scenario, sheet);
    second.set(first.saved());
    while (second.steps() < whole.steps()) second.step();
    EXPECT_EQ(second.bed_loads().weight, bed.weight);
    EXPECT_EQ(second.loads().surge, whole.loads().surge);
}

}  // namespace pile_test
}  // namespace floes
