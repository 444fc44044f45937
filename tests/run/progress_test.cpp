#include "run/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace floes {
namespace progress_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

ProgressState half_way() {
    return {.total = 10,
            .done = 4,
            .failed = 1,
            .running = 2,
            .finished_now = 3,
            .elapsed = 90,
            .finished_cost = 30,
            .remaining_cost = 100};
}

int lines(const std::ostringstream& out) {
    const std::string text = out.str();
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

TEST(ProgressState, EstimatesTimeLeftFromRemainingCostAndMeasuredRate) {
    EXPECT_DOUBLE_EQ(half_way().time_left(), 300.0);
    EXPECT_LT(ProgressState{.total = 3}.time_left(), 0);
}

TEST(ProgressText, SaysWhatThereIsToKnow) {
    EXPECT_EQ(progress_text(half_way()),
              "4 of 10 done, 1 failed, 2 running, 1:30 elapsed, 2.0 members/min, 5 min left");
    EXPECT_EQ(progress_text({.total = 3, .running = 2}), "0 of 3 done, 0 failed, 2 running");
    EXPECT_EQ(progress_text({.total = 3, .running = 2, .longest = {{7, 1, 300, 86, 200}, {2, 1, 250, 3, 200}}}),
              "0 of 3 done, 0 failed, 2 running; member 7 at 43 % (86 of 200 s), member 2 at 2 % (3 of 200 s)");
}

TEST(Progress, WritesAPlainLineAtTheStartAtEachTenthAndEachMinute) {
    std::ostringstream out;
    Progress progress(out, Progress::Style::plain);
    Progress::Time now{};
    ProgressState state{.total = 100};
    progress.show(state, now);
    EXPECT_EQ(lines(out), 1);
    state.done = 9;
    progress.show(state, now += seconds(30));
    EXPECT_EQ(lines(out), 1);
    state.done = 10;
    progress.show(state, now += seconds(1));
    EXPECT_EQ(lines(out), 2);
    progress.show(state, now += seconds(59));
    EXPECT_EQ(lines(out), 2);
    progress.show(state, now += seconds(1));
    EXPECT_EQ(lines(out), 3);
}

TEST(Progress, KeepsOneLiveLineOnATerminal) {
    std::ostringstream out;
    {
        Progress progress(out, Progress::Style::live);
        Progress::Time now{};
        for (int i = 0; i < 10; ++i) progress.show(half_way(), now += milliseconds(250));
        EXPECT_EQ(lines(out), 0);
        const std::string text = out.str();
        EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 5);
        progress.say("a note");
        EXPECT_NE(out.str().find("\r\033[Kfloes: a note\n"), std::string::npos);
        progress.show(half_way(), now += milliseconds(1));
    }
    EXPECT_EQ(out.str().back(), '\n');
}

TEST(Progress, IsLiveForAProgramThatAsksForIt) {
    ASSERT_EQ(::setenv("FLOES_PROGRESS", "live", 1), 0);
    EXPECT_EQ(style_of_standard_error(), Progress::Style::live);
    ASSERT_EQ(::unsetenv("FLOES_PROGRESS"), 0);
}

}  // namespace progress_test
}  // namespace floes
