#include "run/attempt.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "member/run_member.hpp"
#include "support/short_scenario.hpp"

namespace floes {
namespace member_function_test {

/// Two cases of one field geometry, in which the tow reaches the ice.
Campaign short_campaign() {
    Campaign made;
    made.name = "short";
    made.seed = 7;
    made.arrangements = 2;
    Scenario scenario = short_scenario();
    made.cases.push_back({"soft", scenario});
    scenario.joint.cfm = 1e-10;
    made.cases.push_back({"stiff", scenario});
    return made;
}

/// Where its floes lie at t = 0.
std::vector<double> places(const MemberResult& result) {
    std::vector<double> numbers;
    for (const PlanarPose& pose : result.arrangement) numbers.insert(numbers.end(), {pose.x, pose.z, pose.yaw});
    return numbers;
}

MemberResult computed(const Campaign& campaign, int number) {
    return compute_member(campaign, number, {});
}

TEST(ComputeMember, RunsTheScenarioOfItsCaseWithItsArrangement) {
    const Campaign campaign = short_campaign();
    for (int number = 0; number < 4; ++number) {
        const Scenario& scenario = campaign.cases[static_cast<std::size_t>(number % 2)].scenario;
        const MemberResult expected = run_member(scenario, 7, static_cast<std::uint32_t>(number / 2));
        const MemberResult result = computed(campaign, number);
        ASSERT_EQ(result.status, MemberStatus::done) << result.reason;
        EXPECT_EQ(result.history.surge, expected.history.surge) << number;
        EXPECT_EQ(places(result), places(expected)) << number;
    }
}

TEST(ComputeMember, GivesCasesThatDifferOtherLoads) {
    const Campaign campaign = short_campaign();
    EXPECT_NE(computed(campaign, 0).history.surge, computed(campaign, 1).history.surge);
}

TEST(ComputeMember, DrawsFromTheSeedOfItsCase) {
    Campaign campaign = short_campaign();
    EXPECT_EQ(places(computed(campaign, 0)), places(computed(campaign, 1)));
    EXPECT_NE(places(computed(campaign, 0)), places(computed(campaign, 2)));
    campaign.common_arrangements = false;
    EXPECT_NE(places(computed(campaign, 0)), places(computed(campaign, 1)));
}

TEST(ComputeMember, EndsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(compute_member(short_campaign(), 0, stop.get_token()), Interrupted);
}

}  // namespace member_function_test
}  // namespace floes
