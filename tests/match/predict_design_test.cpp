// The design load over what is left, of a tank whose largest loads are known.

#include "match/matching.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "match/synthetic_wave.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace predict_design_test {

using testing::HasSubstr;

const std::string design = R"(
[campaign]
arrangements = 4
common_arrangements = false
[design]
method = "sobol"
points = 24
[[design.axis]]
key = "contact.ice_structure_friction"
from = 0.1
to = 0.3
[[case]]
name = "E60"
)";

constexpr double rate = 0.1;  // peaks per s
constexpr double window = 150;
constexpr double base = 0.3;  // of the strength: mean load, and where the peaks begin
constexpr double tail = 0.2;  // of the strength: mean of what a peak is above that

double strength(double friction) {
    return 20 + 200 * friction;
}

/// Exponential peaks at independent times; loads are proportional to the strength, times `steeper(friction)` in the
/// tail.
MatchWave tank(const std::function<double(double)>& steeper, unsigned seed = 1) {
    std::mt19937 random(seed);
    MatchWave wave = synthetic::wave("wave1.h5", design, [](const Case&, int) { return 0.0; });
    for (CaseRow& row : wave.table.cases) {
        row.analysis.window = window;
        row.analysis.segments = 3;
        row.analysis.peak_separation = 1e-6;
    }
    for (MemberRow& row : wave.table.members) {
        const double friction = numeric_value(wave.campaign.cases[static_cast<std::size_t>(row.case_index)],
                                              "contact.ice_structure_friction");
        row.load.mean = base * strength(friction);
        for (AveragedLoad& averaged : row.averaged) {
            averaged.segment_maximum.assign(3, row.load.mean);
            for (double& maximum : averaged.segment_maximum) {
                for (int peaks = std::poisson_distribution(rate * window / 3)(random); peaks > 0; --peaks) {
                    const double above = std::exponential_distribution(1 / tail)(random);
                    averaged.peaks.push_back(strength(friction) * (base + steeper(friction) * above));
                    maximum = std::max(maximum, averaged.peaks.back());
                }
            }
            std::ranges::sort(averaged.peaks, std::greater{});
            averaged.mean_maximum =
                std::accumulate(averaged.segment_maximum.begin(), averaged.segment_maximum.end(), 0.0) / 3;
        }
    }
    return wave;
}

/// What the largest load in the exposure stays below with probability p.
double exact(double friction, double exposure, double p) {
    return strength(friction) * (base + tail * (std::log(rate * exposure) - std::log(-std::log(p))));
}

struct Found {
    std::vector<PredictedDesignLoad> designs;
    DesignLoadRequest request;
    double share;
};

/// With the mean load measured where the friction is 0.22.
Found found_in(const MatchWave& wave, int runs, const DesignLoadRequest& request = {}) {
    const std::vector<MatchWave> waves{wave};
    Target target = to_predict("mean_load", "E60");
    target.held_out = false;
    target.value = base * strength(0.22);
    target.discrepancy = 1.5 / std::sqrt(runs);
    const std::vector<Target> targets{target};
    const MatchData data = match_data(waves, targets);
    const std::vector<EmulatedTarget> emulated = emulate(data);
    const Matching left = match(data, emulated, 512, 1);
    return {predict_design_load(waves, data, emulated, OverLeft(left, emulated), request), request, left.share()};
}

// The runs of a tank last as long as the exposure, so one tank errs by some 15 %; six tanks on average by some 6 %.
TEST(PredictedDesignLoad, HoldsTheLargestLoadOfTheTruth) {
    constexpr unsigned tanks = 6;
    int held = 0;
    double ratio = 0;
    double widened = 0;
    for (unsigned seed = 1; seed <= tanks; ++seed) {
        const MatchWave wave = tank([](double) { return 1.0; }, seed);
        const Found narrow = found_in(wave, 30);
        ASSERT_EQ(narrow.designs.size(), 1u);
        const PredictedDesignLoad& one = narrow.designs.front();
        EXPECT_EQ(one.case_name, "E60");
        const double truth = exact(0.22, narrow.request.exposure, 0.9);
        for (const Estimate& range : {one.quantile, one.quantile_weighed})
            held += range.low < truth && truth < range.high;
        ratio += one.quantile.value / truth / tanks;
        EXPECT_LT(one.expected.value, one.quantile.value);
        const Estimate wide = found_in(wave, 1).designs.front().quantile;
        widened += (wide.high - wide.low) / (one.quantile.high - one.quantile.low) / tanks;
    }
    EXPECT_GE(held, 10);
    EXPECT_NEAR(ratio, 1, 0.1);
    EXPECT_GT(widened, 1.1);
}

TEST(PredictedDesignLoad, SeesThatTheGrowthDependsOnTheInputs) {
    const PredictedDesignLoad one =
        found_in(tank([](double friction) { return 0.05 * std::pow(40, 5 * (friction - 0.1)); }), 1).designs.front();
    EXPECT_GT(one.growth_upper_half, 1.3 * one.growth_lower_half);
}

TEST(PredictedDesignLoad, CountsOnlyRunsThatAreLeftWhereThereAreEnough) {
    const MatchWave wave = tank([](double) { return 1.0; });
    const Found wide = found_in(wave, 1);
    const Found narrow = found_in(wave, 30);
    ASSERT_GT(wide.share, 0.4);
    EXPECT_TRUE(wide.designs.front().only_left);
    EXPECT_LT(wide.designs.front().runs, 96u);
    EXPECT_FALSE(found_in(wave, 10000).designs.front().only_left);
    EXPECT_EQ(found_in(wave, 10000).designs.front().runs, 96u);
    EXPECT_LT(narrow.share, wide.share);
}

// At scale L a load is L³ as large, and an exposure at full scale √L shorter in the model.
TEST(PredictedDesignLoad, ScalesByFroude) {
    const MatchWave wave = tank([](double) { return 1.0; });
    const double model = found_in(wave, 1).designs.front().quantile.value;
    const double full = found_in(wave, 1, {.averaging = 2, .scale = 4}).designs.front().quantile.value;
    EXPECT_GT(full, 0.8 * 64 * model);
    EXPECT_LT(full, 64 * model);
}

// The other tables are known all the same, so this is a sentence in place of the figures and no refusal.
TEST(PredictedDesignLoad, SaysThatThereAreTooFewPeaks) {
    MatchWave wave = tank([](double) { return 1.0; });
    for (MemberRow& row : wave.table.members)
        for (AveragedLoad& averaged : row.averaged) averaged.peaks.clear();
    const Found found = found_in(wave, 1);
    ASSERT_EQ(found.designs.size(), 1u);
    EXPECT_FALSE(found.designs.front().known());
    const Section section = design_section(found.designs, found.request);
    EXPECT_TRUE(section.results.empty());
    EXPECT_THAT(section.notes, testing::ElementsAre(HasSubstr("E60: too few peaks (0; it takes 20)")));
}

TEST(PredictedDesignLoad, NeedsAnAveragingTimeThatTheWavesHave) {
    const MatchWave wave = tank([](double) { return 1.0; });
    EXPECT_THAT(refusal([&] { found_in(wave, 1, {.averaging = 7}); }), HasSubstr("take one of 0.5, 1 s"));
}

}  // namespace predict_design_test
}  // namespace floes
