#include "run/crew.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <map>

#include "run/fakes.hpp"

namespace floes {
namespace crew_test {

std::map<int, Outcome> collect(Crew& crew) {
    std::map<int, Outcome> outcomes;
    while (crew.held() > 0) {
        crew.wait(std::chrono::seconds(10));
        for (Outcome& outcome : crew.take()) outcomes.emplace(outcome.number, std::move(outcome));
    }
    return outcomes;
}

TEST(Crew, ComputesWhatItIsGiven) {
    const Campaign campaign = synthetic::campaign();
    Crew crew(campaign, {fake::compute, 2});
    for (int number = 0; number < 5; ++number) crew.begin({number, 10 + number});
    EXPECT_EQ(crew.held(), 5);
    const auto outcomes = collect(crew);
    ASSERT_EQ(outcomes.size(), 5u);
    for (const auto& [number, outcome] : outcomes) {
        ASSERT_TRUE(outcome.record);
        EXPECT_EQ(outcome.record->attempt, 10 + number);
        EXPECT_EQ(outcome.record->result.load.mean, synthetic::record(campaign, number).result.load.mean);
    }
}

class CrewOfThreads : public testing::TestWithParam<int> {};

TEST_P(CrewOfThreads, RunsAsManyMembersAtATime) {
    // Each member waits until as many as there are threads run together: fewer threads never end, more are seen.
    const int threads = GetParam();
    std::atomic<int> running = 0;
    std::atomic<int> together = 0;
    const MemberFunction meet = [&](const Campaign&, int, std::stop_token stop) {
        const int now = ++running;
        for (int seen = together; now > seen && !together.compare_exchange_weak(seen, now);) {
        }
        while (together < threads && !stop.stop_requested()) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        --running;
        return MemberResult{};
    };
    const Campaign campaign = synthetic::campaign();
    Crew crew(campaign, {meet, threads});
    for (int number = 0; number < 4 * threads; ++number) crew.begin({number, 1});
    EXPECT_EQ(collect(crew).size(), 4u * static_cast<unsigned>(threads));
    EXPECT_EQ(together, threads);
}

INSTANTIATE_TEST_SUITE_P(Crew, CrewOfThreads, testing::Values(1, 2, 5));

TEST(Crew, TurnsExceptionsIntoFailedMembersWithTheReason) {
    const MemberFunction broken = [](const Campaign&, int number, std::stop_token) -> MemberResult {
        if (number == 0) throw std::runtime_error("the ice melted");
        throw 42;
    };
    const Campaign campaign = synthetic::campaign();
    Crew crew(campaign, {broken, 2});
    crew.begin({0, 1});
    crew.begin({1, 1});
    const auto outcomes = collect(crew);
    EXPECT_EQ(outcomes.at(0).record->result.status, MemberStatus::failed);
    EXPECT_EQ(outcomes.at(0).record->result.reason, "the ice melted");
    EXPECT_EQ(outcomes.at(1).record->result.status, MemberStatus::failed);
    EXPECT_FALSE(outcomes.at(1).record->result.reason.empty());
}

TEST(Crew, AbandonsRunningAndWaitingMembers) {
    const Campaign campaign = synthetic::campaign();
    Crew crew(campaign, {fake::wait_for_stop, 2});
    for (int number = 0; number < 6; ++number) crew.begin({number, 1});
    crew.wait(std::chrono::milliseconds(20));
    EXPECT_TRUE(crew.take().empty());
    crew.abandon();
    const auto outcomes = collect(crew);
    ASSERT_EQ(outcomes.size(), 6u);
    for (const auto& [number, outcome] : outcomes) EXPECT_FALSE(outcome.record);
}

TEST(Crew, KeepsAResultThatWasCompleteWhenTheStopCame) {
    std::atomic<bool> begun = false;
    const MemberFunction finishes_all_the_same = [&](const Campaign& campaign, int number, std::stop_token stop) {
        begun = true;
        while (!stop.stop_requested()) std::this_thread::yield();
        return fake::compute(campaign, number, stop);
    };
    const Campaign campaign = synthetic::campaign();
    Crew crew(campaign, {finishes_all_the_same, 1});
    crew.begin({3, 1});
    while (!begun) std::this_thread::yield();
    crew.abandon();
    EXPECT_TRUE(collect(crew).at(3).record);
}

TEST(Crew, LetsGoOfItsThreadsWhenItEnds) {
    const Campaign campaign = synthetic::campaign();
    std::atomic<int> inside = 0;
    {
        const MemberFunction count = [&](const Campaign& c, int number, std::stop_token stop) {
            ++inside;
            struct Leave {
                std::atomic<int>& count;
                ~Leave() { --count; }
            } leave{inside};
            return fake::wait_for_stop(c, number, std::move(stop));
        };
        Crew crew(campaign, {count, 2});
        crew.begin({0, 1});
        crew.begin({1, 1});
        while (inside < 2) std::this_thread::yield();
    }
    EXPECT_EQ(inside, 0);
}

}  // namespace crew_test
}  // namespace floes
