// Hulls that heave, pitch and roll, against closed forms and what others published.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/hydrostatics.hpp"
#include "simulation/structure_motion.hpp"
#include "support/published_lines.hpp"

namespace floes {
namespace floating_motion_test {

constexpr double pi = std::numbers::pi;
constexpr double density = 1025;
constexpr double gravity = 9.80665;

int number(Motion motion) {
    return static_cast<int>(motion);
}

Vec6 along(Motion motion, double value) {
    Vec6 found = Vec6::Zero();
    found[number(motion)] = value;
    return found;
}

/// The spar of OC3 (NREL/TP-500-47535): its steel, its lines, and, of the water that moves with it, that of its
/// displaced volume in surge and sway, which is right to a few percent for so slender a body.
Shape spar() {
    return Shape(std::vector<ProfilePoint>{{-120, 4.7}, {-12, 4.7}, {-4, 3.25}, {10, 3.25}});
}

Moorings spar_moorings() {
    Moorings found{.free = {true, true, true, true, true, true},
                   .mass = 8.066e6,  // with the turbine
                   .height = -78,
                   .gyration = 4.5,
                   .pitch_gyration = 50,
                   .roll_gyration = 50,
                   .added = {8e6, 8e6, 0, 2.4e5, 3.8e10, 3.8e10},
                   .yaw = 9.834e7};
    found.added_mass.assign(6, std::vector<double>(6, 0.0));
    found.added_mass[0][4] = found.added_mass[4][0] = -8e6 * 62;
    found.added_mass[1][3] = found.added_mass[3][1] = 8e6 * 62;
    found.hanging = test::oc3_lines();
    return found;
}

/// With springs in place of its lines, so that all is linear.
Moorings spar_on_springs() {
    Moorings found = spar_moorings();
    found.hanging.clear();
    found.surge = found.sway = 41180;
    return found;
}

Mat6 water_of(const Shape& shape, const Moorings& moorings) {
    return water_stiffness(hydrostatics(shape), density, gravity, moorings.mass, moorings.height);
}

// The ballast stays when a line breaks: what the line pulled down is then too little.
TEST(FloatingMotion, RisesAndTrimsWhenALineBreaks) {
    Moorings moorings = spar_moorings();
    const LinePull at_rest = pull(moorings, 0, Vec6::Zero());
    moorings.hanging[0].break_load = 1.001 * at_rest.tension;
    const double step = 0.02;
    MooredMotion motion(moorings, water_of(spar(), moorings), step);
    int k = 0;
    for (; k < 2000 && std::isnan(motion.state().broken_at[0]); ++k)
        motion.advance(along(Motion::surge, at_rest.force[0] > 0 ? -1e5 : 1e5), step * (k + 1));
    ASSERT_FALSE(std::isnan(motion.state().broken_at[0]));
    const double heave = motion.state().velocity[number(Motion::heave)];
    const double second = step * 50;
    for (int i = 0; i < 50; ++i, ++k) motion.advance(Vec6::Zero(), step * (k + 1));
    const double expected = -at_rest.force[number(Motion::heave)] / (moorings.mass + 2.4e5) * second;
    ASSERT_GT(expected, 0);
    EXPECT_NEAR((motion.state().velocity[number(Motion::heave)] - heave) / expected, 1, 0.1);
}

// RAFT's test of the OC3 spar has 125.5, 30.8, 29.6 s in surge, heave and pitch; surge and pitch swing together, and by
// itself surge would have another period.
TEST(FloatingMotion, PeriodsOfTheOC3SparAreThePublishedOnes) {
    const Moorings moorings = spar_moorings();
    const std::vector<NaturalMode> modes = natural_modes(moorings, water_of(spar(), moorings));
    ASSERT_EQ(modes.size(), 6);
    EXPECT_EQ(modes[0].motion, Motion::surge);
    EXPECT_NEAR(modes[0].period / 125.5, 1, 0.02);
    EXPECT_EQ(modes[3].motion, Motion::heave);
    EXPECT_NEAR(modes[3].period / 30.8, 1, 0.02);
    EXPECT_EQ(modes[4].motion, Motion::pitch);
    EXPECT_NEAR(modes[4].period / 29.6, 1, 0.05);
}

/// A semi-submersible by what others published of it, without a shape of its own.
struct Published {
    Moorings moorings{};
    Mat6 water = Mat6::Zero();
};

/// ρgA of the waterplane in heave, and of pitch and roll what the water gives without the weight, less what the weight
/// takes.
Mat6 water_of(const Moorings& moorings, double heave, double turns_without_weight) {
    Mat6 found = Mat6::Zero();
    found(number(Motion::heave), number(Motion::heave)) = heave;
    for (const Motion turn : {Motion::pitch, Motion::roll})
        found(number(turn), number(turn)) = turns_without_weight - moorings.mass * gravity * moorings.height;
    return found;
}

/// OC4 (NREL/TP-5000-60601: platform 1.3473e7 kg at -13.46 m, 6.827e9 and 1.226e10 kg m² about its centre) with tower
/// and turbine (249,718 kg at 43.4 m, 350,000 kg at 89.6 m); C33 and C44 of its report, added mass of RAFT's WAMIT file
/// (marin_semi.1) at 125.7 s.
Published oc4() {
    const double mass = 1.3473e7 + 249718 + 350000;
    const double height = (-1.3473e7 * 13.46 + 249718 * 43.4 + 350000 * 89.6) / mass;
    const double about_water =
        6.827e9 + 1.3473e7 * 13.46 * 13.46 + 1.1824e8 + 249718 * 43.4 * 43.4 + 350000 * 89.6 * 89.6;
    const double gyration = std::sqrt(about_water / mass - height * height);
    Published found;
    found.moorings = {.free = {true, true, true, true, true, true},
                      .mass = mass,
                      .height = height,
                      .gyration = std::sqrt(1.226e10 / mass),
                      .pitch_gyration = gyration,
                      .roll_gyration = gyration,
                      .added = {8.749e6, 8.749e6, 6.433e9, 1.517e7, 7.629e9, 7.629e9}};
    found.moorings.added_mass.assign(6, std::vector<double>(6, 0.0));
    found.moorings.added_mass[0][4] = found.moorings.added_mass[4][0] = -1.077e8;
    found.moorings.added_mass[1][3] = found.moorings.added_mass[3][1] = 1.077e8;
    found.moorings.hanging = test::oc4_lines();
    found.water = water_of(found.moorings, 3.836e6, -3.776e8);
    return found;
}

double period(const Published& hull, Motion motion) {
    for (const NaturalMode& mode : natural_modes(hull.moorings, hull.water))
        if (mode.motion == motion) return mode.period;
    return 0;
}

// RAFT with the same WAMIT file: 113, 17.4, 25.0, 79.8 s in surge, heave, pitch and yaw; tests in the tank 107, 17.5,
// 26.8, 82 s.
TEST(FloatingMotion, PeriodsOfTheOC4SemiAreThePublishedOnes) {
    const Published hull = oc4();
    EXPECT_NEAR(period(hull, Motion::surge) / 113, 1, 0.02);
    EXPECT_NEAR(period(hull, Motion::sway) / 113, 1, 0.02);
    EXPECT_NEAR(period(hull, Motion::heave) / 17.4, 1, 0.02);
    EXPECT_NEAR(period(hull, Motion::pitch) / 25.0, 1, 0.03);
    EXPECT_NEAR(period(hull, Motion::roll) / 25.0, 1, 0.03);
    EXPECT_NEAR(period(hull, Motion::yaw) / 79.8, 1, 0.02);
    const Mat6 lines = hull.moorings.stiffness();
    EXPECT_NEAR(lines(0, 0) / 7.08e4, 1, 0.002) << "OC4's report";
    EXPECT_NEAR(lines(3, 3) / 1.91e4, 1, 0.003);
    EXPECT_NEAR(lines(5, 5) / 8.73e7, 1, 0.002);
}

// The IEA 15 MW semi-submersible: 20,093 t, C33/ρg 443.05 m² and added mass of its WAMIT file (NREL/ROSCO). Published
// (NREL/TP-5000-76773): 0.007 Hz in surge, 0.049 Hz in heave, 0.011 Hz in yaw.
TEST(FloatingMotion, FrequenciesOfTheIEA15SemiAreThePublishedOnes) {
    Published hull;
    hull.moorings = {.free = {true, false, false, true, false, false}, .mass = 20.093e6};
    hull.moorings.added[at(Motion::surge)] = 1.26e7;   // of long periods
    hull.moorings.added[at(Motion::heave)] = 2.763e7;  // at 20 s
    hull.moorings.hanging = test::iea15_lines();
    hull.water = water_of(hull.moorings, 443.05 * density * gravity, 0);
    EXPECT_NEAR(1 / period(hull, Motion::surge), 0.007, 0.0005);
    EXPECT_NEAR(1 / period(hull, Motion::heave), 0.049, 0.0005);
}

// DeepCwind in surge, released 3.391 m aside: extremes of a reference series (HydroChrono demos/, NREL_LC_42). Its mass
// is 1.4196e7 kg; its springs and damping are not said, so that three numbers are fitted: the period, and linear and
// quadratic damping. The eleven extremes follow.
TEST(FloatingMotion, DecaysInSurgeAsDeepCwind) {
    const double mass = 1.4196e7 + 8.749e6;
    Moorings moorings{.free = {true, false, false}, .mass = mass, .damping = 0.033};
    moorings.surge = mass * std::pow(2 * pi / 108.2, 2);
    moorings.quadratic[at(Motion::surge)] = 0.025 * mass;
    const double step = 0.1;
    MooredMotion motion(moorings, Mat6::Zero(), step);
    motion.place({.offset = along(Motion::surge, -3.391)});
    std::vector<double> extremes;
    double before = 0;
    for (int k = 0; k < 6000; ++k) {
        motion.advance(Vec6::Zero(), step * (k + 1));
        const double speed = motion.state().velocity[0];
        if (k > 0 && speed * before < 0) extremes.push_back(std::abs(motion.state().offset[0]));
        before = speed;
    }
    const std::vector<double> published{2.765, 2.263, 1.94, 1.659, 1.396, 1.196, 1.063, 0.9304, 0.7905, 0.6932, 0.629};
    ASSERT_GE(extremes.size(), published.size());
    for (std::size_t k = 0; k < published.size(); ++k) EXPECT_NEAR(extremes[k] / published[k], 1, 0.03) << k;
}

// Upright cylinder: T = 2π √((m + A) / (ρ g A_w)) in heave, 2π √((m k² + I) / (ρ g ∇ GM)) in roll; a box by GM = B²/12T
// + T/2 - KG.
TEST(FloatingMotion, PeriodsAreThoseOfMassAndWaterplane) {
    const Shape cylinder(HullKind::cylinder, {.diameter = 10, .draught = 4, .freeboard = 2});
    const double mass = density * pi * 25 * 4;
    Moorings moorings{.free = {false, false, false, true, false, true}, .mass = mass, .height = -2, .roll_gyration = 3};
    moorings.added[at(Motion::heave)] = 0.4 * mass;
    const std::vector<NaturalMode> modes = natural_modes(moorings, water_of(cylinder, moorings));
    EXPECT_NEAR(modes[0].period / (2 * pi * std::sqrt(1.4 * mass / (density * gravity * pi * 25))), 1, 1e-6);
    const double gm = 25.0 / (4 * 4);  // G is B
    EXPECT_NEAR(modes[1].period / (2 * pi * std::sqrt((9 + 4) / (gravity * gm))), 1, 1e-4) << "about the waterline";

    const Shape box(HullKind::barge,
                    {.length = 40, .beam = 20, .draught = 5, .freeboard = 3, .stem = pi / 2, .flare = pi / 2});
    Moorings barge{.free = {false, false, false, false, true, true},
                   .mass = density * 4000,
                   .height = 1,
                   .pitch_gyration = 11,
                   .roll_gyration = 7};
    const Mat6 held = water_of(box, barge);
    const double kg = 5 + 1;
    const double weight = density * gravity * 4000;
    EXPECT_NEAR(held(5, 5) / (weight * (20.0 * 20 / (12 * 5) + 2.5 - kg)), 1, 1e-9);
    EXPECT_NEAR(held(4, 4) / (weight * (40.0 * 40 / (12 * 5) + 2.5 - kg)), 1, 1e-9);
    EXPECT_NEAR(held(3, 3) / (density * gravity * 800), 1, 1e-9);
    barge.height = 8;
    EXPECT_TRUE(std::isnan(natural_modes(barge, water_of(box, barge))[1].period)) << "it rolls over";
}

// A force at a height heels by its moment over the stiffness, and coupled springs by their common solution.
TEST(FloatingMotion, HeelsUnderALoadAtAHeight) {
    Moorings moorings = spar_moorings();
    moorings.damping = 0.3;
    const Mat6 water = water_of(spar(), moorings);
    Vec6 load = along(Motion::surge, -1e4);
    load[number(Motion::pitch)] = 1e4 * 10;  // at 10 m height, on the bow
    load[number(Motion::heave)] = 1e4;
    MooredMotion motion(moorings, water, 0.5);
    for (int k = 0; k < 20000; ++k) motion.advance(load, 0.5 * (k + 1));
    const Mat6 stiffness = water + moorings.stiffness();
    const Vec6 expected = stiffness.partialPivLu().solve(load);
    const Vec6& found = motion.state().offset;
    EXPECT_NEAR(found[number(Motion::heave)] / expected[number(Motion::heave)], 1, 0.005);
    EXPECT_NEAR(found[number(Motion::pitch)] / expected[number(Motion::pitch)], 1, 0.005);
    EXPECT_NEAR(found[number(Motion::surge)] / expected[number(Motion::surge)], 1, 0.01) << "lines stiffen with offset";
    EXPECT_GT(found[number(Motion::pitch)], 0) << "ice on the bow above the water lifts it";
}

// Released in a natural mode it comes back after its period, whatever couples its motions: the exponential is exact.
TEST(FloatingMotion, SwingsWithTheEigenvalues) {
    const Moorings moorings = spar_on_springs();
    const Mat6 water = water_of(spar(), moorings);
    const Mat6 stiffness = moorings.held(water);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(stiffness),
                                                                           Eigen::MatrixXd(moorings.inertia()));
    for (int mode = 0; mode < 6; ++mode) {
        const double period = 2 * pi / std::sqrt(solver.eigenvalues()[mode]);
        const Vec6 shape = solver.eigenvectors().col(mode).normalized();
        constexpr int steps = 100;
        MooredMotion motion(moorings, water, period / steps);
        motion.place({.offset = shape});
        for (int k = 0; k < steps / 4; ++k) motion.advance(Vec6::Zero(), 0);
        EXPECT_LT(motion.state().offset.norm(), 1e-8) << mode;
        for (int k = steps / 4; k < steps; ++k) motion.advance(Vec6::Zero(), 0);
        EXPECT_LT((motion.state().offset - shape).norm(), 1e-8) << mode;
    }
}

// The work of the load is the energy of motion and springs, to rounding.
TEST(FloatingMotion, KeepsEnergy) {
    const Moorings moorings = spar_on_springs();
    const Mat6 water = water_of(spar(), moorings);
    const Mat6 stiffness = moorings.held(water);
    MooredMotion motion(moorings, water, 0.5);
    double work = 0;
    double worst = 0;
    double most = 0;
    for (int k = 0; k < 4000; ++k) {
        Vec6 load = along(Motion::surge, 1e5 * std::sin(0.05 * k));
        load[number(Motion::heave)] = 4e4 * std::sin(0.1 * k);
        load[number(Motion::pitch)] = 2e6 * std::cos(0.11 * k);
        load[number(Motion::roll)] = 1e6 * std::cos(0.07 * k);
        const Vec6 before = motion.state().offset;
        motion.advance(load, 0);
        const MooredState& now = motion.state();
        work += load.dot(now.offset - before);
        const double energy =
            0.5 * now.velocity.dot(moorings.inertia() * now.velocity) + 0.5 * now.offset.dot(stiffness * now.offset);
        most = std::max(most, energy);
        worst = std::max(worst, std::abs(energy - work));
    }
    EXPECT_LT(worst, 1e-9 * most);
}

// Free decay of a half-submerged sphere of 5 m radius from 1 m, a linear program's extremes (IEA OES Task 10;
// HydroChrono demos/): here with A33/m = 0.427 and 0.084 of critical damping, the values at its own frequency, in place
// of memory.
TEST(FloatingMotion, DecaysAsTheSphereOfOES) {
    const double radius = 5;
    std::vector<ProfilePoint> arc;
    for (int i = 1; i <= 36; ++i) {
        const double angle = pi * (i - 18) / 37.0;
        arc.push_back({radius * std::sin(angle), radius * std::cos(angle)});
    }
    const double mass = density * 2 * pi / 3 * radius * radius * radius;
    const Shape sphere(arc);
    Moorings moorings{.free = {false, false, false, true}, .mass = mass, .height = -2, .damping = 0.084};
    moorings.added[at(Motion::heave)] = 0.427 * mass;
    const double step = 0.01;
    MooredMotion motion(moorings, water_of(sphere, moorings), step);
    motion.place({.offset = along(Motion::heave, 1)});
    std::vector<double> extremes;
    double before = 0;
    for (int k = 0; k < 800; ++k) {
        motion.advance(Vec6::Zero(), step * (k + 1));
        const double speed = motion.state().velocity[number(Motion::heave)];
        if (k > 0 && speed * before < 0) extremes.push_back(motion.state().offset[number(Motion::heave)]);
        before = speed;
    }
    ASSERT_GE(extremes.size(), 3);
    EXPECT_NEAR(extremes[0], -0.874, 0.11) << "the first swing has less memory of waves";
    EXPECT_NEAR(extremes[1] / extremes[0], -0.651 / 0.874, 0.03);
    EXPECT_NEAR(extremes[2] / extremes[1], -0.496 / 0.651, 0.03);
    EXPECT_NEAR(natural_modes(moorings, water_of(sphere, moorings))[0].period / 4.37, 1, 0.02);
}

// Radiation damping by a matrix acts as the same damping by its share of the critical one.
TEST(FloatingMotion, DampingByAMatrixIsThatOfItsShare) {
    const Shape cylinder(HullKind::cylinder, {.diameter = 10, .draught = 4, .freeboard = 2});
    const double mass = density * pi * 25 * 4;
    Moorings shared{.free = {false, false, false, true}, .mass = mass, .damping = 0.1};
    const Mat6 water = water_of(cylinder, shared);
    Moorings given = shared;
    given.damping = 0;
    given.radiation_damping.assign(6, std::vector<double>(6, 0.0));
    given.radiation_damping[2][2] = 2 * 0.1 * std::sqrt(water(3, 3) * mass);
    MooredMotion one(shared, water, 0.1);
    MooredMotion other(given, water, 0.1);
    for (int k = 0; k < 200; ++k) {
        one.advance(along(Motion::heave, 1e4 * (k % 7)), 0);
        other.advance(along(Motion::heave, 1e4 * (k % 7)), 0);
    }
    EXPECT_NEAR(other.state().offset[3] / one.state().offset[3], 1, 1e-9);
}

}  // namespace floating_motion_test
}  // namespace floes
