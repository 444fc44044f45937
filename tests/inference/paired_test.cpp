// Paired comparisons in closed form and by counting; against scipy: tests/inference/summarize_against_scipy.py.

#include "inference/paired.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "inference/interval.hpp"

namespace floes {
namespace paired_test {

TEST(Paired, IsTheIntervalOfTheDifferences) {
    const std::vector<double> first{10, 12, 9, 14};
    const std::vector<double> second{11, 15, 9, 18};
    const PairedComparison found = compare_paired(first, second);
    const Interval differences = mean_interval(std::vector<double>{1, 3, 0, 4});
    EXPECT_EQ(found.arrangements, 4);
    EXPECT_EQ(found.difference, 2);
    EXPECT_EQ(found.t_interval, (Limits{differences.low, differences.high}));
    EXPECT_DOUBLE_EQ(found.sd, std::sqrt(10.0 / 3));
    EXPECT_DOUBLE_EQ(found.t, 2 / std::sqrt(10.0 / 12));
    // var first 14.75/3, var second 48.75/3, of the difference 10/3
    EXPECT_DOUBLE_EQ(found.variance_saved, 1 - 10.0 / (14.75 + 48.75));
}

TEST(Paired, OfAShiftPairingSavesAllVariance) {
    const PairedComparison found = compare_paired(std::vector<double>{1, 2, 4}, std::vector<double>{2, 3, 5});
    EXPECT_EQ(found.difference, 1);
    EXPECT_EQ(found.variance_saved, 1);
    EXPECT_TRUE(std::isnan(found.t_p));
}

TEST(Paired, RefusesWhatCannotBePaired) {
    EXPECT_THROW(compare_paired(std::vector<double>{1, 2}, std::vector<double>{1}), InputError);
}

// n = 5, all positive: two of 2^5 signs are as extreme. With one sign turned at the smallest: four.
TEST(Wilcoxon, CountsSigns) {
    EXPECT_EQ(wilcoxon_signed_rank(std::vector<double>{1, 2, 3, 4, 5}).p, 2.0 / 32);
    EXPECT_EQ(wilcoxon_signed_rank(std::vector<double>{-1, 2, 3, 4, 5}).p, 4.0 / 32);
}

// |d| = 1 1 2 with ranks 1.5 1.5 3 and the smaller sum 1.5 (one of the ties negative). Of the 8 signs, positive sums
// are 0 1.5 1.5 3 3 4.5 4.5 6: three are at most 1.5. A zero changes nothing.
TEST(Wilcoxon, CountsSignsWithTiesAndZeros) {
    const SignedRank found = wilcoxon_signed_rank(std::vector<double>{0, 1, -1, 2});
    EXPECT_EQ(found.rank_sum, 1.5);
    EXPECT_EQ(found.p, 6.0 / 8);
    EXPECT_TRUE(std::isnan(wilcoxon_signed_rank(std::vector<double>{0, 0}).p));
}

// python3: stats.wilcoxon(d, mode="exact"), stats.ttest_1samp(d, 0); and with ties stats.wilcoxon(d[d != 0],
// mode="approx") of d = [((k * 37) % 61 - 25) / 3 for k in range(1, 61)]. scipy 1.10.1
TEST(Wilcoxon, AgreesWithScipy) {
    const std::vector<double> differences{1.2, -0.4, 3.1, 2.2, -1.1, 0.7, 4.0, -2.5, 0.3, 1.9};
    const SignedRank exact = wilcoxon_signed_rank(differences);
    EXPECT_EQ(exact.rank_sum, 14);
    EXPECT_NEAR(exact.p, 0.193359375, 1e-12);
    const PairedComparison pair = compare_paired(std::vector<double>(10, 0.0), differences);
    EXPECT_NEAR(pair.t, 1.5102905391415482, 1e-12);
    EXPECT_NEAR(pair.t_p, 0.16525164106848822, 1e-12);
    std::vector<double> many;
    for (int k = 1; k <= 60; ++k) many.push_back(((k * 37) % 61 - 25) / 3.0);
    const SignedRank normal = wilcoxon_signed_rank(many);
    EXPECT_EQ(normal.rank_sum, 588);
    EXPECT_NEAR(normal.p, 0.024965220366753117, 1e-12);
}

TEST(Wilcoxon, LargeSamplesMeetTheExactOnes) {
    std::vector<double> differences;
    for (int k = 1; k <= 50; ++k) differences.push_back(k % 3 == 0 ? -k : k);
    const SignedRank exact = wilcoxon_signed_rank(differences);
    differences.push_back(0.5);
    differences.push_back(-0.25);
    const SignedRank normal = wilcoxon_signed_rank(differences);
    EXPECT_TRUE(exact.exact);
    EXPECT_FALSE(normal.exact);
    EXPECT_NEAR(exact.p, normal.p, 0.005);
}

// Holm's own scheme by hand: sorted .01 .02 .04 -> .03 .04 .04
TEST(Holm, AdjustsInOrder) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> found = holm(std::vector<double>{0.04, 0.01, nan, 0.02});
    EXPECT_DOUBLE_EQ(found[0], 0.04);
    EXPECT_DOUBLE_EQ(found[1], 0.03);
    EXPECT_TRUE(std::isnan(found[2]));
    EXPECT_DOUBLE_EQ(found[3], 0.04);
    EXPECT_EQ(holm(std::vector<double>{0.7, 0.9}), (std::vector<double>{1.0, 1.0}));
}

// Standard sample sizes of the paired t test at 5 %, 80 %: 34 at half an SD, 10 at one.
TEST(Power, GivesTheKnownSampleSizes) {
    EXPECT_EQ(arrangements_to_resolve(0.5, 1), 34);
    EXPECT_EQ(arrangements_to_resolve(-2, 2), 10);
    EXPECT_GE(power_of_paired_test(34, 0.5, 1), 0.8);
    EXPECT_LT(power_of_paired_test(33, 0.5, 1), 0.8);
    EXPECT_EQ(arrangements_to_resolve(1000, 1), 2);
    EXPECT_EQ(arrangements_to_resolve(1e-9, 1), 1'000'000);
    EXPECT_EQ(arrangements_to_resolve(0, 1), 1'000'000);
    EXPECT_EQ(arrangements_to_resolve(std::nan(""), 1), 0);
}

}  // namespace paired_test
}  // namespace floes
