#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "core/error.hpp"
#include "support/plate_forms.hpp"

namespace floes {
namespace plate_test {

/// dP/dw0 (N/m) under a point load: 8 sqrt(k D).
double point_load_slope(const FloatingPlate& plate, double elastic_modulus) {
    return 8 * std::sqrt(plate.foundation() * plate.flexural_rigidity(elastic_modulus));
}

// scipy.special.kerp at the same arguments.
TEST(Kelvin, AgreesWithScipy) {
    EXPECT_NEAR(kelvin_ker_prime(0.3), -3.2198652535539383, 1e-13);
    EXPECT_NEAR(kelvin_ker_prime(2.0), -0.10660096588105275, 1e-14);
    EXPECT_NEAR(kelvin_ker_prime(8.0), -0.0008797240991814695, 1e-11);
}

TEST(Kelvin, RefusesWhatTheSeriesCannotReach) {
    EXPECT_THROW(kelvin_ker_prime(0), InputError);
    EXPECT_THROW(kelvin_ker_prime(8.1), InputError);
    EXPECT_THROW(kelvin_ker_prime(std::nan("")), InputError);
}

TEST(FloatingPlate, HasThePapersCharacteristicLength) {
    const FloatingPlate ice{.thickness = 0.033};
    EXPECT_NEAR(ice.characteristic_length(30e6), 0.317, 5e-4);
    EXPECT_NEAR(ice.characteristic_length(60e6), 0.377, 5e-4);  // the paper: approximately 0.38 m
    EXPECT_NEAR(ice.characteristic_length(200e6), 0.509, 5e-4);
}

TEST(FloatingPlate, InvertsThePointLoad) {
    const FloatingPlate ice{.thickness = 0.030};
    for (const double modulus : {30e6, 60e6, 200e6})
        EXPECT_NEAR(modulus_from_point_slope(ice, point_load_slope(ice, modulus)), modulus, 1e-6 * modulus);
}

TEST(FloatingPlate, InvertsThePatchLoad) {
    const FloatingPlate ice{.thickness = 0.030};
    const double radius = 0.2 / std::sqrt(std::numbers::pi);
    for (const double modulus : {0.5e6, 30e6, 60e6, 200e6, 2e9})
        EXPECT_NEAR(modulus_from_patch_slope(ice, patch_load_slope(ice, modulus, radius), radius), modulus,
                    1e-9 * modulus);
}

TEST(FloatingPlate, ASmallPatchIsAPoint) {
    const FloatingPlate ice{.thickness = 0.030};
    EXPECT_NEAR(patch_load_slope(ice, 60e6, 1e-4) / point_load_slope(ice, 60e6), 1, 1e-6);
}

TEST(FloatingPlate, OneElementUnderTheLoadStiffensByNinePercentAt60MPa) {
    // w0 is lower by 4.1 %, so the point-load formula reads E higher by 8.8 %.
    const FloatingPlate ice{.thickness = 0.030};
    const double slope = patch_load_slope(ice, 60e6, 0.2 / std::sqrt(std::numbers::pi));
    EXPECT_NEAR(modulus_from_point_slope(ice, slope) / 60e6, 1.088, 1e-3);
}

TEST(FloatingPlate, RefusesASlopeThatWaterAloneExceeds) {
    EXPECT_THROW(modulus_from_patch_slope({.thickness = 0.030}, 300, 0.1128), InputError);
}

TEST(FloatingCantilever, ReadsMoreThanTheStrength) {
    EXPECT_NEAR(floating_cantilever_factor(60e6, 0.4, 0.033, 9810), 1.13, 5e-3);
    EXPECT_NEAR(floating_cantilever_factor(60e6, 0.6, 0.033, 9810), 1.70, 5e-3);
    EXPECT_NEAR(floating_cantilever_factor(60e12, 0.4, 0.033, 9810), 1, 1e-6);
}

TEST(Cantilever, NominalStrengthIsSixPLOverBHSquared) {
    EXPECT_DOUBLE_EQ(nominal_flexural_strength(2.0, 0.5, 0.2, 0.1), 6 * 2.0 * 0.5 / (0.2 * 0.01));
}

// A beam on water without thrust under a load at its end (Hetényi 1946): the largest moment V/λ exp(-π/4) sin(π/4) lies
// π/4 λ from it, and the end rises by 2 V λ/k, λ = (k/(4 D))^(1/4).
TEST(LiftedEdge, WithoutThrustIsHetenyis) {
    const FloatingPlate plate{0.05};
    const double modulus = 107e6;
    const double strength = 44e3;
    const double lambda = std::pow(plate.foundation() / (4 * plate.flexural_rigidity(modulus)), 0.25);
    const test::LiftedEdge edge = test::lifted_edge(plate, modulus, strength, 0, plate.thickness / 2);
    const double largest = std::exp(-std::numbers::pi / 4) * std::sqrt(0.5) / lambda;
    EXPECT_NEAR(edge.vertical, strength * plate.thickness * plate.thickness / 6 / largest, 1e-6);
    EXPECT_EQ(edge.horizontal, 0);
    EXPECT_NEAR(edge.distance, std::numbers::pi / 4 / lambda, 1e-9);
    EXPECT_NEAR(edge.lift, 2 * edge.vertical * lambda / plate.foundation(), 1e-9);
}

/// Finite differences of D w⁗ + H w″ + k w = 0 on 12 characteristic lengths, the far end clamped: the load at which
/// the lower fibre has the strength, by one solution, since it is linear in V for a thrust that is given.
double vertical_by_differences(const FloatingPlate& plate, double modulus, double strength, double thrust,
                               double end_moment) {
    constexpr int n = 600;
    const double d = plate.flexural_rigidity(modulus);
    const double step = 12 * plate.characteristic_length(modulus) / n;
    // Nodes -2 to n, of which the two behind the edge are for its conditions; the last two are 0.
    const int size = n + 1;
    const auto solve = [&](double vertical, double moment) {
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
        Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
        const auto put = [&](int row, int node, double value) {
            if (node + 2 < size) a(row, node + 2) += value;
        };
        const double fourth = d / std::pow(step, 4);
        for (int i = 0; i < n - 1; ++i) {
            for (const auto& [k, c] : {std::pair(-2, 1.0), {-1, -4.0}, {0, 6.0}, {1, -4.0}, {2, 1.0}})
                put(i + 2, i + k, fourth * c);
            for (const auto& [k, c] : {std::pair(-1, 1.0), {0, -2.0}, {1, 1.0}})
                put(i + 2, i + k, thrust / (step * step) * c);
            put(i + 2, i, plate.foundation());
        }
        for (const auto& [k, c] : {std::pair(-1, 1.0), {0, -2.0}, {1, 1.0}}) put(0, k, d / (step * step) * c);
        b(0) = -moment;
        for (const auto& [k, c] : {std::pair(-2, -0.5), {-1, 1.0}, {1, -1.0}, {2, 0.5}})
            put(1, k, d / std::pow(step, 3) * c);
        put(1, 1, thrust / (2 * step));
        put(1, -1, -thrust / (2 * step));
        b(1) = vertical;
        const Eigen::VectorXd w = a.partialPivLu().solve(b);
        Eigen::VectorXd bending(n - 2);
        for (int i = 0; i < n - 2; ++i) bending(i) = d * (w(i + 1) - 2 * w(i + 2) + w(i + 3)) / (step * step);
        return bending;
    };
    const Eigen::VectorXd by_load = solve(1, 0);
    const Eigen::VectorXd by_moment = solve(0, end_moment);
    const double t = plate.thickness;
    double low = 0;
    double high = 1e4;
    for (int i = 0; i < 60; ++i) {
        const double v = (low + high) / 2;
        const double stress = 6 * (v * by_load + by_moment).maxCoeff() / (t * t) - thrust / t;
        (stress < strength ? low : high) = v;
    }
    return high;
}

TEST(LiftedEdge, WithThrustAndLeverIsThatOfFiniteDifferences) {
    const FloatingPlate plate{0.033};
    for (const double ratio : {0.5, 1.5, 3.0}) {
        const test::LiftedEdge edge = test::lifted_edge(plate, 60e6, 36.4e3, ratio, plate.thickness / 2);
        EXPECT_NEAR(
            vertical_by_differences(plate, 60e6, 36.4e3, edge.horizontal, edge.horizontal * plate.thickness / 2) /
                edge.vertical,
            1, 2e-3)
            << ratio;
    }
}

TEST(LiftedEdge, HasTheHeightsOfItsEquation) {
    const FloatingPlate plate{0.033};
    const double e = plate.thickness / 2;
    const test::LiftedEdge edge = test::lifted_edge(plate, 60e6, 36.4e3, 1.5, e);
    const auto w = [&](double x) { return test::height_of_edge(plate, 60e6, {edge.vertical, edge.horizontal, e}, x); };
    EXPECT_NEAR(w(0), edge.lift, 1e-12);
    EXPECT_NEAR(w(10), 0, 1e-8) << "27 characteristic lengths";
    const double d = plate.flexural_rigidity(60e6);
    constexpr double h = 0.005;
    for (const double x : {0.2, 0.5, 1.0}) {
        const double second = (w(x - h) - 2 * w(x) + w(x + h)) / (h * h);
        const double fourth = (w(x - 2 * h) - 4 * w(x - h) + 6 * w(x) - 4 * w(x + h) + w(x + 2 * h)) / std::pow(h, 4);
        EXPECT_NEAR(d * fourth + edge.horizontal * second, -plate.foundation() * w(x),
                    1e-3 * plate.foundation() * w(0));
    }
    EXPECT_THROW(test::height_of_edge(plate, 60e6, {0, test::buckling_thrust(plate, 60e6), e}, 0), InputError);
}

TEST(LiftedEdge, BucklesUnderTheThrustOfASteepWall) {
    const FloatingPlate plate{0.033};
    EXPECT_NEAR(test::buckling_thrust(plate, 60e6), std::sqrt(plate.foundation() * plate.flexural_rigidity(60e6)),
                1e-9);
    EXPECT_NO_THROW(test::lifted_edge(plate, 60e6, 36.4e3, 3, plate.thickness / 2));
    EXPECT_THROW(test::lifted_edge(plate, 60e6, 1e12, 3, plate.thickness / 2), InputError) << "ice that does not crack";
}

/// Least thrust under which a strip on water, `length` characteristic lengths long, gives way: by beam elements with
/// cubic deflections. Its far end is clamped, its near edge free, hinged or clamped: 0, 1 or 2 of its motions are held.
double thrust_by_elements(const FloatingPlate& plate, double elastic_modulus, double length, int held) {
    constexpr int count = 80;
    const double l = length * plate.characteristic_length(elastic_modulus) / count;
    Eigen::Matrix4d bending, ground, thrust;
    bending << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l, 2 * l * l,
        -6 * l, 4 * l * l;
    ground << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l,
        -3 * l * l, -22 * l, 4 * l * l;
    thrust << 36, 3 * l, -36, 3 * l, 3 * l, 4 * l * l, -3 * l, -l * l, -36, -3 * l, 36, -3 * l, 3 * l, -l * l, -3 * l,
        4 * l * l;
    const Eigen::Matrix4d stiff =
        bending * (plate.flexural_rigidity(elastic_modulus) / (l * l * l)) + ground * (plate.foundation() * l / 420);
    const Eigen::Matrix4d soft = thrust / (30 * l);
    constexpr int all = 2 * count + 2;
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(all, all);
    Eigen::MatrixXd taken = whole;
    for (int i = 0; i < count; ++i) {
        whole.block<4, 4>(2 * i, 2 * i) += stiff;
        taken.block<4, 4>(2 * i, 2 * i) += soft;
    }
    const int kept = all - 2 - held;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
        taken.block(held, held, kept, kept), whole.block(held, held, kept, kept), Eigen::EigenvaluesOnly);
    return 1 / modes.eigenvalues().maxCoeff();
}

TEST(BucklingThrust, OfAFreeEdgeIsHalfThatOfOneWhichIsHeld) {
    const FloatingPlate plate{0.033};
    const double free = test::buckling_thrust(plate, 60e6);
    EXPECT_NEAR(thrust_by_elements(plate, 60e6, 16, 0) / free, 1, 2e-3);
    EXPECT_NEAR(thrust_by_elements(plate, 60e6, 24, 1) / free, 2, 0.03);
    EXPECT_NEAR(thrust_by_elements(plate, 60e6, 24, 2) / free, 2, 0.08);
}

TEST(PushOverLift, IsThatOfIceThatSlidesUp) {
    EXPECT_NEAR(test::push_over_lift(std::numbers::pi / 4, 0), 1, 1e-12);
    EXPECT_NEAR(test::push_over_lift(std::numbers::pi / 4, 0.2), 1.5, 1e-12);
    EXPECT_THROW(test::push_over_lift(std::numbers::pi / 4, 1.01), InputError);
}

}  // namespace plate_test
}  // namespace floes
