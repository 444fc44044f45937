#include "run/signals.hpp"

#include <gtest/gtest.h>

#include "run/worker.hpp"

namespace floes {
namespace walltime_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(TimeLeftText, IsReadInEveryShapeThatSqueueHas) {
    EXPECT_EQ(parse_time_left("1-02:03:04\n"), 93784.0);
    EXPECT_EQ(parse_time_left("2:03:04"), 7384.0);
    EXPECT_EQ(parse_time_left("12:34"), 754.0);
    EXPECT_EQ(parse_time_left("0:00"), 0.0);
    for (const char* text : {"", "\n", "UNLIMITED", "NOT_SET", "INVALID", "1:2:3:4", "-5", "1-", "a:10"}) {
        EXPECT_FALSE(parse_time_left(text)) << text;
    }
}

TEST(TimeLeftText, IsWhatTheUserSaysFirst) {
    EXPECT_EQ(find_time_left(120), 120.0);
}

TEST(WalltimeClock, KeepsTimeForPublishing) {
    const Walltime::Time now{};
    const Walltime longer(7200.0, now);
    EXPECT_DOUBLE_EQ(*longer.left(now), 7140);
    EXPECT_DOUBLE_EQ(*longer.left(now + seconds(7200)), -60);
    EXPECT_DOUBLE_EQ(*Walltime(100.0, now).left(now), 90);
    EXPECT_FALSE(Walltime().left(now));
}

TEST(SilenceOfRanks, CountsOnlyWhileSomebodyListens) {
    const Silence::Time begin{};
    Silence silence(3, begin);
    silence.listened(begin + milliseconds(500));
    silence.heard(1);
    silence.listened(begin + seconds(1000));  // this process was stopped meanwhile
    EXPECT_DOUBLE_EQ(silence.of(1), 1.0);
    EXPECT_DOUBLE_EQ(silence.of(2), 1.5);
}

}  // namespace walltime_test
}  // namespace floes
