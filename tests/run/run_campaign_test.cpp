#include "run/run_campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "run/fakes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace run_campaign_test {

using testing::HasSubstr;

/// Asks the process to stop while member `number` runs.
MemberFunction stopping_at(int number) {
    return [number](const Campaign& campaign, int current, std::stop_token stop) {
        if (current != number) return fake::compute(campaign, current, std::move(stop));
        std::raise(SIGTERM);
        return fake::wait_for_stop(campaign, current, std::move(stop));
    };
}

int finished(const fake::Run& run) {
    const auto results = run.results();
    return static_cast<int>(std::ranges::count_if(results, [](const Bytes& bytes) { return !bytes.empty(); }));
}

TEST(RunCampaign, ComputesEveryMemberOnceAndPublishes) {
    fake::RunAside run;
    std::atomic<int> calls = 0;
    const MemberFunction counted = [&](const Campaign& campaign, int number, std::stop_token stop) {
        ++calls;
        return fake::compute(campaign, number, std::move(stop));
    };
    EXPECT_EQ(run(counted), 0);
    EXPECT_EQ(calls, 12);
    EXPECT_THAT(run.said, HasSubstr("12 members = 3 cases x 4 arrangements on 2 cores, into "));
    EXPECT_THAT(run.said, HasSubstr("12 of 12 done, 0 failed"));
    const CampaignTable table = read_campaign_file(run.file);
    ASSERT_EQ(table.members.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(table.members[i].load.mean, synthetic::record(run.campaign, static_cast<int>(i)).result.load.mean);
    }
}

TEST(RunCampaign, GivesTheSameWhateverTheThreadsAndTheOrder) {
    const TemporaryFolder folder;
    fake::Run one(folder / "one.h5");
    fake::Run many(folder / "many.h5");
    EXPECT_EQ(one(fake::compute, Existing::refuse, 1), 0);
    EXPECT_EQ(many(fake::compute_out_of_order, Existing::refuse, 4), 0);
    EXPECT_EQ(one.results(), many.results());
}

TEST(RunCampaign, SetsFailedMembersAsideAndGoesOn) {
    fake::RunAside run;
    const MemberFunction broken = [](const Campaign& campaign, int number, std::stop_token stop) {
        if (number == 5) throw std::runtime_error("the ice melted");
        return fake::compute(campaign, number, std::move(stop));
    };
    EXPECT_EQ(run(broken), 1);
    EXPECT_EQ(finished(run), 12);
    EXPECT_THAT(run.said, HasSubstr("member 5 (case open, arrangement 1) failed and will be retried: the ice melted"));
    EXPECT_THAT(run.said,
                HasSubstr("member 5 (case open, arrangement 1) failed and was set aside: the ice melted (2 attempts)"));
    EXPECT_THAT(run.said, HasSubstr("1 of 12 members failed"));
    const CampaignTable table = read_campaign_file(run.file);
    EXPECT_EQ(table.members[5].status, RowStatus::failed);
    EXPECT_EQ(table.members[5].reason, "the ice melted (2 attempts)");
}

TEST(RunCampaign, StopsOnASignalPublishesAndCanBeResumed) {
    fake::RunAside run;
    fake::Run whole(run / "whole.h5");
    ASSERT_EQ(whole(fake::compute), 0);
    EXPECT_EQ(run(stopping_at(6), Existing::resume), 85);
    EXPECT_THAT(run.said, HasSubstr("stopped by SIGTERM with"));
    EXPECT_THAT(run.said, HasSubstr("to resume: RESUME COMMAND"));
    const int kept = finished(run);
    EXPECT_GE(kept, 1);
    EXPECT_LT(kept, 12);
    EXPECT_TRUE(run.results()[6].empty());
    EXPECT_EQ(read_campaign_file(run.file).members[6].status, RowStatus::missing);

    EXPECT_EQ(run(fake::compute, Existing::resume), 0);
    EXPECT_THAT(run.said, HasSubstr("reused, " + std::to_string(12 - kept) + " to compute"));
    EXPECT_THAT(run.said, HasSubstr("reused, " + std::to_string(12 - kept) + " computed, 0 retried, 0 set aside"));
    EXPECT_EQ(run.results(), whole.results());
    EXPECT_EQ(read_journal(journal_path(run.file)).sessions.size(), 2u);
}

TEST(RunCampaign, StopsWhenTheTimeIsOverOrNoMemberCouldBeDoneInIt) {
    const TemporaryFolder folder;
    fake::Run over(folder / "over.h5");
    over.walltime = Walltime(0.0);
    EXPECT_EQ(over(fake::wait_for_stop), 85);
    EXPECT_THAT(over.said, HasSubstr("stopped by the end of the time limit with 0 of 12"));

    Campaign equal_members = synthetic::campaign();
    equal_members.cases.resize(1);
    fake::Run run(folder / "a.h5", equal_members);
    // So long that a busy machine can start two of them well before the rest is too short for another.
    const MemberFunction four_seconds = [](const Campaign& campaign, int number, std::stop_token stop) {
        std::this_thread::sleep_for(std::chrono::seconds(4));
        return fake::compute(campaign, number, std::move(stop));
    };
    run.walltime = Walltime(7.8);
    EXPECT_EQ(run(four_seconds), 85);
    EXPECT_THAT(run.said, HasSubstr("before which no further member could finish, with 2 of 4"));
    run.walltime = Walltime();
    EXPECT_EQ(run(fake::compute, Existing::resume), 0);
}

TEST(RunCampaign, LosesNothingWhenItsHelperIsKilled) {
    fake::RunAside run;
    fake::Run whole(run / "whole.h5");
    ASSERT_EQ(whole(fake::compute), 0);
    run.campaign.run.isolation = Isolation::process;
    const MemberFunction kills_its_helper = [](const Campaign& campaign, int number, std::stop_token stop) {
        if (number == 6) ::kill(::getppid(), SIGKILL);
        return fake::compute(campaign, number, std::move(stop));
    };
    LocalLink link;
    {
        Helper helper(kills_its_helper);
        EXPECT_EQ(run.on(link, fake::compute, Existing::refuse, 2, &helper), 85);
    }
    EXPECT_THAT(run.said, HasSubstr("stopped by the loss of all ranks that compute"));
    Helper helper(fake::compute);
    EXPECT_EQ(run.on(link, fake::compute, Existing::resume, 2, &helper), 0);
    EXPECT_EQ(run.results(), whole.results());
}

TEST(RunCampaign, ResumingAFinishedCampaignComputesNothing) {
    fake::RunAside run;
    ASSERT_EQ(run(fake::compute), 0);
    std::filesystem::remove(run.file);  // the journal is the truth
    const MemberFunction never = [](const Campaign&, int number, std::stop_token) -> MemberResult {
        ADD_FAILURE() << "member " << number << " is computed again";
        return {};
    };
    EXPECT_EQ(run(never, Existing::resume), 0);
    EXPECT_TRUE(std::filesystem::exists(run.file));
}

/// By a case and by arrangements.
void expect_to_grow(bool keep_journal) {
    const TemporaryFolder folder;
    Campaign small = synthetic::campaign(2);
    small.cases.erase(small.cases.begin());
    fake::Run first(folder / "grown.h5", small);
    first.keep_journal = keep_journal;
    ASSERT_EQ(first(fake::compute_by_identity), 0);
    EXPECT_EQ(std::filesystem::exists(folder / "grown.journal"), keep_journal);
    fake::Run grown(folder / "grown.h5", synthetic::campaign(4));
    grown.keep_journal = keep_journal;
    std::atomic<int> calls = 0;
    const MemberFunction counted = [&](const Campaign& campaign, int number, std::stop_token stop) {
        ++calls;
        return fake::compute_by_identity(campaign, number, std::move(stop));
    };
    EXPECT_EQ(grown(counted, Existing::resume), 0);
    EXPECT_EQ(calls, 12 - 4);
    EXPECT_THAT(grown.said,
                HasSubstr("the campaign is extended, existing results are kept: campaign.arrangements: 2 there"));
    EXPECT_THAT(grown.said, HasSubstr("4 members reused, 8 computed, 0 retried, 0 set aside"));
    fake::Run whole(folder / "whole.h5");
    ASSERT_EQ(whole(fake::compute_by_identity), 0);
    const std::string compare = "h5diff --exclude-path /provenance " + grown.file.string() + " " + whole.file.string();
    EXPECT_EQ(std::system(compare.c_str()), 0);
    EXPECT_EQ(std::filesystem::exists(folder / "grown.journal"), keep_journal);
}

TEST(RunCampaign, ExtendedCampaignEqualsOneMadeAtOnce) {
    expect_to_grow(true);
}

TEST(RunCampaign, IsExtendedFromItsFileWhereTheJournalWent) {
    expect_to_grow(false);
}

TEST(RunCampaign, KeepsTheJournalOfMembersThatAreNotInTheFile) {
    const TemporaryFolder folder;
    fake::Run failing(folder / "a.h5");
    failing.keep_journal = false;
    const auto fails = [](const Campaign& campaign, int number, std::stop_token stop) {
        if (number == 4) throw MemberFailure("The ice melted.");
        return fake::compute(campaign, number, std::move(stop));
    };
    EXPECT_EQ(failing(fails), 1);
    EXPECT_TRUE(std::filesystem::exists(folder / "a.journal"));
    fake::Run part(folder / "part.h5");
    part.keep_journal = false;
    part.part = {1, 2};
    EXPECT_EQ(part(fake::compute), 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "part.journal"));
}

TEST(RunCampaign, NeverOverwritesUnasked) {
    fake::RunAside run;
    ASSERT_EQ(run(fake::compute), 0);
    const auto refused = [&] { return refusal([&] { run(fake::compute); }); };
    EXPECT_THAT(refused(), HasSubstr("a.h5 exists already: --resume continues it, --overwrite starts afresh"));
    std::filesystem::remove(run.file);
    EXPECT_THAT(refused(), HasSubstr("a.journal exists already"));
    EXPECT_EQ(run(fake::compute, Existing::replace), 0);
    EXPECT_EQ(read_journal(journal_path(run.file)).sessions.size(), 1u);
}

TEST(RunCampaign, RefusesToResumeAnotherCampaignWithItsJournalOrWithout) {
    fake::RunAside run;
    ASSERT_EQ(run(fake::compute), 0);
    for (Case& one : run.campaign.cases) one.scenario.general.iterations = 20;
    EXPECT_THAT(refusal([&] { run(fake::compute, Existing::resume); }), HasSubstr("iterations"));
    std::filesystem::remove(journal_path(run.file));
    EXPECT_THROW(run(fake::compute, Existing::resume), InputError);
    EXPECT_FALSE(std::filesystem::exists(journal_path(run.file)));
}

TEST(LeadRanks, TurnsErrorsIntoSentencesAndStatuses) {
    LocalLink link;
    std::ostringstream errors;
    EXPECT_EQ(lead_ranks(link, errors, [] { return 85; }), 85);
    EXPECT_EQ(lead_ranks(link, errors, []() -> int { throw InputError("wrong key"); }), 2);
    EXPECT_EQ(lead_ranks(link, errors, []() -> int { throw RunError("disk full"); }), 1);
    EXPECT_EQ(errors.str(), "floes: wrong key\nfloes: disk full\n");
}

}  // namespace run_campaign_test
}  // namespace floes
