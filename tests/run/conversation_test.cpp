// Master and worker, each against a script that plays the other side: which messages they send, in which order, and in
// case of errors.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "campaign/campaign.hpp"
#include "campaign/write.hpp"
#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "run/fakes.hpp"
#include "run/hands.hpp"
#include "run/messages.hpp"
#include "run/worker.hpp"
#include "support/fake_link.hpp"

namespace floes {
namespace conversation_test {

using testing::HasSubstr;
using Assignments = std::vector<Assignment>;
using Answers = std::vector<Answer>;

/// Two members: one for the master, one for the worker.
Campaign two_members() {
    Campaign campaign = synthetic::campaign(2);
    campaign.cases.resize(1);
    return campaign;
}

Bytes text_of(const Campaign& campaign) {
    return encode(write_campaign(campaign));
}

Bytes hello_of(const Campaign& campaign) {
    return encode(Hello{1, "there", fingerprint(campaign)});
}

MemberRecord record_of(const Campaign& campaign, int number) {
    MemberRecord record = synthetic::record(campaign, number);
    record.attempt = 1;
    return record;
}

/// A worker, rank 1 of 2.
class WorkerConversation : public testing::Test {
  protected:
    void TearDown() override { link_.finish(); }

    /// It gets a campaign and says hello.
    void greet(const Campaign& campaign = two_members()) {
        link_.deliver(0, Tag::campaign, text_of(campaign));
        link_.expect(0, Tag::hello);
    }

    void assign(int number) { link_.deliver(0, Tag::assign, encode(Assignments{{number, 1}})); }

    void dismiss(int status) {
        link_.deliver(0, Tag::dismiss);
        link_.expect(0, Tag::farewell);
        link_.deliver(0, Tag::leave, encode(status));
    }

    FakeLink link_{1, 2};
};
using WriterConversation = WorkerConversation;

TEST_F(WorkerConversation, SaysHelloAnswersAndLeaves) {
    const Campaign campaign = two_members();
    link_.deliver(0, Tag::campaign, text_of(campaign));
    link_.expect(0, Tag::hello, [&](const Bytes& bytes) {
        EXPECT_EQ(decode<Hello>(bytes).fingerprint, fingerprint(campaign));
        EXPECT_EQ(decode<Hello>(bytes).cores, 1);
    });
    for (const int number : {1, 0}) {
        link_.deliver(0, Tag::assign, encode(Assignments{{number, 3}}));
        link_.expect(0, Tag::answer, [&, number](const Bytes& bytes) {
            const Answer answer = decode<std::vector<Answer>>(bytes).at(0);
            EXPECT_EQ(answer.number, number);
            EXPECT_EQ(answer.record.attempt, 3);
            EXPECT_EQ(answer.record.rank, 1);
            EXPECT_EQ(answer.record.case_key, case_fingerprint(campaign, 0));
            EXPECT_EQ(answer.record.result.load.mean, record_of(campaign, number).result.load.mean);
        });
    }
    dismiss(1);
    EXPECT_EQ(serve_campaign(link_, 0, fake::compute), 1);
}

// With one thread: answers finished while another member waits are sent together, the last one alone.
TEST_F(WorkerConversation, AnswersTogetherWhileOthersWait) {
    const Campaign campaign = synthetic::campaign(2);
    greet(campaign);
    link_.deliver(0, Tag::assign, encode(Assignments{{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}}));
    std::vector<int> answered;
    std::atomic<bool> some_answered = false;
    const auto look = [&](std::size_t count) {
        return [&, count](const Bytes& bytes) {
            const auto answers = decode<std::vector<Answer>>(bytes);
            EXPECT_EQ(answers.size(), count);
            for (const Answer& answer : answers) answered.push_back(answer.number);
            some_answered = true;
        };
    };
    link_.expect(0, Tag::answer, look(5));
    link_.expect(0, Tag::answer, look(1));
    dismiss(0);
    const MemberFunction compute = [&](const Campaign& of, int number, std::stop_token stop) {
        while (number == 5 && !some_answered) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return fake::compute(of, number, std::move(stop));
    };
    EXPECT_EQ(serve_campaign(link_, 1, compute, nullptr, {.with_answers = 60}), 0);
    EXPECT_EQ(answered, (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST_F(WorkerConversation, AbandonsWhatItHoldsWhenDismissed) {
    greet();
    assign(0);
    assign(1);
    dismiss(85);
    EXPECT_EQ(serve_campaign(link_, 1, fake::wait_for_stop), 85);
}

TEST_F(WorkerConversation, LeavesWhenTheRunEndsBeforeItBegins) {
    link_.deliver(0, Tag::leave, encode(2));
    EXPECT_EQ(serve_campaign(link_, 1, fake::compute), 2);
}

TEST_F(WorkerConversation, LeavesInTheMiddleWhenTheMasterCannotGoOn) {
    greet();
    assign(0);
    link_.deliver(0, Tag::leave, encode(1));
    EXPECT_EQ(serve_campaign(link_, 1, fake::wait_for_stop), 1);
}

TEST_F(WorkerConversation, TellsTheMasterWhatItDoesNotUnderstand) {
    link_.deliver(0, Tag::campaign, encode(std::string("general.iterations = 'many'")));
    link_.expect(0, Tag::trouble,
                 [](const Bytes& bytes) { EXPECT_THAT(decode<std::string>(bytes), HasSubstr("iterations")); });
    link_.deliver(0, Tag::leave, encode(1));
    EXPECT_EQ(serve_campaign(link_, 1, fake::compute), 1);
}

TEST_F(WorkerConversation, LeavesAMasterThatIsSilentForTooLong) {
    greet();
    EXPECT_EQ(serve_campaign(link_, 1, fake::compute, nullptr, {.sign_of_life = 0.02, .with_the_master = 0.2}), 1);
    EXPECT_EQ(link_.abandoned, (std::vector<int>{0}));
}

TEST_F(WorkerConversation, DoesNotWaitForOthersWhenRanksAreMissing) {
    greet();
    link_.deliver(0, Tag::part);
    link_.deliver(0, Tag::leave, encode(0));
    EXPECT_EQ(serve_campaign(link_, 1, fake::compute), 0);
    EXPECT_EQ(link_.abandoned, (std::vector<int>{0}));
}

TEST_F(WorkerConversation, PassesASignalOn) {
    greet();
    assign(0);
    link_.expect(0, Tag::stop_request);
    dismiss(85);
    const MemberFunction interrupted = [](const Campaign& campaign, int number, std::stop_token stop) {
        std::raise(SIGUSR1);
        return fake::wait_for_stop(campaign, number, std::move(stop));
    };
    EXPECT_EQ(serve_campaign(link_, 1, interrupted), 85);
}

TEST_F(WorkerConversation, BringsItsAnswersToItsWriterAndFailuresToTheMaster) {
    const Campaign campaign = two_members();
    link_.play(3, 4);
    link_.deliver(0, Tag::post, encode(Post{2, ""}));
    greet(campaign);
    assign(0);
    link_.expect(2, Tag::answer,
                 [](const Bytes& bytes) { EXPECT_EQ(decode<std::vector<Answer>>(bytes).at(0).number, 0); });
    assign(1);
    link_.expect(0, Tag::answer, [](const Bytes& bytes) {
        const Answer answer = decode<std::vector<Answer>>(bytes).at(0);
        EXPECT_EQ(answer.number, 1);
        EXPECT_EQ(answer.record.result.status, MemberStatus::failed);
    });
    link_.deliver(0, Tag::dismiss);
    link_.expect(2, Tag::farewell);
    link_.deliver(0, Tag::part);
    link_.deliver(0, Tag::leave, encode(0));
    const MemberFunction compute = [](const Campaign& of, int number, std::stop_token stop) {
        if (number == 1) throw std::runtime_error("the ice melted");
        return fake::compute(of, number, std::move(stop));
    };
    EXPECT_EQ(serve_campaign(link_, 1, compute), 0);
    EXPECT_EQ(link_.abandoned, (std::vector<int>{0, 2}));
}

TEST_F(WriterConversation, TellsTheMasterOfWhatIsInItsJournal) {
    const TemporaryFolder folder;
    const auto piece = folder / "a.journal.1";
    const Campaign campaign = synthetic::campaign(2);
    const auto kept_so_far = [&] { return read_journal(piece).members.size(); };
    link_.play(2, 4);
    link_.deliver(0, Tag::post, encode(Post{2, piece.string()}));
    greet(campaign);
    link_.deliver(3, Tag::answer, encode(Answers{{4, record_of(campaign, 4)}, {5, record_of(campaign, 5)}}));
    link_.expect(0, Tag::kept, [&](const Bytes& bytes) {
        const auto kept = decode<std::vector<Kept>>(bytes);
        ASSERT_EQ(kept.size(), 2u);
        EXPECT_EQ(kept[1].worker, 3);
        EXPECT_EQ(kept[1].number, 5);
        EXPECT_EQ(kept[1].note.attempt, 1);
        EXPECT_FALSE(kept[1].record);
        EXPECT_EQ(kept_so_far(), 2u);
    });
    assign(1);
    link_.expect(0, Tag::kept, [&](const Bytes& bytes) {
        EXPECT_EQ(decode<std::vector<Kept>>(bytes).at(0).worker, 2);
        EXPECT_EQ(kept_so_far(), 3u);
    });
    link_.deliver(0, Tag::dismiss);
    link_.expect(0, Tag::farewell, [](const Bytes& bytes) { EXPECT_TRUE(bytes.empty()); });
    link_.deliver(3, Tag::answer, encode(Answers{{0, record_of(campaign, 0)}}));
    link_.deliver(3, Tag::farewell);
    link_.expect(0, Tag::kept);
    link_.expect(0, Tag::farewell, [](const Bytes& bytes) { EXPECT_EQ(decode<int>(bytes), 3); });
    link_.deliver(0, Tag::close);
    link_.expect(0, Tag::closed, [&](const Bytes&) { EXPECT_FALSE(is_being_written(piece)); });
    link_.deliver(0, Tag::leave, encode(0));
    EXPECT_EQ(serve_campaign(link_, 1, fake::compute), 0);
    EXPECT_EQ(kept_so_far(), 4u);
}

TEST_F(WriterConversation, TellsTheStopRuleAllButTheHistories) {
    const TemporaryFolder folder;
    Campaign campaign = synthetic::campaign(30);
    campaign.stop.half_width = 0.25;
    link_.deliver(0, Tag::post, encode(Post{1, (folder / "a.journal.1").string()}));
    greet(campaign);
    assign(4);
    link_.expect(0, Tag::kept, [&](const Bytes& bytes) {
        const Kept kept = decode<std::vector<Kept>>(bytes).at(0);
        ASSERT_TRUE(kept.record);
        const MemberResult result = kept.record->whole();
        const MemberResult computed = synthetic::record(campaign, 4).result;
        EXPECT_EQ(result.load.mean, computed.load.mean);
        ASSERT_FALSE(computed.averaged.empty());
        EXPECT_EQ(result.averaged[0].peaks, computed.averaged[0].peaks);
        EXPECT_FALSE(computed.history.surge.empty());
        EXPECT_TRUE(result.history.surge.empty());
    });
    link_.deliver(0, Tag::leave, encode(0));
    EXPECT_EQ(serve_campaign(link_, 1, fake::compute), 0);
}

TEST_F(WriterConversation, ComplainsWhenItsJournalCannotBeOpened) {
    link_.deliver(0, Tag::post, encode(Post{1, "no/such/a.journal.1"}));
    link_.deliver(0, Tag::campaign, text_of(two_members()));
    link_.expect(0, Tag::trouble,
                 [](const Bytes& bytes) { EXPECT_THAT(decode<std::string>(bytes), HasSubstr("--writers 1")); });
    link_.deliver(0, Tag::leave, encode(1));
    EXPECT_EQ(serve_campaign(link_, 1, fake::compute), 1);
}

/// The master of two members and of one worker, rank 1.
class MasterConversation : public testing::Test {
  protected:
    void TearDown() override { link_.finish(); }

    /// The worker gets the campaign, says hello and gets a member.
    void greet() {
        link_.expect(1, Tag::campaign);
        link_.deliver(1, Tag::hello, hello_of(run_.campaign));
        link_.expect(1, Tag::assign);
    }

    Bytes answer() const { return encode(Answers{{1, record_of(run_.campaign, 1)}}); }

    void dismiss() {
        link_.expect(1, Tag::dismiss);
        link_.deliver(1, Tag::farewell);
    }

    int lead() { return run_.on(link_, fake::compute, Existing::refuse, 1); }

    /// The results are those of a run alone.
    void expect_the_results() {
        fake::Run alone(folder_ / "alone.h5", two_members());
        ASSERT_EQ(alone(fake::compute), 0);
        EXPECT_EQ(run_.results(), alone.results());
    }

    TemporaryFolder folder_;
    fake::Run run_{folder_ / "a.h5", two_members()};
    FakeLink link_{0, 2};
};

/// A master with one other writer, which has kept member 1 and closed its journal.
class MasterOfAWriter : public MasterConversation {
  protected:
    MasterOfAWriter() {
        run_.writers = 2;
        link_.expect(1, Tag::post, [this](const Bytes& bytes) {
            EXPECT_EQ(decode<Post>(bytes).writer, 1);
            EXPECT_EQ(decode<Post>(bytes).journal, piece_.string());
            open_journal(piece_, "", Existing::refuse);
        });
        link_.expect(1, Tag::campaign);
        link_.deliver(1, Tag::hello, hello_of(run_.campaign));
        link_.expect(1, Tag::assign, [this](const Bytes&) {
            Journal piece = open_journal(piece_, "", Existing::resume);
            piece.append(record_of(run_.campaign, 1));
            piece.sync();
            kept_.worker = kept_.number = 1;
            kept_.note = piece.contents().members[0];
            kept_.place = piece.contents().places[0];
        });
        link_.deliver_made(1, Tag::kept, [this] {
            Kept of_another_attempt = kept_;
            of_another_attempt.note.attempt = 7;
            return encode(std::vector{of_another_attempt});
        });
        link_.deliver_made(1, Tag::kept, [this] { return encode(std::vector{kept_}); });
        dismiss();
        link_.expect(1, Tag::close);
        link_.deliver(1, Tag::closed);
    }

    /// The campaign file has the members of a run alone.
    void expect_the_file() {
        EXPECT_EQ(read_journal(journal_path(run_.file)).sessions.at(0).computed, 2);
        expect_the_results();
        for (const RowStatus state : read_states(run_.file)) EXPECT_EQ(state, RowStatus::done);
    }

    std::filesystem::path piece_ = folder_ / "a.journal.1";
    Kept kept_;
    PieceOrder order_;
};

TEST_F(MasterOfAWriter, BelievesItAndLetsItPublishItsPiece) {
    link_.expect(1, Tag::publish, [&](const Bytes& bytes) {
        order_ = decode<PieceOrder>(bytes);
        EXPECT_EQ(order_.first, 1);
        EXPECT_EQ(order_.members.size(), 1u);
        EXPECT_EQ(order_.members[0].place.piece, 1);
    });
    link_.deliver_made(1, Tag::published, [&] {
        const auto own = folder_ / "a.pieces/1-1.h5";  // of the master's thread: HDF5 is used by one at a time
        while (!std::filesystem::exists(own)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return encode(make_piece(run_.campaign, order_));
    });
    link_.expect(1, Tag::digest, [](const Bytes& bytes) {
        EXPECT_EQ(decode<DigestOrder>(bytes).pieces.size(), 2u);
        EXPECT_FALSE(decode<DigestOrder>(bytes).datasets.empty());
    });
    link_.deliver(1, Tag::digested, encode(DigestsMade{}));  // what it leaves the master computes
    EXPECT_EQ(lead(), 0);
    expect_the_file();
    EXPECT_TRUE(std::filesystem::exists(folder_ / "a.pieces/1-2.h5"));
}

TEST_F(MasterOfAWriter, PublishesAloneWhenItIsLostMeanwhile) {
    run_.patience = {.sign_of_life = 0.02, .with_a_worker = 2.5};
    link_.expect(1, Tag::publish);  // and never a word again
    link_.expect(1, Tag::part);
    EXPECT_EQ(lead(), 0);
    expect_the_file();
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.pieces"));
}

TEST_F(MasterOfAWriter, PassesOnWhyItCannotWriteItsPiece) {
    link_.expect(1, Tag::publish);
    PieceMade made;
    made.trouble = "a.pieces/1-2.h5 cannot be written: the disk is full.";
    link_.deliver(1, Tag::published, encode(made));
    EXPECT_THROW(lead(), RunError);
    EXPECT_FALSE(std::filesystem::exists(run_.file));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.pieces/1-1.h5")) << "the journal needs the room";
    EXPECT_EQ(run_(fake::compute, Existing::resume), 0);
    expect_the_file();
}

TEST_F(MasterConversation, DoesNotCallCompleteWhatIsInNoJournal) {
    run_.writers = 2;
    link_.expect(1, Tag::post,
                 [&](const Bytes& bytes) { open_journal(decode<Post>(bytes).journal, "", Existing::refuse); });
    greet();
    Kept kept;
    kept.worker = kept.number = 1;
    kept.place = {.offset = 1000, .size = 1000};
    link_.deliver(1, Tag::kept, encode(std::vector{kept}));  // and then lost it
    dismiss();
    link_.expect(1, Tag::close);
    link_.deliver(1, Tag::closed);
    EXPECT_EQ(lead(), 85);
    EXPECT_THAT(run_.said, HasSubstr("1 member of this run is in no journal"));
    EXPECT_EQ(run_(fake::compute, Existing::resume), 0);
    EXPECT_FALSE(run_.results()[1].empty());
}

TEST_F(MasterConversation, SharesTheMembersAndKeepsTheAnswers) {
    link_.expect(1, Tag::campaign, [&](const Bytes& bytes) { EXPECT_EQ(bytes, text_of(run_.campaign)); });
    link_.deliver(1, Tag::hello, hello_of(run_.campaign));
    link_.expect(1, Tag::assign,
                 [](const Bytes& bytes) { EXPECT_EQ(decode<std::vector<Assignment>>(bytes).at(0).number, 1); });
    link_.deliver(1, Tag::answer, answer());
    dismiss();
    EXPECT_EQ(lead(), 0);
    expect_the_results();
}

TEST_F(MasterConversation, KeepsNoLateAnswer) {
    greet();
    MemberRecord late = record_of(run_.campaign, 1);
    late.attempt = 7;
    link_.deliver(1, Tag::answer, encode(Answers{{1, late}}));
    link_.deliver(1, Tag::answer, answer());
    link_.deliver(1, Tag::answer, answer());
    dismiss();
    EXPECT_EQ(lead(), 0);
    EXPECT_EQ(read_journal(journal_path(run_.file)).members.size(), 2u);
}

TEST_F(MasterConversation, DoesAgainWhatALeavingWorkerHeld) {
    greet();
    link_.deliver(1, Tag::farewell);
    EXPECT_EQ(lead(), 0);
    const auto members = read_journal(journal_path(run_.file)).members;
    ASSERT_EQ(members.size(), 2u);
    EXPECT_EQ(members[1].attempt, 2);
}

TEST_F(MasterConversation, GivesTheMembersOfASilentWorkerToOthersAndLeavesWithoutIt) {
    run_.patience = {.sign_of_life = 0.02, .with_a_worker = 0.2};
    greet();  // and never a word again
    link_.expect(1, Tag::part);
    EXPECT_EQ(lead(), 0);
    EXPECT_EQ(link_.abandoned, (std::vector<int>{1}));
    EXPECT_THAT(run_.said, HasSubstr("rank 1 has been silent"));
    EXPECT_EQ(read_journal(journal_path(run_.file)).members[1].attempt, 2);
}

TEST_F(MasterConversation, StopsEverybodyWhenAWorkerGetsASignal) {
    greet();
    link_.deliver(1, Tag::stop_request);
    link_.expect(1, Tag::dismiss);
    link_.deliver(1, Tag::answer, answer());
    link_.deliver(1, Tag::farewell);
    EXPECT_EQ(run_.on(link_, fake::wait_for_stop, Existing::refuse, 1), 85);
    EXPECT_THAT(run_.said, HasSubstr("stopped by a signal to rank 1 with 1 of 2 members"));
    EXPECT_FALSE(run_.results()[1].empty());
}

TEST_F(MasterConversation, WaitsForSlowRanksWhileOthersShowThatTheyAreAlive) {
    link_.play(0, 3);
    for (const int rank : {1, 2}) link_.expect(rank, Tag::campaign);
    link_.deliver(1, Tag::hello, hello_of(run_.campaign));
    link_.deliver(1, Tag::alive);
    link_.deliver(2, Tag::hello, hello_of(run_.campaign));
    link_.expect(1, Tag::assign);
    link_.deliver(1, Tag::answer, answer());
    for (const int rank : {1, 2}) link_.expect(rank, Tag::dismiss);
    for (const int rank : {1, 2}) link_.deliver(rank, Tag::farewell);
    EXPECT_EQ(lead(), 0);
}

TEST_F(MasterConversation, EndsTheRunWhenRanksDisagreeOrAreInTrouble) {
    const auto error = [&] {
        try {
            run_.on(link_, fake::wait_for_stop, Existing::replace, 1);
        } catch (const RunError& thrown) {
            return std::string(thrown.what());
        }
        return std::string("no error");
    };
    link_.expect(1, Tag::campaign);
    link_.deliver(1, Tag::hello, encode(Hello{1, "there", "another"}));
    EXPECT_THAT(error(), HasSubstr("Rank 1 on there read a different campaign"));
    link_.finish();

    greet();
    link_.deliver(1, Tag::trouble, encode(std::string("out of memory")));
    EXPECT_EQ(error(), "Rank 1: out of memory");
}

TEST_F(MasterConversation, LetsEveryRankLeaveWithTheSameStatus) {
    link_.play(0, 3);
    for (const int rank : {1, 2}) {
        link_.expect(rank, Tag::leave, [](const Bytes& bytes) { EXPECT_EQ(decode<int>(bytes), 2); });
    }
    std::ostringstream errors;
    EXPECT_EQ(lead_ranks(link_, errors, []() -> int { throw InputError("no such file"); }), 2);
}

}  // namespace conversation_test
}  // namespace floes
