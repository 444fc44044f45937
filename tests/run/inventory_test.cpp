// Which members are done and which are still to do, from records alone.

#include "run/inventory.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace inventory_test {

class InventoryOf : public testing::Test {
  protected:
    Inventory take(const CampaignPart& part = {}, bool retry_failed = false) const {
        return take_inventory(campaign_, records_, attempts_, part, retry_failed);
    }

    void done(int number, double wall_time = 1) {
        records_.push_back(synthetic::record(campaign_, number));
        records_.back().result.wall_time = wall_time;
    }

    void failed(int number, int attempt) {
        records_.push_back(synthetic::failed_record(campaign_, number));
        records_.back().attempt = attempt;
    }

    /// A session is lost while the member is running.
    void lose(int number) {
        attempts_.started(identity(synthetic::record(campaign_, number)));
        attempts_.close_session();
    }

    static const MemberTask* find(const Inventory& found, int number) {
        const auto task = std::ranges::find(found.tasks, number, &MemberTask::number);
        return task == found.tasks.end() ? nullptr : &*task;
    }

    Campaign campaign_ = synthetic::campaign();  // 12 members, 2 attempts
    std::vector<MemberRecord> records_;
    AttemptBook attempts_;
};

TEST_F(InventoryOf, NothingIsAllMembersToCompute) {
    const Inventory found = take();
    ASSERT_EQ(found.tasks.size(), 12u);
    double cost = 0;
    for (int number = 0; number < 12; ++number) {
        const MemberTask& task = found.tasks[static_cast<std::size_t>(number)];
        EXPECT_EQ(task.number, number);
        EXPECT_EQ(task.cost, expected_cost(campaign_, number));
        EXPECT_EQ(task.batch, 0);
        EXPECT_EQ(task.attempts_made, 0);
        EXPECT_FALSE(task.suspect);
        cost += task.cost;
    }
    EXPECT_EQ(found.tasks_cost, cost);
    EXPECT_EQ(found.total, 12);
    EXPECT_EQ(found.done, 0);
    EXPECT_EQ(found.reused(), 0);
    EXPECT_EQ(found.retried, 0);
    EXPECT_EQ(found.pace, 0);
    EXPECT_FALSE(found.precision);
}

TEST_F(InventoryOf, DoneMembersAreReusedAndTellThePaceOfTheSlowest) {
    done(3, 30);
    done(0, 90);
    done(5, 1);
    const Inventory found = take();
    EXPECT_EQ(found.tasks.size(), 9u);
    for (const int number : {0, 3, 5}) EXPECT_EQ(find(found, number), nullptr) << number;
    EXPECT_EQ(found.total, 12);
    EXPECT_EQ(found.done, 3);
    EXPECT_EQ(found.reused(), 3);
    EXPECT_EQ(found.retried, 0);
    EXPECT_DOUBLE_EQ(found.pace, 90 / expected_cost(campaign_, 0));
}

TEST_F(InventoryOf, FailedMemberIsATaskWhileItHasAttemptsLeft) {
    failed(4, 1);
    Inventory found = take();
    ASSERT_NE(find(found, 4), nullptr);
    EXPECT_EQ(find(found, 4)->attempts_made, 1);
    EXPECT_EQ(find(found, 4)->failures, 1);
    EXPECT_FALSE(find(found, 4)->suspect);
    EXPECT_EQ(found.retried, 1);
    EXPECT_EQ(found.reused(), 0);
    failed(4, 2);
    found = take();
    EXPECT_EQ(find(found, 4), nullptr);
    EXPECT_EQ(found.set_aside, std::vector<int>{1});
    EXPECT_EQ(found.reused(), 1);
    EXPECT_EQ(found.done, 0);
    EXPECT_EQ(found.total, 12);
    EXPECT_EQ(found.retried, 0);
}

TEST_F(InventoryOf, RetryFailedGivesAsManyAttemptsAgain) {
    failed(4, 2);
    EXPECT_EQ(find(take(), 4), nullptr);
    const Inventory again = take({}, true);
    ASSERT_NE(find(again, 4), nullptr);
    EXPECT_EQ(find(again, 4)->attempts_made, 0);
    EXPECT_EQ(find(again, 4)->failures, 0);
    EXPECT_EQ(again.retried, 1);
    lose(4);
    EXPECT_EQ(find(take({}, true), 4)->attempts_made, 1);
}

TEST_F(InventoryOf, MemberThatWasLostIsASuspectHoweverOften) {
    for (int losses = 1; losses < 4; ++losses) {
        lose(5);
        const Inventory found = take();
        EXPECT_EQ(found.retried, 1);
        ASSERT_EQ(found.tasks.size(), 12u);
        for (const MemberTask& task : found.tasks) {
            EXPECT_EQ(task.suspect, task.number == 5);
            EXPECT_EQ(task.attempts_made, task.number == 5 ? losses : 0);
            EXPECT_EQ(task.failures, 0);
        }
    }
}

TEST_F(InventoryOf, PartHasItsArrangementsAndWhateverElseIsDone) {
    done(0);       // arrangement 0, of part 1
    done(3);       // arrangement 1, of part 2
    failed(4, 2);  // likewise
    const Inventory found = take({.number = 1, .of = 2});
    EXPECT_EQ(found.tasks.size(), 5u);
    for (const MemberTask& task : found.tasks) EXPECT_EQ(task.number / 3 % 2, 0) << task.number;
    EXPECT_EQ(found.total, 7);
    EXPECT_EQ(found.done, 2);
    EXPECT_TRUE(found.set_aside.empty());
}

TEST_F(InventoryOf, StopRuleOrdersTasksInBatchesAndEndsThemWhenItHolds) {
    campaign_ = synthetic::campaign(60);
    campaign_.stop.half_width = 0.25;
    campaign_.stop.minimum = 10;
    campaign_.stop.look_ahead = 2;
    campaign_.stop.batch = 4;
    constexpr int enough = 27;  // precision_test.cpp says why
    for (int number = 0; number < 3 * enough - 1; ++number) done(number);
    Inventory found = take();
    EXPECT_FALSE(found.precise());
    EXPECT_EQ(found.precision->arrangements(), enough - 1);
    for (const MemberTask& task : found.tasks) EXPECT_EQ(task.batch, task.number / 3 / 4);
    done(3 * enough - 1);
    failed(3 * enough, 1);
    found = take();
    EXPECT_TRUE(found.precise());
    EXPECT_EQ(found.precision->arrangements(), enough);
    EXPECT_TRUE(found.tasks.empty());
    EXPECT_EQ(found.tasks_cost, 0);
    EXPECT_EQ(found.retried, 0);
    EXPECT_EQ(found.done, 3 * enough);
    EXPECT_FALSE(take({.number = 1, .of = 2}).precision);
}

TEST_F(InventoryOf, MemberThatIsSetAsideIsNoGapForTheStopRule) {
    campaign_.stop.half_width = 0.01;
    for (const int number : {0, 1, 2, 3, 5}) done(number);
    failed(4, 1);
    EXPECT_EQ(take().precision->arrangements(), 1);
    failed(4, 2);
    EXPECT_EQ(take().precision->arrangements(), 2);
}

TEST_F(InventoryOf, RuleOfNoCaseIsRefusedUnlessOfAPart) {
    campaign_.stop.half_width = 0.1;
    campaign_.stop.case_name = "E61";
    EXPECT_THROW(take(), InputError);
    EXPECT_NO_THROW(take({.number = 1, .of = 2}));
}

}  // namespace inventory_test
}  // namespace floes
