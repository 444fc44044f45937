// How often a change of the load through the window is seen, over members whose change is known.

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "inference/known_processes.hpp"
#include "inference/paired.hpp"

namespace floes {
namespace trend_test {

/// How the changes of members scatter about their mean.
enum class Scatter { normal, skewed, with_jams };

/// Members of a load of 20 N that changes by `change` of it, with an SD of `sd` over members.
std::vector<MemberTrend> members(std::size_t count, double change, double sd, Scatter scatter, RandomStream& random) {
    std::vector<MemberTrend> made;
    for (std::size_t k = 0; k < count; ++k) {
        double off = known::normal(random);
        if (scatter == Scatter::skewed) off = known::exponential(random) - 1;
        const bool jams = scatter == Scatter::with_jams && random.uniform() < 0.05;
        const double mean = 20 * (1 + 0.15 * known::normal(random)) * (jams ? 5 : 1);
        made.push_back({.mean = mean,
                        .rise = mean * (change + sd * off),
                        .growth = 3 * mean * (change + 2 * sd * known::normal(random)),
                        .largest = 3 * mean});
    }
    return made;
}

/// Shares of cases with each verdict, by Steadiness.
std::array<double, 4> verdicts(std::size_t count, double change, double sd, Scatter scatter) {
    constexpr int cases = 1000;
    std::array<double, 4> shares{};
    RandomStream random{72, static_cast<std::uint32_t>(count), StreamId::bootstrap,
                        static_cast<std::uint32_t>(1000 * sd) + 10 * static_cast<std::uint32_t>(scatter)};
    for (int k = 0; k < cases; ++k)
        shares[static_cast<std::size_t>(joint_trend(members(count, change, sd, scatter, random)).steadiness)] +=
            1.0 / cases;
    return shares;
}

double of(const std::array<double, 4>& shares, Steadiness steadiness) {
    return shares[static_cast<std::size_t>(steadiness)];
}

// So of fifty cases that do not rise one or two are named. By the load and by the maxima: each errs in 2.5 %.
TEST(Trend, OfASteadyLoadIsSeenInFewCases) {
    for (const std::size_t count : {3u, 4u, 8u, 20u, 50u})
        for (const double sd : {0.05, 0.2, 0.5})
            for (const Scatter scatter : {Scatter::normal, Scatter::skewed, Scatter::with_jams}) {
                const auto found = verdicts(count, 0, sd, scatter);
                // Few skewed values lie below their mean, all of them, more often than Student's interval says.
                EXPECT_LT(of(found, Steadiness::rises), 0.045) << count << " " << sd << " " << int(scatter);
                EXPECT_LT(of(found, Steadiness::falls), scatter == Scatter::normal ? 0.045 : 0.1)
                    << count << " " << sd << " " << int(scatter);
            }
}

// At the edge one side of a 95 % interval errs.
TEST(Trend, AtTheEdgeIsSeenAndCalledSteadyAsSeldomAsTheIntervalErrs) {
    for (const std::size_t count : {4u, 20u, 50u}) {
        const auto found = verdicts(count, steady_change, 0.2, Scatter::normal);
        EXPECT_LT(of(found, Steadiness::rises), 0.06) << count;  // by the load or by the maxima
        EXPECT_LT(of(found, Steadiness::steady), 0.04) << count;
    }
}

TEST(Trend, ThatIsLargeIsSeenByFewMembers) {
    EXPECT_GT(of(verdicts(4, 0.5, 0.1, Scatter::normal), Steadiness::rises), 0.95);
    EXPECT_GT(of(verdicts(20, 0.5, 0.4, Scatter::normal), Steadiness::rises), 0.95);
    EXPECT_GT(of(verdicts(4, -0.5, 0.1, Scatter::normal), Steadiness::falls), 0.95);
    EXPECT_GT(of(verdicts(8, 0.02, 0.03, Scatter::normal), Steadiness::steady), 0.95);
    EXPECT_GT(of(verdicts(4, 0, 0.5, Scatter::normal), Steadiness::not_known), 0.92);
}

TEST(Trend, OfOneOrTwoMembersIsNotKnown) {
    for (const std::size_t count : {0u, 1u, 2u})
        EXPECT_NEAR(of(verdicts(count, 0.5, 0.01, Scatter::normal), Steadiness::not_known), 1, 1e-9) << count;
}

TEST(Trend, OfLoadsThatAreAllZeroIsSteady) {
    EXPECT_EQ(joint_trend(std::vector<MemberTrend>(5)).steadiness, Steadiness::steady);
}

}  // namespace trend_test
}  // namespace floes
