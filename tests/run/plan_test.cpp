#include "run/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scenario/floes.hpp"
#include "store/member_record.hpp"
#include "support/level_ice.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace plan_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double mean_run_time(const std::vector<SimulatedMember>& members) {
    double sum = 0;
    for (const SimulatedMember& member : members) sum += member.run_time;
    return sum / static_cast<double>(members.size());
}

TEST(ExpectedMembers, TakeAsLongAsTheirCostSays) {
    const Campaign campaign = synthetic::campaign(5000);
    const PlannedMembers planned = expected_members(campaign);
    ASSERT_EQ(planned.members.size(), 15'000u);
    double expected = 0;
    for (int number = 0; number < 3; ++number) expected += expected_cost(campaign, number) / 3;
    const double per_unit = mean_run_time(planned.members) / expected;
    Campaign stock = campaign;
    for (Case& one : stock.cases) one.scenario.general.solver = SolverKind::stock;
    EXPECT_GT(mean_run_time(expected_members(stock).members) / expected, 5 * per_unit);
    // The scatter has mean 1: the mean over many is that of the costs.
    const MemberCosts costs;
    const bool direct = campaign.cases[0].scenario.general.solver == SolverKind::direct;
    EXPECT_NEAR(per_unit, direct ? costs.direct_per_unit : costs.lanes_per_unit, 0.01 * per_unit);
    Campaign legs = campaign;
    for (Case& one : legs.cases) {
        one.scenario.general.solver = SolverKind::direct;
        one.scenario.structure.shape = Shape({{-0.4, 0.6}, {0, 0.6}, {0.1, 0.6}});
    }
    EXPECT_NEAR(mean_run_time(expected_members(legs).members) / expected, costs.jam * costs.direct_per_unit,
                0.01 * costs.jam * costs.direct_per_unit);
}

// The paper's tank, by what an element in a step costs: half the side is four times the elements.
TEST(CostWords, SayWhatOtherElementsAndWindowsCost) {
    Campaign campaign{{.name = "tank"}, {}};
    Scenario scenario;
    scenario.ice.elastic_modulus = 60e6;
    scenario.analysis.window = 1500;
    scenario.field.far_end = FarEnd::never;
    campaign.cases.push_back({"long", scenario});
    const double seconds = MemberCosts().direct_per_unit * scenario.step_count() * 9 * computed_floes(scenario);
    EXPECT_DOUBLE_EQ(expected_run_time(campaign, 0), seconds);
    const std::vector<std::string> words = cost_words(campaign);
    ASSERT_EQ(words.size(), 1u);
    const double elements = 9 * computed_floes(scenario);
    EXPECT_NE(words[0].find(fmt::format("case long: a member takes about {} of one core", duration_text(seconds))),
              std::string::npos)
        << words[0];
    EXPECT_NE(words[0].find(fmt::format("{:.0f} elements over 81000 steps", elements)), std::string::npos) << words[0];
    EXPECT_NE(words[0].find("; with analysis.window_s of 750 s "), std::string::npos) << words[0];
    campaign.cases.front().scenario.analysis.window = 150;
    EXPECT_EQ(cost_words(campaign).size(), 0u) << "of some seconds nobody needs to know";
    campaign.cases.assign(9, {"long", scenario});
    ASSERT_EQ(cost_words(campaign).size(), 1u);
    EXPECT_EQ(
        cost_words(campaign)[0],
        fmt::format("a member of 9 of the cases takes about {} of one core (floes plan).", duration_text(seconds)));
}

// What a sheet costs grows faster than with its elements.
TEST(CostWords, CountTheElementsOfASheet) {
    Campaign campaign{{.name = "sheet"}, {{"one", test::level_strip(0.8, 0.1, 60)}}};
    campaign.cases[0].scenario.analysis.window = 499.96;
    const double elements = sheet_shape(campaign.cases[0].scenario).elements();
    EXPECT_THAT(cost_words(campaign),
                testing::Contains(testing::HasSubstr(fmt::format(", {:.0f} elements ", elements))));
}

TEST(ExpectedMembers, HaveTheSizeOfTheirRecords) {
    const Campaign campaign = synthetic::campaign();
    const PlannedMembers planned = expected_members(campaign);
    for (int number = 0; number < member_count(campaign); ++number) {
        const SimulatedMember& member = planned.members[static_cast<std::size_t>(number)];
        MemberRecord record = synthetic::record(campaign, number);
        record.result.breaks.clear();
        for (AveragedLoad& one : record.result.averaged) one.peaks.clear();  // the window is shorter than a separation
        record.host = "node0000";
        const auto numbers = 3.0 * static_cast<double>(record.result.history.surge.size());
        record.result.history = {};
        record.result.load_map = {};
        const auto others = static_cast<double>(encode(record).size());
        const double map = 8.0 * (2 * LoadMap::heights * LoadMap::angles + LoadMap::parts);  // hardly compressed
        EXPECT_EQ(member.packed_bytes, 0) << "so few steps are left as they are";
        const double bytes = others + MemberCosts().history_bytes * numbers;
        EXPECT_GT(member.record_bytes, bytes + 0.8 * map);
        EXPECT_LT(member.record_bytes, bytes + 1.1 * map);
    }
}

TEST(ExpectedMembers, AreTheSameEveryTimeAndDependOnTheSeed) {
    Campaign campaign = synthetic::campaign();
    const PlannedMembers one = expected_members(campaign);
    EXPECT_EQ(one.members[7].run_time, expected_members(campaign).members[7].run_time);
    campaign.seed += 1;
    EXPECT_NE(one.members[7].run_time, expected_members(campaign).members[7].run_time);
}

TEST(MeasuredMembers, DrawFromTheirOwnCase) {
    const Campaign small = synthetic::campaign(2);
    // soft: 10 and 20 s; stiff: only 7 s; open: none done.
    const MeasuredRun run{small, {10, 7, nan, 20, nan, nan}, 3e6, 1e6};
    const Campaign large = synthetic::campaign(400);
    const PlannedMembers planned = measured_members(large, run);
    int tens = 0;
    for (int number = 0; number < member_count(large); number += 3) {
        const double soft = planned.members[static_cast<std::size_t>(number)].run_time;
        EXPECT_TRUE(std::abs(soft - 10) < 1e-9 || std::abs(soft - 20) < 1e-9) << soft;
        tens += soft < 15 ? 1 : 0;
        EXPECT_NEAR(planned.members[static_cast<std::size_t>(number) + 1].run_time, 7, 1e-9);
        // Nothing is known of "open" but its cost beside that of the others.
        const double ratio = expected_cost(large, 2) / expected_cost(large, 0);
        EXPECT_LE(planned.members[static_cast<std::size_t>(number) + 2].run_time, 20 * ratio + 1e-9);
    }
    EXPECT_NEAR(tens, 200, 40);  // four standard deviations of a fair coin
    // Three members took 3 MB of journal and 1 MB of file, of which some is there without members too.
    EXPECT_NEAR(planned.members[0].record_bytes, 1e6, 0.1e6);
    const std::vector<SimulatedMember> expected = expected_members(large).members;
    const double foreseen = MemberCosts().file_bytes + 2 * expected[0].file_bytes + expected[1].file_bytes;
    EXPECT_NEAR(planned.members[0].file_bytes / expected[0].file_bytes, 1e6 / foreseen, 1e-9);
    EXPECT_EQ(planned.source, "3 measured members of synthetic");
}

TEST(MeasuredMembers, NeedAMeasurement) {
    const Campaign campaign = synthetic::campaign(1);
    EXPECT_THROW(measured_members(campaign, {campaign, {nan, nan, nan}, 0}), InputError);
}

TEST(PlanRow, FollowsTheMembers) {
    EXPECT_EQ(usual_ranks(1), 1);
    EXPECT_EQ(usual_ranks(64), 1);
    EXPECT_EQ(usual_ranks(65), 2);
    const std::vector<SimulatedMember> members(10, {1.0, 1.0, 1000, 500});
    const PlanRow row = plan_row(members, machine_of(5, 1), {.memory_per_member = 300});
    EXPECT_DOUBLE_EQ(row.forecast.wall_time, 2.0);
    EXPECT_DOUBLE_EQ(row.forecast.journal_bytes, 10'000);
    EXPECT_DOUBLE_EQ(row.master_memory, 3'000);
}

TEST(ExpectedMembers, HaveSmallerRecordsWithoutHistories) {
    Campaign campaign = synthetic::campaign(1);
    campaign.cases[0].scenario.analysis.window *= 2;  // so few steps are not packed
    const SimulatedMember with = expected_members(campaign).members[0];
    campaign.cases[0].scenario.analysis.keep_history = false;
    const SimulatedMember without = expected_members(campaign).members[0];
    const double of_history =
        (3 + 3.0 / steps_a_look) * MemberCosts().history_bytes * campaign.cases[0].scenario.step_count();
    EXPECT_NEAR(with.record_bytes - without.record_bytes, of_history, 1e-9 * of_history);
    EXPECT_NEAR(with.file_bytes - without.file_bytes, of_history, 1e-9 * of_history);
    EXPECT_DOUBLE_EQ(with.packed_bytes, with.record_bytes - without.record_bytes);
}

}  // namespace plan_test
}  // namespace floes
