// The load of a member as its campaign file has it, and of files that have none.

#include "load_files/read_loads.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "support/published.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace read_loads_test {

using testing::AllOf;
using testing::HasSubstr;

/// A campaign whose histories are means over so many steps; 0: it keeps none.
class ReadLoads : public testing::Test {
  protected:
    void publish_with(int stride) {
        Campaign campaign = synthetic::campaign();
        for (Case& one : campaign.cases) {
            one.scenario.analysis.keep_history = stride > 0;
            one.scenario.analysis.history_stride = std::max(stride, 1);
        }
        std::vector<MemberRecord> records = synthetic::records(campaign);
        for (MemberRecord& record : records)
            for (std::vector<double>* along : {&record.result.history.surge, &record.result.history.sway,
                                               &record.result.history.heave, &record.result.history.concentration})
                along->resize(stride > 0 ? along->size() / static_cast<std::size_t>(stride) : 0);
        synthetic::publish(file_, campaign, records);
    }

    LoadToWrite read(int member, const LoadRequest& request = {}) {
        const CampaignFile file(file_);
        return read_load(file, read_campaign_file(file), member, request);
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "a.h5";
};

TEST_F(ReadLoads, GivesWhatIsStored) {
    publish_with(1);
    const LoadToWrite load = read(3);
    const MemberRecord record = synthetic::record(synthetic::campaign(), 3);
    ASSERT_EQ(load.series.cells(), record.result.history.surge.size());
    for (std::size_t k = 0; k < load.series.cells(); ++k) {
        EXPECT_NEAR(load.series.force[0][k], -record.result.history.surge[k], 1e-9);
        EXPECT_NEAR(load.series.force[1][k], -record.result.history.sway[k], 1e-9);
        EXPECT_NEAR(load.series.force[2][k], record.result.history.heave[k], 1e-9);
    }
    EXPECT_TRUE(load.series.moment.empty());
    EXPECT_EQ(load.origin.case_name, "soft");
    EXPECT_EQ(load.origin.arrangement, 1);
    EXPECT_EQ(load.origin.mean_roll, 401.4);
    EXPECT_EQ(load.origin.mean_pitch, -401.7);  // about +z, which is -Y
    EXPECT_EQ(load.origin.mean_yaw, 401.1);
}

// A hull on a path: its file has yaw and moment.
TEST_F(ReadLoads, TurnsTheLoadOfATurnedHull) {
    Campaign campaign = synthetic::campaign();
    campaign.cases.resize(1);
    Scenario& scenario = campaign.cases[0].scenario;
    scenario.path.legs = {{0, scenario.structure.speed, 3, 0}};
    MemberRecord record = synthetic::record(campaign, 0);
    LoadHistory& load = record.result.history;
    MotionHistory& motion = record.result.motion;
    for (std::size_t k = 0; k < load.surge.size(); ++k) {
        motion.x.push_back(0.1);
        motion.z.push_back(0.2);
        motion.yaw.push_back(0.01 * static_cast<double>(k));
        motion.yaw_load.push_back(3.0 * static_cast<double>(k));
    }
    synthetic::publish(file_, campaign, std::vector<MemberRecord>{record});
    const LoadToWrite made = read(0);
    EXPECT_EQ(made.origin.hull_went, "followed a path and did not give way");
    ASSERT_EQ(made.series.moment.size(), load.surge.size());
    for (std::size_t k = 0; k < load.surge.size(); ++k) {
        const double yaw = 0.01 * static_cast<double>(k);
        EXPECT_NEAR(made.series.force[0][k], -load.surge[k] * std::cos(yaw) + load.sway[k] * std::sin(yaw), 1e-9);
        EXPECT_NEAR(made.series.force[1][k], -load.surge[k] * std::sin(yaw) - load.sway[k] * std::cos(yaw), 1e-9);
        EXPECT_NEAR(made.series.moment[k], 3.0 * static_cast<double>(k), 1e-9);
    }
    EXPECT_NEAR(read(0, {.axes = LoadAxes::hull}).series.force[1][50], -load.sway[50], 1e-9);
}

// The bow 0.1 rad up all the time; a file without that history says that its axes tilt.
TEST_F(ReadLoads, LevelsTheLoadOfAHullThatPitches) {
    Campaign campaign = synthetic::campaign();
    campaign.cases.resize(1);
    Scenario& scenario = campaign.cases[0].scenario;
    scenario.moorings = {.free = {true, true, true, true, true, true},
                         .mass = 1e5,
                         .height = -0.3,
                         .gyration = 0.4,
                         .pitch_gyration = 0.4,
                         .roll_gyration = 0.4,
                         .surge = 1e6,
                         .sway = 1e6,
                         .yaw = 1e4};
    MemberRecord record = synthetic::record(campaign, 0);
    const LoadHistory& load = record.result.history;
    MotionHistory& motion = record.result.motion;
    for (const auto& one : motion_histories) (motion.*one.values).assign(load.surge.size(), 0.0);
    motion.pitch.assign(load.surge.size(), 0.1);
    synthetic::publish(file_, campaign, std::vector<MemberRecord>{record});
    const LoadToWrite made = read(0);
    EXPECT_FALSE(made.tilts);
    for (std::size_t k = 0; k < load.surge.size(); ++k) {
        EXPECT_NEAR(made.series.force[0][k], -load.surge[k] * std::cos(0.1) - load.heave[k] * std::sin(0.1), 1e-9);
        EXPECT_NEAR(made.series.force[1][k], -load.sway[k], 1e-9);
        EXPECT_NEAR(made.series.force[2][k], -load.surge[k] * std::sin(0.1) + load.heave[k] * std::cos(0.1), 1e-9);
    }
    const auto told = [](const LoadToWrite& load_told) {
        std::string text;
        for (const std::string& line : legend(load_told, false, "N", "N m")) text += line + "\n";
        return text;
    };
    LoadToWrite without = made;
    without.tilts = true;
    EXPECT_THAT(told(made), testing::Not(HasSubstr("pitch and roll with the hull")));
    EXPECT_THAT(told(without), HasSubstr("along axes that pitch and roll with the hull"));
}

TEST_F(ReadLoads, TakesTimesAtTheScaleOfTheFile) {
    publish_with(1);
    const LoadSeries whole = read(3).series;
    const LoadToWrite load = read(3, {.scale = 4, .from = 1, .step = 10 * whole.step});
    EXPECT_DOUBLE_EQ(load.series.step, 10 * whole.step);
    EXPECT_EQ(load.series.cells(), whole_steps(1, 2 * whole.length(), 10 * whole.step));
    EXPECT_EQ(load.begin, 1);
    EXPECT_NEAR(impulse(load.series)[0], 128 * impulse(resampled(whole, 0.5, whole.length(), 5 * whole.step))[0], 1e-6);
}

TEST_F(ReadLoads, RefusesStepsShorterThanThoseOfThinnedHistories) {
    publish_with(2);
    const double step = read(3).series.step;
    EXPECT_EQ(read(3).origin.averaged_steps, 2);
    EXPECT_THAT(refusal([&] { read(3, {.step = step / 2}); }),
                AllOf(HasSubstr("(analysis.history_steps = 2), and nothing says how they went within: give --step"),
                      HasSubstr("or run it with analysis.history_steps = 1")));
    EXPECT_EQ(read(3, {.step = 2 * step}).series.step, 2 * step);
}

TEST_F(ReadLoads, RefusesAFileWithoutHistories) {
    publish_with(0);
    EXPECT_THAT(refusal([&] { read(3); }),
                HasSubstr("keeps no load histories of case soft (analysis.history_steps = 0): run it with "
                          "analysis.history_steps = 1"));
}

}  // namespace read_loads_test
}  // namespace floes
