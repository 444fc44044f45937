// Members that stand out are found, and only they.

#include "inference/interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "inference/known_processes.hpp"

namespace floes {
namespace unlike_members_test {

/// Twenty exponential peaks of 20 N above 10 N for each scale.
std::vector<std::vector<double>> peaks_of(const std::vector<double>& scales, std::uint32_t number = 0) {
    RandomStream random{41, number, StreamId::bootstrap, 0};
    std::vector<std::vector<double>> rows;
    for (const double scale : scales) {
        std::vector<double>& row = rows.emplace_back(20);
        for (double& peak : row) peak = scale * (10 + 20 * known::exponential(random));
        std::ranges::sort(row, std::ranges::greater{});
    }
    return rows;
}

UnlikeMembers unlike_of(const std::vector<std::vector<double>>& peaks) {
    return unlike_members(known::spans(peaks), 0.25);
}

TEST(UnlikeMembers, ThatStandOutAreNamedWithTheirPeaks) {
    std::vector<double> scales(50, 1.0);
    scales[17] = scales[31] = 5;
    const std::vector<std::vector<double>> peaks = peaks_of(scales);
    const UnlikeMembers found = unlike_of(peaks);
    EXPECT_EQ(found.out, (std::vector<std::size_t>{17, 31}));
    double highest_other = 0;
    for (std::size_t row = 0; row < 50; ++row)
        if (row != 17 && row != 31) highest_other = std::max(highest_other, peaks[row].front());
    EXPECT_EQ(found.carried, static_cast<std::size_t>(
                                 std::ranges::count_if(peaks[17], [&](double peak) { return peak > highest_other; }) +
                                 std::ranges::count_if(peaks[31], [&](double peak) { return peak > highest_other; })));
    EXPECT_GE(found.carried, 5u);
}

TEST(UnlikeMembers, AreFoundAlsoWhereOneHidesTheOther) {
    std::vector<double> scales(8, 1.0);
    scales[2] = scales[5] = 5;
    EXPECT_EQ(unlike_of(peaks_of(scales)).out, (std::vector<std::size_t>{2, 5}));
}

TEST(UnlikeMembers, AreSeldomFoundAmongMembersThatAreAlikeOrVary) {
    int alike = 0, varied = 0, dispersed = 0;
    for (std::uint32_t trial = 0; trial < 300; ++trial) {
        RandomStream random{42, trial, StreamId::bootstrap, 0};
        std::vector<double> scales(20, 1.0);
        const UnlikeMembers plain = unlike_of(peaks_of(scales, trial));
        alike += !plain.out.empty();
        dispersed += plain.dispersion_p < 0.05;
        for (double& scale : scales) scale = std::exp(0.3 * known::normal(random));
        varied += !unlike_of(peaks_of(scales, trial)).out.empty();
    }
    EXPECT_LE(alike, 9);  // 1 %: 9 or fewer of 300 with 99.9 %
    EXPECT_LE(varied, 9);
    EXPECT_LE(dispersed, 27);  // 5 %, with the peaks of a member at most 20: 27 or fewer of 300 with 99.9 %
}

TEST(UnlikeMembers, ThatVaryHaveMoreScatterThanPeaksExplain) {
    std::vector<double> scales;
    for (int k = 0; k < 20; ++k) scales.push_back(k % 2 == 0 ? 0.7 : 1.4);
    const UnlikeMembers found = unlike_of(peaks_of(scales));
    EXPECT_GT(found.dispersion, 1.5);
    EXPECT_LT(found.dispersion_p, 0.05);
}

TEST(UnlikeMembers, OfFewOrNoneAreNone) {
    EXPECT_TRUE(unlike_of({}).out.empty());
    EXPECT_TRUE(unlike_of(peaks_of({1, 1, 1, 50})).out.empty());
    EXPECT_TRUE(unlike_of(std::vector<std::vector<double>>(6)).out.empty());
}

TEST(UnlikeMembers, OfValuesAreThoseFarAboveTheOthers) {
    const auto above = [](std::vector<double> logarithms) {
        for (double& one : logarithms) one = std::exp(one);
        return apart(logarithms, Sides::above).above;
    };
    EXPECT_EQ(above({1.0, 1.2, 9.0, 0.9, 1.1, 1.0, 1.3, 0.8}), std::vector<std::size_t>{2});
    EXPECT_TRUE(above({1.0, 1.2, -9.0, 0.9, 1.1, 1.0, 1.3, 0.8}).empty());
    EXPECT_TRUE(above(std::vector<double>(8, 2.0)).empty());
}

TEST(UnlikeMembers, ThatAreNotSeenAreRarerWithMoreMembers) {
    EXPECT_NEAR(std::pow(1 - unseen_share(12), 12), 0.05, 1e-12);
    EXPECT_NEAR(unseen_share(12), 0.22, 0.005);
}

}  // namespace unlike_members_test
}  // namespace floes
