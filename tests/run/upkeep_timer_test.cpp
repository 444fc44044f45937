#include "run/recorder.hpp"

#include <gtest/gtest.h>

namespace floes {
namespace upkeep_timer_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

const UpkeepTimer::Time begin{seconds(1000)};

TEST(SyncTimer, SyncsWithinASecond) {
    SyncTimer timer(begin);
    EXPECT_FALSE(timer.is_unsynced());
    timer.kept();
    EXPECT_TRUE(timer.is_unsynced());
    EXPECT_FALSE(timer.is_due(begin + milliseconds(899)));
    EXPECT_TRUE(timer.is_due(begin + milliseconds(900)));
    timer.synced(begin + milliseconds(950));
    EXPECT_FALSE(timer.is_unsynced());
    EXPECT_FALSE(timer.is_due(begin + milliseconds(1849)));
    EXPECT_TRUE(timer.is_due(begin + milliseconds(1850)));
}

TEST(UpkeepTimer, WritesAHeartbeatAtOnceAndThenEveryFiveSeconds) {
    UpkeepTimer timer(begin, seconds(300));
    EXPECT_TRUE(timer.heartbeat_is_due(begin));
    timer.heartbeat_written(begin + seconds(1));
    EXPECT_FALSE(timer.heartbeat_is_due(begin + milliseconds(5999)));
    EXPECT_TRUE(timer.heartbeat_is_due(begin + seconds(6)));
}

TEST(UpkeepTimer, PublishesOnlyWhatIsNew) {
    UpkeepTimer timer(begin, seconds(300));
    EXPECT_FALSE(timer.publishing_is_due(begin + seconds(1000)));
    timer.kept();
    EXPECT_FALSE(timer.publishing_is_due(begin + seconds(299)));
    EXPECT_TRUE(timer.publishing_is_due(begin + seconds(300)));
    timer.published(begin + seconds(300), begin + seconds(301), true);
    EXPECT_FALSE(timer.publishing_is_due(begin + seconds(1000)));
    timer.kept();
    EXPECT_FALSE(timer.publishing_is_due(begin + seconds(600)));
    EXPECT_TRUE(timer.publishing_is_due(begin + seconds(601)));
}

TEST(UpkeepTimer, PublishingTakesAtMostATwentiethOfTheTime) {
    UpkeepTimer timer(begin, seconds(300));
    timer.kept();
    timer.published(begin + seconds(300), begin + seconds(400), true);
    timer.kept();
    EXPECT_FALSE(timer.publishing_is_due(begin + seconds(400 + 20 * 100 - 1)));
    EXPECT_TRUE(timer.publishing_is_due(begin + seconds(400 + 20 * 100)));
}

TEST(UpkeepTimer, TriesAgainToPublishWhenItDidNotSucceed) {
    UpkeepTimer timer(begin, seconds(10));
    timer.kept();
    timer.published(begin + seconds(10), begin + seconds(11), false);
    EXPECT_FALSE(timer.publishing_is_due(begin + seconds(30)));
    EXPECT_TRUE(timer.publishing_is_due(begin + seconds(31)));
}

}  // namespace upkeep_timer_test
}  // namespace floes
