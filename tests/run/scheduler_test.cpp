#include "run/scheduler.hpp"

#include <gtest/gtest.h>

#include "core/contract.hpp"

namespace floes {
namespace scheduler_test {

std::vector<Command> handle(Scheduler& scheduler, const Event& event) {
    const std::vector<Command> commands = scheduler.handle(event);
    scheduler.check_invariants();
    return commands;
}

TEST(Scheduler, HandsOutLongestFirstAndTiesByNumber) {
    Scheduler scheduler({{4, 1.0}, {3, 2.0}, {1, 1.0}, {2, 5.0}});
    const auto commands = handle(scheduler, WorkerJoined{0, 4, 0});
    const std::vector<Command> expected{Assign{0, 2, 1}, Assign{0, 3, 1}, Assign{0, 1, 1}, Assign{0, 4, 1}};
    EXPECT_EQ(commands, expected);
}

TEST(Scheduler, FinishesAnEarlierBatchBeforeItBeginsALaterOne) {
    Scheduler scheduler({{0, 9.0, 1}, {1, 1.0, 0}});
    EXPECT_EQ(handle(scheduler, WorkerJoined{0, 2, 0}), (std::vector<Command>{Assign{0, 1, 1}, Assign{0, 0, 1}}));
}

TEST(Scheduler, ServesTheWorkerWithTheMostIdleCores) {
    Scheduler scheduler({{0, 1.0}, {1, 1.0}, {2, 1.0}, {3, 1.0}, {4, 1.0}});
    handle(scheduler, WorkerJoined{0, 3, 0});
    handle(scheduler, WorkerJoined{1, 3, 0});  // takes the last two: nothing is pending
    EXPECT_EQ(scheduler.pending(), 0);
    EXPECT_EQ(handle(scheduler, WorkerLeft{0}), (std::vector<Command>{Assign{1, 0, 2}}));
    EXPECT_EQ(handle(scheduler, WorkerJoined{2, 3, 0}), (std::vector<Command>{Assign{2, 1, 2}, Assign{2, 2, 2}}));
}

TEST(Scheduler, LeavesMembersToTheWorkersThatAreStillToJoin) {
    std::vector<MemberTask> tasks;
    for (int i = 0; i < 12; ++i) tasks.push_back({i, 1.0});
    Scheduler scheduler(tasks);
    for (int worker = 0; worker < 12; ++worker) handle(scheduler, WorkerJoined{worker, 1, 1});
    EXPECT_EQ(scheduler.running(), 12);
}

TEST(Scheduler, GivesMembersAheadOfTheCoresOnlyWhileManyArePending) {
    std::vector<MemberTask> tasks;
    for (int i = 0; i < 5; ++i) tasks.push_back({i, 1.0});
    Scheduler scheduler(tasks);
    handle(scheduler, WorkerJoined{0, 1, 1});
    EXPECT_EQ(scheduler.assigned(), 1);
    handle(scheduler, MemberFinished{0, 0, 1});  // one runs, three pending: one ahead
    EXPECT_EQ(scheduler.assigned(), 2);
    EXPECT_EQ(scheduler.running(), 1);
    handle(scheduler, MemberFinished{0, 1, 1});  // two pending for one core: one runs, one still waits ahead
    EXPECT_EQ(scheduler.assigned(), 2);
    handle(scheduler, MemberFinished{0, 2, 1});  // one pending: nobody takes it ahead
    EXPECT_EQ(scheduler.assigned(), 1);
    EXPECT_EQ(scheduler.pending(), 1);
}

/// Of 1000 members of cost 1, those that two workers hold once one was done in `run_time` seconds.
std::vector<int> held_after(double run_time, double affordable = 1e9) {
    std::vector<MemberTask> tasks;
    for (int i = 0; i < 1000; ++i) tasks.push_back({i, 1.0});
    Scheduler scheduler(tasks);
    std::vector<Command> all;
    const auto tell = [&](const Event& event) {
        for (const Command& command : handle(scheduler, event)) all.push_back(command);
    };
    tell(WorkerJoined{0, 1, 1});
    tell(WorkerJoined{1, 4, 4});
    tell(TimeLeft{affordable});
    tell(MemberFinished{0, 0, 1, AttemptEnd::done, run_time});
    std::vector<int> held{-1, 0};
    for (const Command& command : all) {
        if (const auto* assign = std::get_if<Assign>(&command)) ++held[static_cast<std::size_t>(assign->worker)];
    }
    return held;
}

TEST(Scheduler, GivesShortMembersAheadByTheDozen) {
    EXPECT_EQ(held_after(60.0), (std::vector<int>{1 + 1, 4 + 4}));
    EXPECT_EQ(held_after(0.2), (std::vector<int>{1 + 1, 4 + 4}));
    EXPECT_EQ(held_after(0.01), (std::vector<int>{1 + 20, 4 + 80})) << "0.2 s of members for each core";
    EXPECT_EQ(held_after(0.0), (std::vector<int>{1 + 64, 4 + 256}));
}

// The third round ahead begins when three others have ended.
TEST(Scheduler, CountsTheRoundsAheadAgainstTheTimeLeft) {
    EXPECT_EQ(held_after(0.01, 4.5), (std::vector<int>{1 + 3, 4 + 12}));
    EXPECT_EQ(held_after(0.01, 1.5), (std::vector<int>{1, 4}));
}

TEST(Scheduler, KeepsAnAnswerOnceAndDismissesWhenAllIsDone) {
    Scheduler scheduler({{7, 1.0}});
    handle(scheduler, WorkerJoined{0, 1, 0});
    handle(scheduler, WorkerJoined{1, 1, 0});
    EXPECT_EQ(handle(scheduler, MemberFinished{0, 7, 1}), (std::vector<Command>{Keep{7, 1}, Dismiss{0}, Dismiss{1}}));
    EXPECT_FALSE(scheduler.finished());
    EXPECT_TRUE(handle(scheduler, MemberFinished{0, 7, 1}).empty());
    EXPECT_EQ(scheduler.late_answers(), 1);
    handle(scheduler, WorkerLost{0});
    handle(scheduler, WorkerLost{1});
    EXPECT_TRUE(scheduler.finished());
}

TEST(Scheduler, RecognisesTheLateAnswerOfALostWorker) {
    Scheduler scheduler({{7, 1.0}});
    handle(scheduler, WorkerJoined{1, 1, 0});
    EXPECT_TRUE(handle(scheduler, WorkerLost{1}).empty());
    EXPECT_EQ(handle(scheduler, WorkerJoined{2, 1, 0}), (std::vector<Command>{Assign{2, 7, 2, true}}));
    EXPECT_TRUE(handle(scheduler, MemberFinished{1, 7, 1}).empty());
    EXPECT_TRUE(handle(scheduler, MemberFinished{2, 7, 1}).empty());
    EXPECT_EQ(scheduler.late_answers(), 2);
    EXPECT_EQ(handle(scheduler, MemberFinished{2, 7, 2}), (std::vector<Command>{Keep{7, 2}, Dismiss{2}}));
}

TEST(Scheduler, CountsAttemptsOfEarlierRuns) {
    Scheduler scheduler({{7, 1.0, 0, 3}});
    EXPECT_EQ(handle(scheduler, WorkerJoined{0, 1, 0}), (std::vector<Command>{Assign{0, 7, 4}}));
}

TEST(Scheduler, TriesAFailedMemberAgainUntilItHasFailedTooOften) {
    Scheduler scheduler({{7, 1.0}}, 2);
    handle(scheduler, WorkerJoined{0, 1, 0});
    EXPECT_EQ(handle(scheduler, MemberFinished{0, 7, 1, AttemptEnd::failed}),
              (std::vector<Command>{Retry{7, 1}, Assign{0, 7, 2}}));
    EXPECT_EQ(handle(scheduler, MemberFinished{0, 7, 2, AttemptEnd::failed}),
              (std::vector<Command>{Keep{7, 2}, Dismiss{0}}));
}

TEST(Scheduler, CountsFailuresOfEarlierRunsButNotLosses) {
    Scheduler scheduler({{.number = 7, .cost = 1.0, .attempts_made = 4, .failures = 1, .suspect = true}}, 2);
    EXPECT_EQ(handle(scheduler, WorkerJoined{0, 1, 0}), (std::vector<Command>{Assign{0, 7, 5, true}}));
    EXPECT_EQ(handle(scheduler, MemberFinished{0, 7, 5, AttemptEnd::failed}),
              (std::vector<Command>{Keep{7, 5}, Dismiss{0}}));
}

TEST(Scheduler, BeginsNoMemberThatCannotBeDoneInTheTimeLeft) {
    Scheduler scheduler({{0, 9.0}, {1, 4.0}, {2, 3.0}, {3, 1.0}});
    handle(scheduler, TimeLeft{4.0});
    EXPECT_EQ(handle(scheduler, WorkerJoined{0, 1, 0}), (std::vector<Command>{Assign{0, 1, 1}}));
    handle(scheduler, TimeLeft{1.5});
    EXPECT_EQ(handle(scheduler, MemberFinished{0, 1, 1}), (std::vector<Command>{Keep{1, 1}, Assign{0, 3, 1}}));
    EXPECT_EQ(handle(scheduler, MemberFinished{0, 3, 1}), (std::vector<Command>{Keep{3, 1}}));
    EXPECT_EQ(scheduler.assigned(), 0);
    EXPECT_EQ(scheduler.pending(), 2);
}

TEST(Scheduler, HandsOutNothingNewAfterAStop) {
    Scheduler scheduler({{0, 1.0}, {1, 1.0}, {2, 1.0}});
    handle(scheduler, WorkerJoined{0, 1, 0});
    EXPECT_EQ(handle(scheduler, StopRequested{}), (std::vector<Command>{Dismiss{0}}));
    EXPECT_TRUE(handle(scheduler, StopRequested{}).empty());
    EXPECT_EQ(handle(scheduler, MemberFinished{0, 0, 1}), (std::vector<Command>{Keep{0, 1}}));
    EXPECT_EQ(handle(scheduler, WorkerJoined{1, 1, 0}), (std::vector<Command>{Dismiss{1}}));
    handle(scheduler, WorkerLost{0});
    handle(scheduler, WorkerLost{1});
    EXPECT_TRUE(scheduler.finished());
    EXPECT_EQ(scheduler.pending(), 2);
}

TEST(Scheduler, DismissesAtOnceWhenThereIsNothingToDo) {
    Scheduler scheduler({});
    EXPECT_EQ(handle(scheduler, WorkerJoined{0, 1, 0}), (std::vector<Command>{Dismiss{0}}));
}

TEST(Scheduler, KnowsWhatIsLeftToPayFor) {
    Scheduler scheduler({{0, 4.0}, {1, 1.5}});
    handle(scheduler, WorkerJoined{0, 2, 0});
    handle(scheduler, MemberFinished{0, 0, 1});
    EXPECT_DOUBLE_EQ(scheduler.done_cost(), 4.0);
    EXPECT_DOUBLE_EQ(scheduler.remaining_cost(), 1.5);
}

TEST(Scheduler, RefusesWhatCannotBe) {
    EXPECT_THROW(Scheduler({{1, 1.0}, {1, 1.0}}), ContractError);
    EXPECT_THROW(Scheduler({{1, 0.0}}), ContractError);
    Scheduler scheduler({{1, 1.0}});
    EXPECT_THROW(scheduler.handle(WorkerJoined{0, 0, 0}), ContractError);
    scheduler.handle(WorkerJoined{0, 1, 0});
    EXPECT_THROW(scheduler.handle(WorkerJoined{0, 1, 0}), ContractError);
}

}  // namespace scheduler_test
}  // namespace floes
