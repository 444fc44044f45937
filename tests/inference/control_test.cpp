// The regression estimator: exact where the load is a plane, off where it does not help, and intervals that hold.

#include "inference/explained_variance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "inference/known_processes.hpp"

namespace floes {
namespace control_test {

using known::normal;

struct Drawn {
    std::vector<double> values;
    Covariates known;
    Covariates population;
};

/// Values 10 + slope x + noise over a covariate with mean 1 and SD 1, and a second one that says nothing.
Drawn draw(std::size_t count, double slope, double noise, std::uint32_t number) {
    RandomStream random{6, number, StreamId::bootstrap, 0};
    Drawn made;
    for (std::size_t k = 0; k < count; ++k) {
        made.known.push_back({1 + normal(random), normal(random)});
        made.values.push_back(10 + slope * made.known.back()[0] + noise * normal(random));
    }
    for (int k = 0; k < 200; ++k) made.population.push_back({1 + normal(random), normal(random)});
    return made;
}

ControlledMean found_in(const Drawn& drawn) {
    return controlled_mean(drawn.values, drawn.known, drawn.population);
}

TEST(Control, OfAPlaneIsThePlaneAtThePopulationsMean) {
    const Drawn drawn = draw(20, 3, 1e-9, 1);
    const ControlledMean found = found_in(drawn);
    double mean = 0;
    for (const auto& row : drawn.population) mean += row[0] / 200;
    EXPECT_TRUE(found.used);
    EXPECT_NEAR(found.corrected.estimate, 10 + 3 * mean, 1e-6);
    EXPECT_NEAR(found.left_out, 1, 1e-6);
    // What remains is the uncertainty of the population's mean: 3 / √200, times 2.1.
    EXPECT_NEAR(found.corrected.high - found.corrected.estimate, 2.1 * 3 / std::sqrt(200), 0.1);
}

TEST(Control, IsOffWhereItDoesNotHelp) {
    int used = 0;
    for (std::uint32_t number = 0; number < 200; ++number) {
        const ControlledMean found = found_in(draw(50, 0, 1, number));
        used += found.used;
        if (found.used) continue;
        EXPECT_EQ(found.corrected, found.plain);
        EXPECT_EQ(found.saved, 0);
    }
    EXPECT_LT(used, 40);  // by chance
}

TEST(Control, SavesAsManyAsTheVarianceSays) {
    double saved = 0;
    const int trials = 200;
    for (std::uint32_t number = 0; number < trials; ++number) saved += found_in(draw(50, 1, 1, number)).saved / trials;
    // R² is 1/2: of 50 as good as 100, less what slopes and population's mean cost.
    EXPECT_GT(saved, 20);
    EXPECT_LT(saved, 50);
}

// 95 % intervals hold, with the choice whether to correct made from the same data: within four standard errors of 2000
// trials.
TEST(Control, IntervalsHold) {
    for (const double slope : {0.0, 0.3, 1.0, 3.0}) {
        int within = 0;
        const int trials = 2000;
        for (std::uint32_t number = 0; number < trials; ++number) {
            const ControlledMean found = found_in(draw(30, slope, 1, number));
            within += found.corrected.low <= 10 + slope && 10 + slope <= found.corrected.high;
        }
        EXPECT_NEAR(within / static_cast<double>(trials), 0.95, 4 * std::sqrt(0.05 * 0.95 / trials)) << slope;
    }
}

TEST(Control, LeavesOutWhatDoesNotVaryOrIsNotKnown) {
    Drawn drawn = draw(20, 3, 1, 2);
    for (auto& row : drawn.known) row[1] = 5;
    EXPECT_TRUE(found_in(drawn).used);
    for (auto& row : drawn.known) row = {std::nan(""), 5};
    EXPECT_FALSE(found_in(drawn).used);
    EXPECT_FALSE(controlled_mean(std::vector<double>{1, 2}, {{1}, {2}}, {{1}, {2}}).used);
}

}  // namespace control_test
}  // namespace floes
