// Which moment of which member is the largest of what is asked, by hand from the histories of a small file.

#include "replay/asked.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "replay/replay_member.hpp"
#include "shapes/moorings.hpp"
#include "support/published.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace asked_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double step = 0.02;
constexpr Asked force_over_1_s{AskedOf::mooring_force, 1};

/// Values over (from, to], s, and 0 elsewhere; of a run of 7 s, the last 6 of which are measured.
std::vector<double> block(double from, double to, double value) {
    std::vector<double> made(350, 0.0);
    for (int k = 0; k < 350; ++k)
        if (const double end = step * (k + 1); end > from + 1e-9 && end < to + 1e-9)
            made[static_cast<std::size_t>(k)] = value;
    return made;
}

/// Four members on a turret 1 m ahead: the first one's offset is largest, the second one's force in a step, the
/// third's over a second; the fourth has more of all before the window.
class AskedOfAFile : public testing::Test {
  protected:
    AskedOfAFile() {
        Campaign campaign = synthetic::campaign();
        campaign.cases.resize(1);
        Scenario& scenario = campaign.cases.front().scenario;
        scenario.structure.speed = 0.55;
        scenario.analysis.window = 6;
        scenario.moorings = {.mass = 1e5, .gyration = 0.4, .surge = 1e6, .sway = 1e6, .yaw = 1e4};
        scenario.moorings.turret.curve = {{0, 0}, {100, 1e6}};
        scenario.moorings.turret.ahead = 1;
        std::vector<MemberRecord> records = synthetic::records(campaign);
        for (std::size_t k = 0; k < records.size(); ++k) {
            MotionHistory& motion = records[k].result.motion;
            for (const auto& one : motion_histories) (motion.*one.values).assign(350, 0.0);
            records[k].result.history.surge.assign(350, 0.0);
            records[k].result.moored.line_tension = k == 1 ? 800 : 700;
        }
        MotionHistory& swung = records[0].result.motion;
        swung.surge_offset = block(5, 5.02, -3);
        swung.sway_offset = block(5, 5.02, 4);
        records[1].result.motion.surge_mooring = block(2, 2.02, 900);
        records[2].result.motion.surge_mooring = block(3, 4, 300);
        records[2].result.motion.sway_mooring = block(3, 4, -400);
        records[2].result.history.surge = block(6, 6.5, 50);
        records[3].result.motion.surge_mooring = records[3].result.history.surge = block(0, 0.9, 9000);
        synthetic::publish(file_, campaign, records);
    }

    std::vector<double> values(const Asked& asked) const {
        const CampaignFile file(file_);
        return largest_values(file, read_campaign_file(file), asked);
    }
    ReplaySubject subject(int member, const Asked& asked) const {
        const CampaignFile file(file_);
        ReplaySubject made = replay_subject(file, read_campaign_file(file), member);
        made.about.asked = asked;
        return made;
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "moored.h5";
};

TEST_F(AskedOfAFile, IsTheResultantOverASecondInTheWindow) {
    EXPECT_THAT(values(force_over_1_s),
                ElementsAre(0, testing::DoubleNear(18, 1e-9), testing::DoubleNear(500, 1e-9), 0));
    EXPECT_THAT(values({AskedOf::mooring_force, 0}), ElementsAre(0, 900, 500, 0));
    EXPECT_NEAR(time_of_largest(subject(2, force_over_1_s)), 3.5, step + 1e-9);
    EXPECT_NEAR(time_of_largest(subject(1, {AskedOf::mooring_force, 0})), 2.02, 1e-9);
}

TEST_F(AskedOfAFile, IsTheLoadOverASecond) {
    EXPECT_THAT(values({AskedOf::load, 1}), ElementsAre(0, 0, testing::DoubleNear(25, 1e-9), 0));
    const double time = time_of_largest(subject(2, {AskedOf::load, 1}));
    EXPECT_GE(time, 6 - step);
    EXPECT_LE(time, 6.5 + step);
}

// A window of 6 s with values that are 0.02 s apart.
TEST_F(AskedOfAFile, RefusesMeansThatAreNotOfTheWindow) {
    for (const double averaging : {500.0, 0.01}) {
        const Asked asked{AskedOf::load, averaging};
        const auto sentence = testing::AllOf(HasSubstr("Case soft: no mean over "),
                                             HasSubstr("window of 6 s with values that are 0.02 s apart: give "
                                                       "--averaging-s from 0.02 to 6."));
        EXPECT_THAT(refusal([&] { values(asked); }), sentence);
        EXPECT_THAT(refusal([&] { time_of_largest(subject(2, asked)); }), sentence);
    }
    EXPECT_NEAR(values({AskedOf::load, 6}).at(2), 0.5 / 6 * 50, 1e-9);
    EXPECT_THAT(values({AskedOf::load, 0.02}), ElementsAre(0, 0, 50, 0));
    EXPECT_EQ(averaging_refusal({AskedOf::offset, 500}, 0.02, 6), "") << "it is taken as it is";
}

TEST_F(AskedOfAFile, IsTheOffsetAsItIs) {
    const std::vector<double> found = values({AskedOf::offset, 1});
    EXPECT_THAT(found, ElementsAre(testing::DoubleNear(5, 1e-9), 0, 0, 0));
    EXPECT_NEAR(time_of_largest(subject(0, {AskedOf::offset, 1})), 5.02, 1e-9);
}

TEST_F(AskedOfAFile, IsTheTensionOfTheRunWhoseMomentNoHistoryHas) {
    EXPECT_THAT(values({AskedOf::tension, 1}), ElementsAre(700, 800, 700, 700));
    EXPECT_TRUE(std::isnan(time_of_largest(subject(1, {AskedOf::tension, 1}))));
    EXPECT_TRUE(std::isnan(time_of_largest_tension(subject(1, {AskedOf::tension, 1})))) << "it has no lines";
    EXPECT_THAT(refusal([&] {
                    chosen_times(subject(1, {AskedOf::tension, 1}), {.worst = true});
                }),
                HasSubstr("does not say when the largest line tension of member 1 came: it has no mooring lines"));
    EXPECT_DOUBLE_EQ(chosen_times(subject(1, {AskedOf::tension, 1}), {.worst = true, .worst_at = 3}).through, 3);
}

TEST(HorizontalOffset, IsOfTheTurretAboutWhichTheHullTurns) {
    Moorings moorings;
    EXPECT_DOUBLE_EQ(horizontal_offset(moorings, 3, 4, 0.7), 5);
    moorings.turret.ahead = 10;
    EXPECT_NEAR(horizontal_offset(moorings, 10 * std::cos(0.3) - 10, 10 * std::sin(0.3), 0.3), 0, 1e-12);
}

TEST(RunningMean, IsOfWholeStretches) {
    EXPECT_THAT(running_mean(std::vector<double>{1, 2, 3, 4, 10}, 3), ElementsAre(2, 2, 3, 17.0 / 3, 17.0 / 3));
    EXPECT_THAT(running_mean(std::vector<double>{1, 3}, 5), ElementsAre(2, 2));
    EXPECT_THAT(running_mean(std::vector<double>{0, 4, 0, 0}, 2), ElementsAre(2, 2, 2, 0));
}

TEST(Asked, SaysWhatIsShown) {
    EXPECT_EQ(Asked{}.words(), "load of a step");
    EXPECT_EQ((Asked{AskedOf::load, 1}.words()), "load over 1 s");
    EXPECT_EQ(force_over_1_s.words(), "mooring force over 1 s");
    EXPECT_EQ((Asked{AskedOf::offset, 1}.words()), "offset");
    EXPECT_EQ((Asked{AskedOf::tension, 1}.words()), "line tension");
    EXPECT_EQ(force_over_1_s.within(), "in the window");
    EXPECT_EQ((Asked{AskedOf::tension, 1}.within()), "over the run");
}

}  // namespace asked_test
}  // namespace floes
