// What a matching takes from campaigns: coordinates, means and scatter at the points, and what it refuses.

#include "match/waves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "match/synthetic_wave.hpp"
#include "support/published.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace design_data_test {

using synthetic::wave;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string base = "[campaign]\narrangements = 3\n";
const std::string list = base + "[design]\nmethod = \"list\"\n";
const std::string two_axes =
    "[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [0.02, 0.03, 0.04]\n"
    "[[design.axis]]\nkey = \"joint.cfm\"\nvalues = [0.001, 0.01, 0.1]\nscale = \"log\"\n";

/// 1000 times the thickness, and 1 N more on each arrangement.
double thickness_load(const Case& one, int arrangement) {
    return 1000 * one.scenario.floe.thickness + arrangement;
}

std::vector<Target> mean_target(const std::string& case_name = "") {
    Target target;
    target.quantity = quantity("mean_load");
    target.case_name = case_name;
    target.value = 30;
    return {target};
}

Target target_of(const std::string& key, const std::string& case_name, bool held_out = false) {
    Target target;
    target.quantity = *any_quantity(key);
    target.case_name = case_name;
    target.held_out = held_out;
    return target;
}

std::string refused(const std::vector<MatchWave>& waves, const std::vector<Target>& targets) {
    return refusal([&] { match_data(waves, targets); });
}

TEST(RangedAxis, RunsFromMinusOneToOne) {
    const RangedAxis linear{"a", 2, 6, AxisScale::linear};
    EXPECT_DOUBLE_EQ(linear.coordinate(2), -1);
    EXPECT_DOUBLE_EQ(linear.coordinate(5), 0.5);
    EXPECT_DOUBLE_EQ(linear.value(0.5), 5);
    const RangedAxis log{"a", 0.001, 0.1, AxisScale::log};
    EXPECT_NEAR(log.coordinate(0.01), 0, 1e-12);
    EXPECT_NEAR(log.coordinate(0.1), 1, 1e-12);
    EXPECT_NEAR(log.value(log.coordinate(0.03)), 0.03, 1e-15);
}

TEST(MatchData, HasPointsMeansAndScatter) {
    const std::vector<MatchWave> waves{wave("a.h5", list + two_axes, thickness_load)};
    const MatchData data = match_data(waves, mean_target());
    ASSERT_EQ(data.axes.size(), 2u);
    EXPECT_EQ(data.axes[1].key, "joint.cfm");
    EXPECT_EQ(data.axes[1].from, 0.001);
    EXPECT_EQ(data.axes[1].to, 0.1);
    ASSERT_EQ(data.points.size(), 3u);
    for (std::size_t p = 0; p < 3; ++p) {
        const double expected = static_cast<double>(p) - 1;
        EXPECT_NEAR(data.points[p].coordinates[0], expected, 1e-12);
        EXPECT_NEAR(data.points[p].coordinates[1], expected, 1e-12);
        EXPECT_EQ(data.points[p].number, static_cast<int>(p));
    }
    const TargetData& found = data.targets.at(0);
    EXPECT_EQ(found.target.value, 30);
    EXPECT_THAT(found.point, ElementsAre(0, 1, 2));
    EXPECT_THAT(found.runs, ElementsAre(3, 3, 3));
    EXPECT_THAT(found.mean, ElementsAre(DoubleEq(21), DoubleEq(31), DoubleEq(41)));
    for (const double variance : found.variance) EXPECT_NEAR(variance, 1, 1e-12);
    EXPECT_NEAR(found.shared, 1, 1e-12);  // an arrangement adds the same at every point
}

TEST(MatchData, LeavesOutWhatIsNotDone) {
    const auto load = [](const Case& one, int arrangement) {
        if (one.point == 1) return std::nan("");
        return one.point == 2 && arrangement > 0 ? std::nan("") : thickness_load(one, 2 * arrangement);
    };
    const std::vector<MatchWave> waves{wave("a.h5", list + two_axes, load)};
    const MatchData data = match_data(waves, mean_target());
    ASSERT_EQ(data.points.size(), 2u);
    EXPECT_EQ(data.points[1].number, 2);
    const TargetData& found = data.targets.at(0);
    EXPECT_THAT(found.point, ElementsAre(0, 1));
    EXPECT_THAT(found.runs, ElementsAre(3, 1));
    EXPECT_THAT(found.mean, ElementsAre(DoubleEq(22), DoubleEq(40)));
    EXPECT_NEAR(found.sample_variance[0], 4, 1e-12);
    EXPECT_TRUE(std::isnan(found.sample_variance[1]));
    EXPECT_NEAR(found.variance[1], 4, 1e-12);  // that of the point that has several runs
}

// Variances 1 and 9 of three runs each are pooled to 5; as if four runs had that: (4 x 5 + 2 x 1) / 6 and so on.
TEST(MatchData, WeighsAPointsVarianceWithThePooledOne) {
    const auto load = [](const Case& one, int arrangement) { return (one.point == 0 ? 1.0 : 3.0) * arrangement; };
    const std::string two = "[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [0.02, 0.03]\n";
    const std::vector<MatchWave> waves{wave("a.h5", list + two, load)};
    const TargetData found = match_data(waves, mean_target()).targets.at(0);
    EXPECT_THAT(found.sample_variance, ElementsAre(DoubleEq(1), DoubleEq(9)));
    EXPECT_THAT(found.variance, ElementsAre(DoubleEq(22.0 / 6), DoubleEq(38.0 / 6)));
}

TEST(MatchData, TakesLaterWavesInTheCoordinatesOfTheFirst) {
    const std::string later =
        list + "[[design.axis]]\nkey = \"joint.cfm\"\nvalues = [0.01, 1e-4]\n" +
        "[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [0.025, 0.05]\n[analysis]\naveraging_s = [1.0]\n";
    const auto load = [](const Case& one, int arrangement) {
        return one.point == 0 && arrangement > 0 ? std::nan("") : thickness_load(one, arrangement);
    };
    const std::vector<MatchWave> waves{wave("a.h5", list + two_axes, thickness_load), wave("b.h5", later, load)};
    const MatchData data = match_data(waves, mean_target());
    ASSERT_EQ(data.points.size(), 5u);
    EXPECT_EQ(data.points[2].wave, 0);
    EXPECT_EQ(data.points[3].wave, 1);
    EXPECT_EQ(data.points[3].number, 0);
    EXPECT_EQ(data.axes[0].key, "ice.thickness_m");
    EXPECT_EQ(data.axes[0].to, 0.04);
    EXPECT_NEAR(data.points[3].coordinates[0], -0.5, 1e-12);
    EXPECT_NEAR(data.points[3].coordinates[1], 0, 1e-12);
    EXPECT_NEAR(data.points[4].coordinates[0], 2, 1e-12);
    EXPECT_NEAR(data.points[4].coordinates[1], -2, 1e-12);
    EXPECT_THAT(data.targets[0].point, ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THAT(data.targets[0].runs, ElementsAre(3, 3, 3, 1, 3));
    EXPECT_NEAR(data.targets[0].mean[4], 51, 1e-9);
}

TEST(MatchData, SaysWhatArrangementsShare) {
    const std::string many =
        "[campaign]\narrangements = 40\n[design]\nmethod = \"latin_hypercube\"\npoints = 30\n"
        "[[design.axis]]\nkey = \"ice.thickness_m\"\nfrom = 0.02\nto = 0.04\n";
    const auto noise = [](std::uint32_t a, std::uint32_t b) {
        RandomStream random{5, a, StreamId::bootstrap, b};
        return std::sqrt(12.0) * (random.uniform(0, 1) - 0.5);  // variance 1
    };
    for (const double part : {0.0, 0.75}) {
        const auto load = [&](const Case& one, int arrangement) {
            const auto row = static_cast<std::uint32_t>(arrangement);
            return 50 * one.scenario.floe.thickness + std::sqrt(part) * noise(row, 1000) +
                   std::sqrt(1 - part) * noise(row, static_cast<std::uint32_t>(one.point));
        };
        const std::vector<MatchWave> waves{wave("a.h5", many, load)};
        const TargetData found = match_data(waves, mean_target()).targets.at(0);
        EXPECT_NEAR(found.shared, part, 0.1);
        EXPECT_NEAR(found.variance.front(), 1, 0.4);
    }
}

TEST(MatchData, IsOfTheTargetsCase) {
    const std::string cases =
        list + two_axes + "[[case]]\nname = \"E30\"\n[[case]]\nname = \"E60\"\ngeneral.iterations = 20\n";
    const auto load = [](const Case& one, int arrangement) {
        if (one.base == "E60" && one.point == 0) return std::nan("");
        return thickness_load(one, arrangement) * (one.base == "E60" ? 2 : 1);
    };
    const std::vector<MatchWave> waves{wave("a.h5", cases, load)};
    const std::vector<Target> targets{target_of("mean_load", "E30"), target_of("mean_maximum_0.5s", "E60"),
                                      target_of("mean_load", "E200", true)};
    const MatchData data = match_data(waves, targets);
    EXPECT_EQ(data.points.size(), 3u);
    EXPECT_THAT(data.targets[0].point, ElementsAre(0, 1, 2));
    EXPECT_THAT(data.targets[1].point, ElementsAre(1, 2));
    EXPECT_THAT(data.targets[1].mean, ElementsAre(DoubleEq(62.5), DoubleEq(82.5)));
    EXPECT_THAT(data.targets[2].point, IsEmpty());
    EXPECT_THAT(
        refused(waves, mean_target("E200")),
        HasSubstr("E200 mean_load is about a case that no campaign has: the cases are E30, E60; did you mean "));
    EXPECT_THAT(refused(waves, mean_target()), HasSubstr("mean_load names no case, and there are E30, E60"));
}

TEST(MatchData, RefusesTargetsThatNobodyMeasured) {
    const std::vector<MatchWave> waves{wave("a.h5", list + two_axes, thickness_load)};
    EXPECT_THAT(refused(waves, mean_target("E60")), HasSubstr("is about a case, and the design has no [[case]]"));
    EXPECT_THAT(refused(waves, {target_of("mean_maximum_2s", "")}),
                HasSubstr("is of a time that no campaign averages the load over; the times are 0.5, 1 s"));
    EXPECT_THAT(match_data(waves, std::vector{target_of("mean_maximum_2s", "", true)}).targets.at(0).mean, IsEmpty());
    std::vector<MatchWave> no_times = waves;
    no_times.front().table.averaging_times.clear();
    EXPECT_THAT(refused(no_times, {target_of("mean_maximum_2s", "")}), HasSubstr("they average over none"));
    const std::vector<MatchWave> nothing{wave("a.h5", list + two_axes, [](const Case&, int) { return std::nan(""); })};
    EXPECT_THAT(refused(nothing, mean_target()), HasSubstr("no member that is done"));
    const std::vector<MatchWave> single{wave("a.h5", list + two_axes, [](const Case& one, int arrangement) {
        return arrangement == 0 ? thickness_load(one, 0) : std::nan("");
    })};
    EXPECT_THAT(refused(single, mean_target()), HasSubstr("mean_load has one run at every point"));
}

TEST(MatchData, RefusesWavesThatDoNotBelongTogether) {
    const MatchWave first = wave("a.h5", list + two_axes, thickness_load);
    const auto with = [&](const std::string& text) {
        return refused({first, wave("b.h5", text, thickness_load)}, mean_target());
    };
    const std::string other_points =
        "[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [0.025]\n[[design.axis]]\nkey = \"joint.cfm\"\nvalues = "
        "[0.02]\n";
    EXPECT_THAT(refused({}, mean_target()), HasSubstr("a campaign file at least"));
    EXPECT_THAT(with(base), HasSubstr("b.h5 has no design"));
    EXPECT_THAT(with(list + "[[design.axis]]\nkey = \"field.far_end\"\nvalues = [\"open\"]\n"),
                HasSubstr("the axis field.far_end takes words or lists, and a matching wants numbers; run them as "
                          "separate designs"));
    EXPECT_THAT(with(list + "[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [0.02]\n"),
                HasSubstr("a.h5 has the axes ice.thickness_m, joint.cfm, and b.h5 has ice.thickness_m"));
    EXPECT_THAT(with(list + other_points + "[general]\niterations = 21\n"),
                HasSubstr("a.h5 (there) and b.h5 (here) are not waves of one matching, because keys that are not axes "
                          "differ: general.iterations: 500 there, 21 here"));
    EXPECT_THAT(with(list + two_axes), HasSubstr("the simulations of a.h5's case"));
    EXPECT_THAT(refused({wave("b.h5", list + other_points, thickness_load)}, mean_target()),
                HasSubstr("the axis ice.thickness_m has the one value 0.025"));
}

TEST(MatchData, RefusesWavesOfWhichOneIsToBeCalibrated) {
    const auto modulus = [&](const std::string& values) {
        return list + "[[design.axis]]\nkey = \"ice.elastic_modulus_MPa\"\nvalues = " + values +
               "\n[[case]]\nname = \"A\"\n";
    };
    const MatchWave first = wave("a.h5", modulus("[30, 60]"), thickness_load);
    EXPECT_THAT(
        refused({first, wave("b.h5", modulus("[40, 50]") + "joint.cfm = 0.016\n", thickness_load)}, mean_target()),
        HasSubstr("differ in case A: joint.cfm: to be calibrated there, 0.016 here"));
    const std::vector<MatchWave> waves{first, wave("b.h5", modulus("[40, 50]"), thickness_load)};
    EXPECT_EQ(match_data(waves, mean_target()).points.size(), 4u);
}

// Deviations (-5, -2, 7)/3 and (-1, 1)/2 have the products 5/6 and -2/6 on the two common arrangements, so their mean
// product is 1/4; its expectation is 1 - 1/3 - 1/2 + 2/6 = 1/2 of the covariance, hence 1/2. V is (26/3 + 1/2) / 3.
TEST(Scatter, SharedIsCorrectedForTheMeansOwnErrors) {
    std::vector<PointRuns> points{{0, {0, 1, 2}, {0, 1, 4}}, {0, {1, 0}, {8, 7}}};
    EXPECT_NEAR(scatter_of(points).shared, 0.5 / (55.0 / 18), 1e-12);
    points[1].arrangements = {3, 4};
    EXPECT_EQ(scatter_of(points).shared, 0);
    points[1].arrangements = {1, 0};
    points[1].wave = 1;
    EXPECT_EQ(scatter_of(points).shared, 0);
    points[1] = {0, {0, 1}, {8, 7}};
    EXPECT_EQ(scatter_of(points).shared, 0);  // a negative one is chance
}

TEST(MatchData, TakesARepeatedPointOfAWaveOnce) {
    const std::string repeated = base +
                                 "[design]\nmethod = \"sobol\"\npoints = 4\n"
                                 "[[design.axis]]\nkey = \"general.iterations\"\nfrom = 20\nto = 21\n";
    const std::vector<MatchWave> waves{wave("a.h5", repeated, thickness_load)};
    const MatchData data = match_data(waves, mean_target());
    EXPECT_EQ(data.points.size(), 2u);
    EXPECT_TRUE(data.axes.front().whole);
}

TEST(MatchData, IsReadFromACampaignFile) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign_with_design();
    synthetic::publish(folder / "a.h5", campaign);
    const std::vector<MatchWave> waves{read_wave(folder / "a.h5")};
    EXPECT_EQ(waves.front().file, (folder / "a.h5").string());
    const std::vector<Target> targets{target_of("mean_load", "soft"), target_of("mean_maximum_0.4s", "soft")};
    const MatchData data = match_data(waves, targets);
    ASSERT_EQ(data.points.size(), 6u);
    EXPECT_NEAR(data.points[1].coordinates[0], -1, 1e-12);
    EXPECT_NEAR(data.points[1].coordinates[1], 1, 1e-12);
    // Member 6 a + p of case p and arrangement a has the mean 100 (6 a + p + 1) + 0.1; 4 failed and 7 is missing.
    EXPECT_THAT(data.targets[0].runs, ElementsAre(4, 3, 4, 4, 3, 4));
    EXPECT_NEAR(data.targets[0].mean[0], 1000.1, 1e-9);
    EXPECT_NEAR(data.targets[0].mean[1], (200 + 1400 + 2000) / 3.0 + 0.1, 1e-9);
    EXPECT_EQ(data.targets[1].runs[4], 3);
}

}  // namespace design_data_test
}  // namespace floes
