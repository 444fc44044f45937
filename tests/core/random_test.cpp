#include "core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace floes {
namespace random_test {

constexpr std::uint64_t seed = 0x0123456789abcdef;
constexpr std::uint64_t geometry = 0xfedcba9876543210;

// From tests/kat_vectors of Random123: nothing, everything, and the digits of pi.
TEST(Philox, GivesThePublishedAnswers) {
    EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    constexpr std::uint32_t ones = 0xffffffff;
    EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
              (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomStream, IsTheDocumentedFunctionOfItsCounter) {
    const PhiloxCounter derived = philox({7, 1, 0x76543210, 0xfedcba98}, {0x89abcdef, 0x01234567});
    RandomStream stream(seed, 7, StreamId::monte_carlo, geometry);
    for (std::uint32_t block = 0; block < 10; ++block) {
        const PhiloxCounter words = philox({block, 0, 7, 1}, {derived[0], derived[1]});
        const auto expect = [](std::uint32_t low, std::uint32_t high) {
            return static_cast<double>((low | static_cast<std::uint64_t>(high) << 32) >> 11) / 9007199254740992.0;
        };
        EXPECT_EQ(stream.uniform(), expect(words[0], words[1]));
        EXPECT_EQ(stream.uniform(), expect(words[2], words[3]));
    }
    EXPECT_EQ(stream.draws(), 20u);
}

TEST(RandomStream, DiffersInEveryPartOfItsIdentity) {
    std::set<double> first;
    first.insert(RandomStream(seed, 0, StreamId::monte_carlo, geometry).uniform());
    first.insert(RandomStream(seed + 1, 0, StreamId::monte_carlo, geometry).uniform());
    first.insert(RandomStream(seed + (1ull << 32), 0, StreamId::monte_carlo, geometry).uniform());
    first.insert(RandomStream(seed, 1, StreamId::monte_carlo, geometry).uniform());
    first.insert(RandomStream(seed, 0, StreamId::lattice_jitter, geometry).uniform());
    first.insert(RandomStream(seed, 0, StreamId::monte_carlo, geometry + 1).uniform());
    first.insert(RandomStream(seed, 0, StreamId::monte_carlo, geometry + (1ull << 32)).uniform());
    EXPECT_EQ(first.size(), 7u);
}

TEST(RandomStream, IsUniformInMeanVarianceAndLagOneCorrelation) {
    RandomStream stream(seed, 0, StreamId::monte_carlo, geometry);
    constexpr int count = 1'000'000;
    double sum = 0, squares = 0, lagged = 0, previous = stream.uniform() - 0.5;
    for (int i = 0; i < count; ++i) {
        const double value = stream.uniform() - 0.5;
        ASSERT_TRUE(value >= -0.5 && value < 0.5);
        sum += value;
        squares += value * value;
        lagged += value * previous;
        previous = value;
    }
    const double root = std::sqrt(static_cast<double>(count));
    EXPECT_NEAR(sum / count, 0, 4 * std::sqrt(1.0 / 12) / root);
    EXPECT_NEAR(squares / count, 1.0 / 12, 4 * std::sqrt(1.0 / 180) / root);
    EXPECT_NEAR(lagged / count, 0, 4 * (1.0 / 12) / root);
}

TEST(RandomStream, StaysBetweenItsLimits) {
    RandomStream stream(seed, 0, StreamId::monte_carlo, geometry);
    double smallest = 10, largest = -10;
    for (int i = 0; i < 10'000; ++i) {
        const double value = stream.uniform(-3, 5);
        smallest = std::min(smallest, value);
        largest = std::max(largest, value);
    }
    EXPECT_GE(smallest, -3);
    EXPECT_LT(smallest, -2.99);
    EXPECT_LT(largest, 5);
    EXPECT_GT(largest, 4.99);
}

TEST(RandomStream, BelowFillsItsRangeEvenly) {
    RandomStream stream(seed, 3, StreamId::monte_carlo, geometry);
    constexpr int sides = 7, count = 700'000;
    std::vector<int> seen(sides, 0);
    for (int i = 0; i < count; ++i) ++seen.at(stream.below(sides));
    double chi_squared = 0;
    for (const int n : seen) chi_squared += std::pow(n - count / sides, 2) / (count / sides);
    EXPECT_LT(chi_squared, 22.5);  // 6 degrees of freedom, p = 0.001
}

// Three quarters of 2^32: taken without rejection, every third result would come twice as often as the others.
TEST(RandomStream, BelowIsUnbiasedWhereTheRangeIsLarge) {
    RandomStream stream(seed, 4, StreamId::monte_carlo, geometry);
    constexpr int count = 300'000;
    std::vector<int> remainder(3, 0);
    for (int i = 0; i < count; ++i) ++remainder[stream.below(3u << 30) % 3];
    for (const int n : remainder) EXPECT_NEAR(n, count / 3, 4 * std::sqrt(count * 2.0 / 9));
    EXPECT_NEAR(static_cast<double>(stream.draws()), count / 0.75, 4 * std::sqrt(count * 0.25) / 0.75);
}

TEST(RandomStream, BelowOneIsNothingElse) {
    RandomStream stream(seed, 0, StreamId::monte_carlo, geometry);
    EXPECT_EQ(stream.below(1), 0u);
    EXPECT_EQ(stream.draws(), 1u);
}

}  // namespace random_test
}  // namespace floes
