// Intervals of the mean of members of which some are of another kind.

#include "inference/interval.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/beta.hpp>
#include <cmath>

#include "inference/known_processes.hpp"
#include "inference/paired.hpp"

namespace floes {
namespace mixed_mean_test {

/// Loads about 20 N of members that do not jam.
std::vector<double> loads(std::size_t count, std::uint32_t number = 0) {
    RandomStream random{51, number, StreamId::bootstrap, count};
    std::vector<double> values(count);
    for (double& value : values) value = 20 * std::exp(0.2 * known::normal(random));
    return values;
}

Interval interval_of(const std::vector<double>& values, Sides sides = Sides::above) {
    return mixed_interval(values, mean_interval(values), apart(values, sides), sides);
}

TEST(MixedMean, IsStudentsWhereNoneStandsOut) {
    const std::vector<double> values = loads(12);
    EXPECT_EQ(apart(values, Sides::above).count(), 0u);
    EXPECT_EQ(interval_of(values), mean_interval(values));
}

TEST(MixedMean, CountsAMemberThatJamsAsAKindOfItsOwn) {
    std::vector<double> values = loads(12);
    values[3] = 100;
    EXPECT_EQ(apart(values, Sides::above).above, std::vector<std::size_t>{3});
    const Interval plain = mean_interval(values);
    const Interval mixed = interval_of(values);
    EXPECT_EQ(mixed.estimate, plain.estimate);
    EXPECT_GT(mixed.low, plain.low + 3);  // no further below than members that do not jam
    EXPECT_GT(mixed.high, plain.high);    // a share of up to a third may be of the kind
    EXPECT_GT(mixed.prediction_low, 5);
    EXPECT_GT(mixed.prediction_high, 90);
}

// Where both kinds are known well, what is left is the share of one: Beta(20.5, 380.5) of 20 among 400.
TEST(MixedMean, IsThatOfTheShareWhereBothKindsAreKnown) {
    std::vector<double> values(400);
    for (std::size_t k = 0; k < 400; ++k)
        values[k] = (k % 20 == 7 ? 100 : 20) * (1 + 1e-3 * static_cast<double>(k % 11));
    ASSERT_EQ(apart(values, Sides::above).count(), 20u);
    const Interval mixed = interval_of(values);
    const boost::math::beta_distribution<> share(20.5, 380.5);
    EXPECT_NEAR(mixed.low, 20.1 + 80.4 * boost::math::quantile(share, 0.025), 0.2);
    EXPECT_NEAR(mixed.high, 20.1 + 80.4 * boost::math::quantile(share, 0.975), 0.2);
}

TEST(MixedMean, IsTheSameEveryTimeAndFollowsTheUnit) {
    std::vector<double> values = loads(20);
    values[7] = 130;
    const Interval once = interval_of(values);
    EXPECT_EQ(once, interval_of(values));
    for (double& value : values) value *= 1000;
    const Interval larger = interval_of(values);
    EXPECT_NEAR(larger.low, 1000 * once.low, 1e-6);
    EXPECT_NEAR(larger.high, 1000 * once.high, 1e-6);
}

TEST(MixedMean, OfDifferencesAllowsForTheOtherSide) {
    std::vector<double> differences(12);
    RandomStream random{52, 0, StreamId::bootstrap, 0};
    for (double& one : differences) one = known::normal(random);
    differences[5] = 60;
    const Apart found = apart(differences, Sides::both);
    EXPECT_EQ(found.above, std::vector<std::size_t>{5});
    EXPECT_TRUE(found.below.empty());
    const Interval mixed = interval_of(differences, Sides::both);
    EXPECT_LT(mixed.low, 0);
    for (double& one : differences) one = -one;
    EXPECT_EQ(apart(differences, Sides::both).below, std::vector<std::size_t>{5});
    const Interval turned = interval_of(differences, Sides::both);
    EXPECT_NEAR(turned.low, -mixed.high, 3);  // other draws of the same
    EXPECT_NEAR(turned.high, -mixed.low, 3);
    std::vector<double> none(12), second = differences;
    const PairedComparison compared = compare_paired(none, second);
    EXPECT_EQ(compared.interval.low, turned.low);
    EXPECT_LT(compared.t_interval.high, compared.interval.high);
}

TEST(MixedMean, TestsNoValuesOfBothSignsForJamsAndNoMultitude) {
    std::vector<double> values = loads(12);
    values[3] = 100;
    values[4] = -1;
    EXPECT_EQ(apart(values, Sides::above).count(), 0u);
    values = loads(most_tested + 1);
    values[3] = 1000;
    EXPECT_EQ(apart(values, Sides::above).count(), 0u);
}

TEST(MixedMean, NeedsAsManyMembersAsShowAKindOfAShare) {
    EXPECT_EQ(members_to_see(0.05), 59);
    EXPECT_LE(unseen_share(59), 0.05);
    EXPECT_GT(unseen_share(58), 0.05);
    EXPECT_EQ(members_to_see(0.1), 29);
}

}  // namespace mixed_mean_test
}  // namespace floes
