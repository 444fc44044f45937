// What a resumed run finds in the journal of earlier runs.

#include "run/recorder.hpp"

#include <gtest/gtest.h>

#include "campaign_file/read.hpp"
#include "run/fakes.hpp"

namespace floes {
namespace recorder_test {

/// The journal of a campaign over several sessions, each a Recorder of its own.
class Sessions : public testing::Test {
  protected:
    Recorder open(bool retry_failed = false) {
        Recorder recorder(
            campaign_, {.campaign_file = folder_ / "a.h5", .existing = Existing::resume, .retry_failed = retry_failed});
        recorder.begin(synthetic::session());
        return recorder;
    }

    /// A session that is killed while `number` is running.
    void lose(int number, bool retry_failed = false) {
        Recorder recorder = open(retry_failed);
        recorder.started(number, attempts_made(recorder, number) + 1);
    }

    /// -1 when the member is no task.
    static int attempts_made(const Recorder& recorder, int number) {
        for (const MemberTask& task : recorder.tally().found().tasks)
            if (task.number == number) return task.attempts_made;
        return -1;
    }

    CampaignTable published() {
        open().finish("stopped");
        return read_campaign_file(folder_ / "a.h5");
    }

    TemporaryFolder folder_;
    Campaign campaign_ = synthetic::campaign();
};

TEST_F(Sessions, AttemptsThatWereLostAreCounted) {
    for (int losses = 1; losses < 4; ++losses) {
        lose(5);
        EXPECT_EQ(attempts_made(open(), 5), losses);
        EXPECT_EQ(open().tally().found().retried, 1);
    }
}

TEST_F(Sessions, CleanEndsAndErrorsOfTheMachineBlameNoMember) {
    for (int session = 0; session < 3; ++session) {
        {
            Recorder stopped = open();
            stopped.started(5, 1);
            stopped.finish("stopped");
        }
        Recorder in_trouble = open();
        EXPECT_EQ(attempts_made(in_trouble, 5), 0);
        in_trouble.started(5, 1);
        in_trouble.give_up();
    }
    EXPECT_EQ(attempts_made(open(), 5), 0);
}

TEST_F(Sessions, FailedMemberIsTriedAgainWhileItHasAttemptsLeft) {
    MemberRecord failure = synthetic::failed_record(campaign_, 4);
    failure.attempt = 1;
    open().keep(failure);
    {
        Recorder recorder = open();
        EXPECT_EQ(attempts_made(recorder, 4), 1);
        EXPECT_EQ(recorder.tally().failed(), 0);
        failure.attempt = 2;
        failure.result.reason = "again";
        recorder.keep(failure);
        EXPECT_EQ(recorder.tally().failed(), 1);
    }
    EXPECT_EQ(attempts_made(open(), 4), -1);
    EXPECT_EQ(open().tally().found().reused(), 1);
    EXPECT_EQ(published().members[4].reason, "again");
}

TEST_F(Sessions, RetryFailedForgetsFailuresAndNotLosses) {
    MemberRecord failure = synthetic::failed_record(campaign_, 4);
    failure.attempt = 2;
    open().keep(failure);
    EXPECT_EQ(attempts_made(open(), 4), -1);
    EXPECT_EQ(attempts_made(open(true), 4), 0);
    lose(4, true);
    EXPECT_EQ(attempts_made(open(true), 4), 1);
}

TEST_F(Sessions, SayWhatTheyDid) {
    for (const int number : {0, 1, 2}) open().keep(synthetic::record(campaign_, number));
    MemberRecord failure = synthetic::failed_record(campaign_, 4);
    failure.attempt = 1;
    open().keep(failure);
    {
        Recorder recorder = open();
        recorder.keep(synthetic::record(campaign_, 4));
        recorder.keep(synthetic::record(campaign_, 5));
        EXPECT_EQ(recorder.tally().found().reused(), 3);
        EXPECT_EQ(recorder.tally().found().retried, 1);
        EXPECT_EQ(recorder.tally().computed(), 2);
    }
    const Session session = read_journal(folder_ / "a.journal").sessions.back();
    EXPECT_EQ(session.reused, 3);
    EXPECT_EQ(session.retried, 1);
    EXPECT_EQ(session.computed, 2);
    EXPECT_EQ(session.set_aside, 0);
}

}  // namespace recorder_test
}  // namespace floes
