#include "member/run_member.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include "arrangement/arrangement.hpp"
#include "arrangement/order.hpp"
#include "core/error.hpp"
#include "support/jam_scenario.hpp"

namespace floes {
namespace run_member_test {

Scenario jam(double cfm = 0.016) {
    Scenario scenario = jam_scenario();
    scenario.joint.cfm = cfm;
    return scenario;
}

void expect_same_bits(const MemberResult& a, const MemberResult& b) {
    EXPECT_EQ(a.load_map, b.load_map);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.history.surge, b.history.surge);
    EXPECT_EQ(a.history.sway, b.history.sway);
    EXPECT_EQ(a.history.heave, b.history.heave);
    EXPECT_EQ(a.breaks, b.breaks);
    EXPECT_EQ(a.peaks, b.peaks);
    EXPECT_EQ(a.load.mean, b.load.mean);
    EXPECT_EQ(a.failure_ratio, b.failure_ratio);
    EXPECT_EQ(a.psi4, b.psi4);
}

TEST(RunMember, FillsARowFromItsHistories) {
    const Scenario scenario = jam();
    const MemberResult result = run_member(scenario, 7, 0);
    ASSERT_EQ(result.status, MemberStatus::done) << result.reason;
    EXPECT_EQ(result.reason, "");
    ASSERT_EQ(result.history.surge.size(), 300u);
    EXPECT_EQ(result.arrangement.size(), 12u);
    EXPECT_EQ(result.local_order, local_order(result.arrangement));
    EXPECT_EQ(result.coverage_ahead, coverage_ahead(scenario, floes_at(scenario, result.arrangement)));
    EXPECT_EQ(result.load.segment_maximum.size(), 5u);
    double sum = 0;
    for (int k = 50; k < 300; ++k) sum += result.history.surge[static_cast<std::size_t>(k)];
    EXPECT_NEAR(result.load.mean, sum / 250, 1e-10);
    EXPECT_EQ(result.load.maximum, *std::max_element(result.history.surge.begin() + 50, result.history.surge.end()));
    EXPECT_GT(result.load.mean, 0);
    EXPECT_GT(result.wall_time, 0);
    EXPECT_GT(result.cpu_time, 0);
    EXPECT_LE(result.cpu_time, result.wall_time + 0.02);  // clocks of different grain
    EXPECT_GT(result.peaks.compression, 0);
    EXPECT_GT(result.peaks.shear, 0);
}

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(RunMember, MeasuresTheIceRoundTheStructureAndAsternOfIt) {
    Scenario scenario = jam();
    scenario.field.half_width = 2.4;  // room for floes to pass
    scenario.field.concentration = 0.4;
    scenario.structure.speed = 0.3;
    const MemberResult result = run_member(scenario, 7, 0);
    ASSERT_EQ(result.status, MemberStatus::done) << result.reason;
    ASSERT_EQ(result.history.concentration.size(), 300u);
    const auto begin = result.history.concentration.begin() + 50;
    EXPECT_NEAR(result.mean_concentration, std::accumulate(begin, result.history.concentration.end(), 0.0) / 250,
                1e-12);
    EXPECT_GT(result.mean_concentration, 0.2);
    EXPECT_GT(result.floes_astern, 0);
    EXPECT_NEAR(result.ice_flux * 5, 0.36 * result.floes_astern, 2 * 0.36);
    scenario.path.table = {{0, 0, 0, 0}, {6, 1.8, 0, 0}};
    const MemberResult on_path = run_member(scenario, 7, 0);
    EXPECT_EQ(on_path.status, MemberStatus::done) << on_path.reason;
    EXPECT_GT(on_path.mean_concentration, 0.2);
    EXPECT_TRUE(std::isnan(on_path.ice_flux) && std::isnan(on_path.floes_astern));
}

TEST(RunMember, MapsItsLoadToTheStructure) {
    const MemberResult result = run_member(jam(), 7, 0);
    const LoadMap& map = result.load_map;
    ASSERT_EQ(map.surge.size(), 12u * 36u);
    ASSERT_EQ(map.normal.size(), map.surge.size());
    EXPECT_NEAR(sum_of(map.surge), result.load.mean, 1e-12 * result.load.mean);
    EXPECT_NEAR(sum_of(map.along_tow) / 24, result.load.mean, 1e-12 * result.load.mean);
    EXPECT_GT(sum_of(map.normal), sum_of(map.surge));
    double ahead = 0;
    double at_the_waterline = 0;  // -0.08 to 0.03 m
    for (std::size_t bin = 0; bin < map.surge.size(); ++bin) {
        if (std::abs(middle_angle(bin % 36)) < 90) ahead += map.surge[bin];
        if (bin / 36 >= 7 && bin / 36 <= 9) at_the_waterline += map.surge[bin];
        EXPECT_GE(map.normal[bin], 0);
    }
    EXPECT_GT(ahead, 0.95 * result.load.mean);
    EXPECT_GT(at_the_waterline, 0.5 * result.load.mean) << "within 5 s little is pushed under";
}

TEST(RunMember, LogsTheBreaksThatItsCountsAndRatioCount) {
    const MemberResult result = run_member(jam(), 7, 1);
    ASSERT_EQ(result.status, MemberStatus::done) << result.reason;
    ASSERT_FALSE(result.breaks.empty());
    std::vector<std::int32_t> broken;
    for (const BreakEvent& event : result.breaks) {
        EXPECT_GT(event.time, 0);
        EXPECT_LE(event.time, 6.0 + 1e-9);
        broken.push_back(event.floe);
    }
    std::ranges::sort(broken);
    broken.erase(std::unique(broken.begin(), broken.end()), broken.end());
    EXPECT_DOUBLE_EQ(result.failure_ratio, static_cast<double>(broken.size()) / 12);
    EXPECT_EQ(std::accumulate(result.failures.begin(), result.failures.end(), 0.0),
              static_cast<int>(result.breaks.size()));
    EXPECT_GT(result.peaks.bending, 0.2 * 0.033 * 0.033 / 6 * 10e3);  // Eq. (3) was exceeded
}

TEST(RunMember, GivesTheSameBitsAgainAfterAnotherAndInThreads) {
    const MemberResult first = run_member(jam(), 7, 1);
    ASSERT_FALSE(first.breaks.empty());
    const MemberResult another = run_member(jam(0.03), 7, 2);
    EXPECT_NE(another.history.surge, first.history.surge);
    expect_same_bits(run_member(jam(), 7, 1), first);

    MemberResult left;
    MemberResult right;
    {
        const std::jthread one([&] { left = run_member(jam(), 7, 1); });
        const std::jthread two([&] { right = run_member(jam(), 7, 1); });
    }
    expect_same_bits(left, first);
    expect_same_bits(right, first);
}

TEST(RunMember, KeepsItsStatisticsWithoutItsHistory) {
    Scenario scenario = jam();
    scenario.analysis.keep_history = false;
    const MemberResult without = run_member(scenario, 7, 1);
    EXPECT_TRUE(without.history.surge.empty());
    EXPECT_TRUE(without.history.sway.empty());
    EXPECT_TRUE(without.history.heave.empty());
    MemberResult with = run_member(jam(), 7, 1);
    ASSERT_FALSE(with.history.surge.empty());
    with.history = {};
    expect_same_bits(without, with);
}

// What a member counts, with and without its history, is what its whole history shows afterwards.
TEST(RunMember, CountsWhatItsHistoryShows) {
    Scenario scenario = jam();
    scenario.analysis.exceedance_levels = {0, 5, 20, 60, 1e6};
    const MemberResult with = run_member(scenario, 7, 1);
    scenario.analysis.keep_history = false;
    const MemberResult without = run_member(scenario, 7, 1);
    EXPECT_EQ(with.levels, without.levels);
    EXPECT_EQ(with.load.skewness, without.load.skewness);
    ASSERT_EQ(with.levels.size(), 5u);
    EXPECT_EQ(with.levels[4], (LevelCount{0, 0}));
    const std::vector<double> window(with.history.surge.begin() + 50, with.history.surge.end());
    int rises = 0;
    for (std::size_t k = 0; k < 5; ++k) {
        const double level = scenario.analysis.exceedance_levels[k];
        LevelCount expected;
        expected.steps_above =
            static_cast<int>(std::ranges::count_if(window, [level](double load) { return load > level; }));
        for (std::size_t step = 1; step < window.size(); ++step)
            expected.upcrossings += window[step - 1] <= level && window[step] > level ? 1 : 0;
        EXPECT_EQ(with.levels[k], expected) << level;
        rises += expected.upcrossings;
    }
    EXPECT_GT(rises, 3) << "levels that the load rises through";
}

// Likewise of running means, whose sums are taken anew here.
TEST(RunMember, AveragesAsItsHistoryShows) {
    Scenario scenario = jam();
    scenario.analysis.averaging = {0.02, 0.1, 0.5, 1};
    const MemberResult with = run_member(scenario, 7, 1);
    scenario.analysis.keep_history = false;
    const MemberResult without = run_member(scenario, 7, 1);
    ASSERT_EQ(with.averaged.size(), 4u);
    const std::vector<double> window(with.history.surge.begin() + 50, with.history.surge.end());
    for (std::size_t k = 0; k < 4; ++k) {
        const AveragedLoad& found = with.averaged[k];
        EXPECT_EQ(found.time, scenario.analysis.averaging[k]);
        EXPECT_EQ(found.segment_maximum, without.averaged[k].segment_maximum);
        EXPECT_EQ(found.sd, without.averaged[k].sd);
        EXPECT_EQ(found.peaks, without.averaged[k].peaks);
        EXPECT_EQ(found.peaks.at(0), std::ranges::max(found.segment_maximum));
        const auto steps = static_cast<std::size_t>(std::lround(found.time / 0.02));
        for (std::size_t segment = 0; segment < 5; ++segment) {
            double largest = -1e300;
            for (std::size_t end = 50 * segment + 1; end <= 50 * (segment + 1); ++end) {
                if (end < steps) continue;
                double sum = 0;
                for (std::size_t step = end - steps; step < end; ++step) sum += window[step];
                largest = std::max(largest, sum / static_cast<double>(steps));
            }
            EXPECT_NEAR(found.segment_maximum.at(segment), largest, 1e-12 * std::abs(largest));
        }
    }
    EXPECT_EQ(with.averaged[0].segment_maximum, with.load.segment_maximum);
    EXPECT_LT(with.averaged[3].mean_maximum, with.averaged[1].mean_maximum);
    EXPECT_EQ(run_member(jam(), 7, 1).averaged.size(), 3u) << "of the default, 2 s is longer than a segment";
}

TEST(RunMember, ThinsItsHistoryToMeans) {
    Scenario scenario = jam();
    const MemberResult whole = run_member(scenario, 7, 1);
    scenario.analysis.history_stride = 10;
    MemberResult thinned = run_member(scenario, 7, 1);
    ASSERT_EQ(thinned.history.surge.size(), 30u);
    for (std::size_t k = 0; k < 30; ++k) {
        double sway = 0;
        for (std::size_t step = 10 * k; step < 10 * k + 10; ++step) sway += whole.history.sway[step];
        EXPECT_EQ(thinned.history.sway[k], sway / 10) << k;
    }
    EXPECT_EQ(thinned.load.maximum, whole.load.maximum) << "of every step";
    thinned.history = whole.history;
    expect_same_bits(thinned, whole);
}

TEST(RunMember, CasesShareArrangements) {
    Scenario softer = jam(0.03);
    softer.analysis = {.steady_start = 0.2, .window = 0.2, .segments = 5};
    Scenario stiffer = softer;
    stiffer.joint.cfm = 1e-10;
    const MemberResult a = run_member(softer, 7, 3);
    const MemberResult b = run_member(stiffer, 7, 3);
    ASSERT_EQ(a.arrangement.size(), b.arrangement.size());
    for (std::size_t i = 0; i < a.arrangement.size(); ++i) {
        EXPECT_EQ(a.arrangement[i].x, b.arrangement[i].x);
        EXPECT_EQ(a.arrangement[i].z, b.arrangement[i].z);
        EXPECT_EQ(a.arrangement[i].yaw, b.arrangement[i].yaw);
    }
}

TEST(RunMember, ThatLeavesAllSenseIsSetAsideWithItsReason) {
    Scenario scenario = jam();
    scenario.general.runaway_speed = 0.11;
    const MemberResult result = run_member(scenario, 7, 0);
    ASSERT_EQ(result.status, MemberStatus::failed);
    EXPECT_THAT(result.reason, testing::HasSubstr("has run away"));
    EXPECT_TRUE(std::isnan(result.load.mean));
    EXPECT_TRUE(std::isnan(result.load.sd));
    EXPECT_TRUE(std::isnan(result.load.maximum));
    EXPECT_TRUE(std::isnan(result.load.mean_maximum));
    EXPECT_TRUE(std::isnan(result.load.trend));
    EXPECT_TRUE(std::isnan(result.failure_ratio));
    EXPECT_TRUE(std::isnan(result.mean_sway));
    EXPECT_TRUE(std::isnan(result.mean_heave));
    ASSERT_EQ(result.load.segment_maximum.size(), 5u);
    for (const double maximum : result.load.segment_maximum) EXPECT_TRUE(std::isnan(maximum));
    EXPECT_EQ(result.arrangement.size(), 12u);
    EXPECT_EQ(result.local_order, local_order(result.arrangement));
    EXPECT_LT(result.history.surge.size(), 300u);
}

TEST(RunMember, IsInterruptedRatherThanHalfDone) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(run_member(jam(), 7, 0, stop.get_token()), Interrupted);
}

TEST(RunMember, RefusesFloesThatOverlap) {
    Scenario scenario = jam();
    scenario.arrangement.method = ArrangementMethod::file;
    scenario.arrangement.poses.assign(12, {3.0, 0.0, 0.0});
    EXPECT_THROW(run_member(scenario, 7, 0), InputError);
}

}  // namespace run_member_test
}  // namespace floes
