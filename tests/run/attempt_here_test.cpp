// Members in this process: failures that can be contained are contained.

#include "run/attempt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <new>

#include "run/members.hpp"

namespace floes {
namespace attempt_here_test {

using testing::HasSubstr;

Attempted here(const MemberFunction& compute, int number, const AttemptLimits& limits = {}, std::stop_token stop = {}) {
    return attempt_here(compute, members::campaign(), number, limits, std::move(stop),
                        [] { ADD_FAILURE() << "it is not stuck"; });
}

TEST(AttemptHere, GivesResultsAndContainsExceptionsAndNonsense) {
    EXPECT_EQ(here(members::compute, members::good).result->load.mean, 0.1);
    EXPECT_EQ(here(members::compute, members::exception).result->reason, "the ice melted");
    EXPECT_THAT(here(members::compute, members::nan).result->reason, HasSubstr("not numbers"));
    const MemberFunction hungry = [](const Campaign&, int, std::stop_token) -> MemberResult { throw std::bad_alloc(); };
    EXPECT_EQ(here(hungry, 0).result->reason, "There was not enough memory for the member.");
    const MemberFunction silent = [](const Campaign&, int, std::stop_token) -> MemberResult { throw 42; };
    EXPECT_THAT(here(silent, 0).result->reason, HasSubstr("without a message"));
}

TEST(AttemptHere, EndsAtTheDeadlineAMemberThatLooks) {
    const Attempted attempt = here(members::compute, members::waits_for_stop, {.deadline = 0.05});
    EXPECT_THAT(attempt.result->reason, HasSubstr("not done after 0.05 s"));
}

TEST(AttemptHere, KeepsAResultThatComesLateAllTheSame) {
    const MemberFunction late = [](const Campaign& campaign, int, std::stop_token stop) {
        while (!stop.stop_requested()) std::this_thread::yield();
        return members::compute(campaign, members::good, stop);
    };
    EXPECT_EQ(here(late, 0, {.deadline = 0.05}).result->status, MemberStatus::done);
}

TEST(AttemptHere, AbandonsOnRequest) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(here(members::compute, members::waits_for_stop, {.deadline = 60}, stop.get_token()).result);
}

TEST(AttemptHere, TellsWhenAMemberDoesNotLook) {
    std::atomic<bool> stuck = false;
    const MemberFunction deaf = [&](const Campaign&, int, std::stop_token) -> MemberResult {
        while (!stuck) std::this_thread::yield();
        throw std::runtime_error("at last");
    };
    attempt_here(deaf, members::campaign(), 0, {.deadline = 0.02, .grace = 0.02}, {}, [&] { stuck = true; });
    EXPECT_TRUE(stuck);
}

}  // namespace attempt_here_test
}  // namespace floes
