// Members in isolated processes, in every way they can end.

#include "run/attempt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <thread>

#include "core/bytes.hpp"
#include "member/array_output.hpp"
#include "run/members.hpp"

namespace floes {
namespace helper_test {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

// An address sanitizer maps terabytes and answers for the allocations itself: there is no limit to test.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

Bytes bytes_of(const MemberResult& result) {
    ByteWriter out;
    write(out, result);
    write_arrays(out, result);
    return out.take();
}

/// Whether the process is there and no zombie.
bool alive(pid_t pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    std::string word;
    for (int i = 0; i < 3; ++i) file >> word;
    return file && word != "Z" && word != "X";
}

bool gone_soon(pid_t pid) {
    for (int i = 0; i < 1000 && alive(pid); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return !alive(pid);
}

/// The first child of the process; 0 when there is none.
pid_t child_of(pid_t pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) + "/children");
    pid_t child = 0;
    file >> child;
    return child;
}

pid_t wait_for_child_of(pid_t pid) {
    for (int i = 0; i < 1000; ++i) {
        if (const pid_t child = child_of(pid); child != 0) return child;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "the helper has no child";
    return 0;
}

class HelperTest : public testing::Test {
  protected:
    HelperTest() { helper_.prepare(members::campaign()); }

    Attempted run(members::Way way, const AttemptLimits& limits = {}) const { return helper_.run(way, limits, {}); }

    std::string reason(members::Way way, const AttemptLimits& limits = {}) const {
        const Attempted attempt = run(way, limits);
        if (!attempt.result) return "abandoned";
        EXPECT_EQ(attempt.result->status, MemberStatus::failed);
        return attempt.result->reason;
    }

    Helper helper_{members::compute};
};

TEST_F(HelperTest, GivesTheResultToTheLastBit) {
    const Attempted attempt = run(members::good);
    ASSERT_TRUE(attempt.result);
    EXPECT_EQ(bytes_of(*attempt.result), bytes_of(members::good_result()));
    EXPECT_GT(attempt.peak_memory, 1'000'000u);
}

TEST_F(HelperTest, SaysHowAProcessEnded) {
    EXPECT_EQ(reason(members::crash), "The process of the member was killed by SIGSEGV (Segmentation fault).");
    EXPECT_EQ(reason(members::abort), "The process of the member was killed by SIGABRT (Aborted).");
    EXPECT_THAT(reason(members::killed), HasSubstr("SIGKILL (Killed): by a user, or by the system"));
    EXPECT_EQ(reason(members::leave), "The process of the member exited with status 3 without a result.");
    EXPECT_EQ(reason(members::exception), "the ice melted");
    EXPECT_EQ(reason(members::nan), "The load statistics of the member are not numbers.");
    EXPECT_TRUE(run(members::good).result) << "the helper survives it all";
}

TEST_F(HelperTest, EndsAMemberAtItsDeadlineHungOrStopped) {
    for (const members::Way way : {members::hang, members::stop_itself}) {
        const auto begin = Clock::now();
        EXPECT_THAT(reason(way, {.deadline = 0.2}), HasSubstr("not done after 0.2 s (run.member_deadline_s)"));
        EXPECT_GE(seconds_since(begin), 0.2);
        EXPECT_LT(seconds_since(begin), 5.0);
    }
    EXPECT_EQ(run(members::good, {.deadline = 60}).result->status, MemberStatus::done);
}

TEST_F(HelperTest, EndsAMemberThatRunsAwayWithMemory) {
    if (sanitized) GTEST_SKIP();
    const AttemptLimits limits{.memory = 64u << 20};
    EXPECT_EQ(reason(members::eat_memory, limits),
              "The member needed more than the 64 MiB of memory that run.member_memory_MiB allows.");
    EXPECT_EQ(run(members::good, limits).result->status, MemberStatus::done);
}

TEST_F(HelperTest, AbandonsOnRequestAndEndsTheChild) {
    std::stop_source stop;
    std::jthread later([&] {
        const pid_t child = wait_for_child_of(helper_.pid());
        stop.request_stop();
        EXPECT_TRUE(gone_soon(child));
    });
    EXPECT_FALSE(helper_.run(members::hang, {}, stop.get_token()).result);
}

TEST_F(HelperTest, RunsManyAtATimeFromManyThreads) {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < 4; ++thread) {
        threads.emplace_back([&] {
            for (int i = 0; i < 25; ++i) {
                EXPECT_EQ(run(members::good).result->status, MemberStatus::done);
                EXPECT_THAT(reason(members::crash), HasSubstr("SIGSEGV"));
            }
        });
    }
}

TEST_F(HelperTest, TellsWhenItIsGoneAndTakesItsChildrenAlong) {
    pid_t child = 0;
    std::jthread later([&] {
        child = wait_for_child_of(helper_.pid());
        ::kill(helper_.pid(), SIGKILL);
    });
    EXPECT_THROW(run(members::hang), HelperLost);
    later.join();
    EXPECT_TRUE(gone_soon(child));
    EXPECT_THROW(run(members::good), HelperLost);
}

TEST_F(HelperTest, TellsWhenItDoesNotAnswer) {
    ::kill(helper_.pid(), SIGSTOP);
    EXPECT_THROW(run(members::good, {.deadline = 0.1, .grace = 0.1}), HelperLost);
}

TEST(HelperLife, EndsWithTheProcessThatStartedItHoweverThatEnds) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
        Helper helper(members::compute);
        helper.prepare(members::campaign());
        std::jthread member([&] { helper.run(members::hang, {}, {}); });
        const std::array<pid_t, 2> pids{helper.pid(), wait_for_child_of(helper.pid())};
        [[maybe_unused]] const auto written = ::write(ends[1], pids.data(), sizeof pids);
        ::raise(SIGKILL);
    }
    std::array<pid_t, 2> pids{};
    ASSERT_EQ(::read(ends[0], pids.data(), sizeof pids), static_cast<ssize_t>(sizeof pids));
    ::waitpid(parent, nullptr, 0);
    EXPECT_TRUE(gone_soon(pids[0]));
    EXPECT_TRUE(gone_soon(pids[1]));
}

/// Of a process that does nothing, s: what the machine takes for it just now.
double cost_of_a_process() {
    const auto begin = Clock::now();
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return seconds_since(begin);
}

// Beside processes that do nothing, each time at the same moment: a busy machine slows both.
TEST(HelperCost, IsThatOfAFewProcesses) {
    const MemberFunction nothing = [](const Campaign&, int, std::stop_token) { return MemberResult{}; };
    Helper helper(nothing);
    helper.prepare(members::campaign());
    std::vector<double> ratios;
    for (int i = 0; i < 200; ++i) {
        const auto begin = Clock::now();
        helper.run(0, {.deadline = 100, .memory = 1u << 30}, {});
        const double attempt = seconds_since(begin);
        ratios.push_back(attempt / cost_of_a_process());
    }
    std::nth_element(ratios.begin(), ratios.begin() + 100, ratios.end());
    RecordProperty("median_ratio", std::to_string(ratios[100]));
    if (!sanitized) {
        EXPECT_LT(ratios[100], 15);
    }
}

}  // namespace helper_test
}  // namespace floes
