// Whether emulators know how wrong they are: over many processes that were drawn, and with statistics that they suit
// ill.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "inference/numerics.hpp"
#include "toy_simulator.hpp"

namespace floes {
namespace emulator_check_test {

using Vector = Eigen::VectorXd;

struct Tally {
    double covered = 0;   ///< share of 95 % intervals that hold the statistic
    double squares = 0;   ///< mean of squared errors over their variance
    double faults = 0;    ///< share of emulators that fail their check
    double left_out = 0;  ///< mean of squared errors of points left out
};

Tally tally(int toys, Eigen::Index count, const Vector& lengths, double noise) {
    constexpr Eigen::Index further = 20;
    RandomStream random(5, 0, StreamId::bootstrap, 18);
    Tally sum;
    for (int number = 0; number < toys; ++number) {
        const toy::Toy toy = toy::draw(count, further, lengths, noise, random);
        const Emulator emulator(toy.data);
        sum.faults += emulator.fault().empty() ? 0 : 1.0 / toys;
        for (const LeftOut& point : emulator.left_out())
            sum.left_out += std::pow(point.standardised(), 2) / static_cast<double>(count * toys);
        for (Eigen::Index i = 0; i < further; ++i) {
            const Emulated found = emulator.at(toy.further.row(i));
            const double error = (toy.truth(i) - found.mean) / std::sqrt(found.variance);
            sum.covered += (std::abs(error) < 1.96) / static_cast<double>(further * toys);
            sum.squares += error * error / static_cast<double>(further * toys);
        }
    }
    return sum;
}

// Of right emulators 1 % may fail. With the likeliest covariance alone about 90 % of the intervals would hold.
void expect_honest(const Tally& found) {
    EXPECT_GT(found.covered, 0.92);
    EXPECT_LT(found.covered, 0.98);
    EXPECT_GT(found.squares, 0.75);
    EXPECT_LT(found.squares, 1.25);
    EXPECT_GT(found.left_out, 0.8);
    EXPECT_LT(found.left_out, 1.05);
    EXPECT_LT(found.faults, 0.02);
}

TEST(EmulatorCheck, OfTwentyPointsOnALine) {
    expect_honest(tally(300, 20, Vector{{1}}, 0.01));
}
TEST(EmulatorCheck, OfTwentyPointsInAPlane) {
    expect_honest(tally(300, 20, Vector{{1, 1}}, 0.05));
}
TEST(EmulatorCheck, OfThirtyPointsInABox) {
    expect_honest(tally(300, 30, Vector{{1, 1, 3}}, 0.05));
}
TEST(EmulatorCheck, OfAHundredPointsInAPlane) {
    expect_honest(tally(100, 100, Vector{{1, 1}}, 0.3));
}

/// 40 points of a plane in two axes, with noise of SD 0.1.
EmulatorData plain(std::uint32_t number) {
    RandomStream random(6, number, StreamId::bootstrap, 18);
    const Eigen::MatrixXd at = toy::uniform_points(40, 2, random);
    return {at, at.col(0) + 0.1 * toy::normals(40, random), Vector::Constant(40, 0.01)};
}

TEST(EmulatorCheck, PassesWhereThereIsOnlyNoise) {
    for (std::uint32_t number = 0; number < 20; ++number) EXPECT_EQ(Emulator(plain(number)).fault(), "");
}

TEST(EmulatorCheck, FindsAFewPointsThatAreWayOff) {
    for (std::uint32_t number = 0; number < 20; ++number) {
        EmulatorData data = plain(number);
        data.values(3) += 10;
        data.values(17) += 10;
        const std::string fault = Emulator(data).fault();
        EXPECT_THAT(fault, testing::HasSubstr("of 40 points, each left out")) << number;
    }
}

TEST(EmulatorCheck, AllowsForNoiseThatIsUnderstated) {
    for (std::uint32_t number = 0; number < 20; ++number) {
        EmulatorData data = plain(number);
        data.noise /= 25;
        const Emulator emulator(data);
        EXPECT_EQ(emulator.fault(), "");
        EXPECT_NEAR(emulator.covariances().front().extra, 0.01, 0.01);
        EXPECT_GT(emulator.left_out().front().sd, 0.06);
    }
}

// A bowl with the curvatures of a known matrix.
TEST(PosteriorSpread, HasTheMeanAndCovarianceOfABowl) {
    const Eigen::Matrix2d curvature{{4, 1}, {1, 2}};
    const Cost bowl = [&](std::span<const double> at) {
        const Eigen::Vector2d from{at[0] - 5, at[1] + 3};
        return 7 + 0.5 * from.dot(curvature * from);
    };
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    const auto places = spread(bowl, {{5, -3}, 7});
    ASSERT_EQ(places.size(), 3);
    for (const std::vector<double>& place : places) {
        const Eigen::Vector2d from{place[0] - 5, place[1] + 3};
        mean += from / 3;
        covariance += from * from.transpose() / 3;
    }
    EXPECT_LT(mean.norm(), 1e-8);
    EXPECT_LT((covariance - curvature.inverse()).norm(), 1e-8);
}

// x² / 2 + x⁴: a quarter of the way of the normal distribution is already as dear as its whole.
TEST(PosteriorSpread, IsDrawnInWhereTheCostRises) {
    const Cost steep = [](std::span<const double> at) { return 0.5 * at[0] * at[0] + 100 * std::pow(at[0], 4); };
    for (const std::vector<double>& place : spread(steep, {{0}, 0})) EXPECT_LT(steep(place), 0.56);
}

TEST(Simplex, FindsTheEndOfABentValley) {
    const Cost valley = [](std::span<const double> at) {
        return std::pow(1 - at[0], 2) + 100 * std::pow(at[1] - at[0] * at[0], 2);
    };
    const Minimum found = walk_simplex(valley, std::vector{-1.2, 1.0}, {0.5, 1e-9});
    EXPECT_NEAR(found.at[0], 1, 1e-6);
    EXPECT_NEAR(found.at[1], 1, 1e-6);
    const Cost nowhere = [](std::span<const double>) { return std::numeric_limits<double>::quiet_NaN(); };
    EXPECT_EQ(walk_simplex(nowhere, std::vector{0.0}, {0.5, 1e-9}).cost, std::numeric_limits<double>::infinity());
}

}  // namespace emulator_check_test
}  // namespace floes
