// Parts of a campaign read as one, and merged, in steps too; what is told apart and what is missing.

#include "run/parts.hpp"

#include <gmock/gmock.h>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "run/campaign_status.hpp"
#include "run/fakes.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace parts_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PartsOfACampaign : public testing::Test {
  protected:
    fs::path file(int part) const { return folder_ / ("a.part" + std::to_string(part) + ".h5"); }

    /// Runs part K of 4 into a file of its own.
    fs::path run(int part, const Campaign& campaign = synthetic::campaign(8)) {
        fake::Run one(file(part), campaign);
        one.part = {part, 4};
        EXPECT_EQ(one(fake::compute_by_identity), 0) << one.said;
        return file(part);
    }

    /// A journal with these members of part K of 4, whose session did not end.
    fs::path killed(int part, const std::vector<int>& members, Session session = synthetic::session(),
                    const Campaign& campaign = synthetic::campaign(8)) {
        session.part = part;
        session.parts = 4;
        Journal journal = open_journal(journal_path(file(part)), campaign, Existing::replace);
        journal.begin_session(session);
        for (const int number : members) journal.append(synthetic::record(campaign, number));
        return file(part);
    }

    std::vector<std::string> remarks(const std::vector<fs::path>& files) const { return Parts(files).remarks(); }

    /// The table of the merged file as text.
    static std::string told(const fs::path& path) {
        std::string text;
        for (const MemberRow& row : read_campaign_file(CampaignFile(path)).members)
            text += fmt::format("{} {} {}\n", row.arrangement, static_cast<int>(row.status), row.load.mean);
        return text;
    }

    TemporaryFolder folder_;
};

TEST_F(PartsOfACampaign, AreMergedInStepsIntoTheFileOfOneRun) {
    fake::Run whole(folder_ / "whole.h5", synthetic::campaign(8));
    EXPECT_EQ(whole(fake::compute_by_identity), 0);
    const fs::path output = folder_ / "a.h5";
    std::vector<fs::path> parts{run(2), run(3)};
    Parts read = merge_campaigns(parts, output, false);
    EXPECT_EQ(read.missing_parts(), "Of 4 parts there is no file of parts 1, 4.");
    EXPECT_EQ(read.missing_members(), "12 members are missing: all of arrangements 0, 3-4, 7.");
    parts = {run(1)};  // the others need not be there any more
    fs::remove(journal_path(file(2)));
    EXPECT_EQ(merge_campaigns(parts, output, false).missing_parts(), "Of 4 parts there is no file of part 4.");
    parts = {file(1), file(3), run(4)};
    read = merge_campaigns(parts, output, false);
    EXPECT_EQ(read.missing_parts() + read.missing_members(), "");
    EXPECT_THAT(read.remarks(), IsEmpty());
    EXPECT_EQ(told(output), told(whole.file));
    const auto size = fs::file_size(journal_path(output));
    merge_campaigns(parts, output, false);
    EXPECT_EQ(fs::file_size(journal_path(output)), size) << "what is there already is not added again";
    EXPECT_EQ(read_status(output).sessions.size(), 4u);
}

TEST_F(PartsOfACampaign, ThatGrewSinceTheyWereMergedAreTakenInFull) {
    const fs::path output = folder_ / "a.h5";
    const std::vector<fs::path> parts{killed(1, {0, 1})};
    merge_campaigns(parts, output, false);
    {
        Journal journal = open_journal(journal_path(file(1)), synthetic::campaign(8), Existing::resume);
        journal.append(synthetic::record(synthetic::campaign(8), 2));
    }
    merge_campaigns(parts, output, false);
    EXPECT_EQ(fs::file_size(journal_path(output)), fs::file_size(journal_path(file(1))));
    EXPECT_EQ(read_status(output).cases[2].done, 1);
}

TEST_F(PartsOfACampaign, WithMembersInPiecesOfTheirJournalsAreMergedToo) {
    const Campaign campaign = synthetic::campaign(8);
    fake::Run whole(folder_ / "whole.h5", campaign);
    EXPECT_EQ(whole(fake::compute_by_identity), 0);
    const std::vector<fs::path> parts{run(1), killed(2, {3, 4}, describe_session(1, 4, {})), run(3), run(4)};
    {
        const fs::path path = journal_path(file(2));
        Journal journal = open_journal(path, campaign, Existing::resume);
        Journal first = open_journal(piece_path(path, 1), campaign, Existing::resume);
        for (const int number : {4, 5, 15}) first.append(synthetic::record(campaign, number));
        Journal second = open_journal(piece_path(path, 2), campaign, Existing::resume);
        for (const int number : {16, 17}) second.append(synthetic::record(campaign, number));
        for (const int number : {5, 15, 16}) journal.done_in_piece(identity(synthetic::record(campaign, number)));
        journal.end_session("complete");  // without a note of the last member
    }
    EXPECT_EQ(total_of(read_status(file(2))).done, 6);
    EXPECT_EQ(total_of(read_status(parts)).missing, 0);
    EXPECT_THAT(remarks(parts), IsEmpty());

    const fs::path output = folder_ / "a.h5";
    const std::vector<fs::path> first_two{file(1), file(2)};
    const std::vector<fs::path> last_three{file(2), file(3), file(4)};
    merge_campaigns(first_two, output, false);
    const Parts read = merge_campaigns(last_three, output, false);
    EXPECT_EQ(read.missing_parts() + read.missing_members(), "");
    EXPECT_EQ(told(output), told(whole.file));
    const JournalContents merged = read_journal(journal_path(output));
    EXPECT_EQ(merged.members.size(), 24u) << "member 4 is there twice in part 2, and once here";
    ASSERT_EQ(merged.sessions.size(), 4u);
    for (const Session& session : merged.sessions) EXPECT_EQ(session.computed, session.part == 2 ? 5 : 6);
    const auto size = fs::file_size(journal_path(output));
    merge_campaigns(parts, output, false);
    EXPECT_EQ(fs::file_size(journal_path(output)), size) << "what is there already is not added again";

    // Also when what was merged was resumed with several writers, and when nothing of what was there is kept.
    open_journal(piece_path(journal_path(output), 1), campaign, Existing::resume)
        .append(synthetic::record(campaign, 0));
    merge_campaigns(parts, output, false);
    EXPECT_THAT(pieces_of(journal_path(output)), IsEmpty());
    EXPECT_EQ(fs::file_size(journal_path(output)), size);
    open_journal(piece_path(journal_path(output), 1), campaign, Existing::resume)
        .append(synthetic::record(campaign, 6));
    merge_campaigns(first_two, output, true);
    EXPECT_EQ(total_of(read_status(output)).missing, 12);
}

TEST_F(PartsOfACampaign, AreNotMergedIntoOneThatAWriterStillWrites) {
    const std::vector<fs::path> parts{run(1)};
    const fs::path piece = piece_path(folder_ / "a.journal", 1);
    {
        const Journal orphan = open_journal(piece, synthetic::campaign(8), Existing::resume);
        EXPECT_THAT(refusal([&] { merge_campaigns(parts, folder_ / "a.h5", true); }),
                    HasSubstr("a.journal.1 is being written by a run"));
    }
    EXPECT_THAT(refusal([&] { merge_campaigns(parts, folder_ / "a.h5", false); }),
                HasSubstr("a.journal.1 exists already but not its journal"));
}

TEST_F(PartsOfACampaign, ThatAreNotCompleteAreNamed) {
    const std::vector<fs::path> parts{killed(1, {0, 1, 2, 12, 13, 14}), killed(2, {3, 4, 15})};
    EXPECT_THAT(remarks(parts),
                ElementsAre(file(2).string() + ", part 2 of 4, has 3 of its 6 members: it was killed on "
                                               "node0."));
    const CampaignStatus status = read_status(parts);
    ASSERT_TRUE(status.parts);
    EXPECT_EQ(status.parts->parts, 2);
    EXPECT_EQ(status.parts->running, 0);
    EXPECT_EQ(total_of(status).done, 9);
    EXPECT_EQ(total_of(status).missing, 15);
    EXPECT_THAT(status.remarks,
                Contains("15 members are missing: all of arrangements 2-3, 6-7; of case stiff arrangement 5; of case "
                         "open arrangements 1, 5."));
    EXPECT_THAT(work_sentence(status), HasSubstr("None of 2 parts runs"));
    const Journal running = open_journal(journal_path(file(2)), synthetic::campaign(8), Existing::resume);
    EXPECT_THAT(remarks(parts), ElementsAre(HasSubstr("it runs on node0")));
    EXPECT_THAT(work_sentence(read_status(parts)), HasSubstr("Running: 1 of 2 parts, 4 threads on 1 host"));
}

TEST_F(PartsOfACampaign, ThatWereRunTwiceAreCompared) {
    run(2);
    fs::rename(journal_path(file(2)), folder_ / "again.journal");
    fs::remove(file(2));
    const std::vector<fs::path> parts{run(2), folder_ / "again.h5"};
    EXPECT_THAT(remarks(parts), ElementsAre(HasSubstr("6 members of " + (folder_ / "again.h5").string() + " are in " +
                                                      file(2).string() + " too, with the same results")));
    {
        Journal journal = open_journal(journal_path(file(3)), synthetic::campaign(8), Existing::refuse);
        journal.begin_session(synthetic::session());
        MemberRecord other = synthetic::record(synthetic::campaign(8), 4);
        other.result.load_map.surge[5] += 1e-12;
        journal.append(other);
    }
    const std::vector<fs::path> differing{file(2), file(3)};
    EXPECT_THAT(remarks(differing), Contains(HasSubstr("and 1 of them differ (members 4)")));
}

TEST_F(PartsOfACampaign, OfAnotherBuildAreNamed) {
    Session other = synthetic::session();
    other.software[1].version = "3.25";
    const std::vector<fs::path> parts{killed(1, {0, 1, 2, 12, 13, 14}), killed(2, {3, 4, 5, 15, 16, 17}, other)};
    EXPECT_THAT(remarks(parts), ElementsAre(HasSubstr("another build, so single members may differ in the last bits: "
                                                      "bullet: 3.24 in " +
                                                      file(1).string() + ", 3.25 in " + file(2).string())));
}

TEST_F(PartsOfACampaign, OfAClockThatIsOffAreNamed) {
    const fs::path late = killed(2, {3, 4, 5, 15, 16, 17});
    for (const double ahead : {3600.0, -3600.0}) {
        Session session = synthetic::session();
        session.clock_ahead = ahead;
        const std::vector<fs::path> parts{killed(1, {0, 1, 2, 12, 13, 14}, session), late};
        EXPECT_THAT(
            remarks(parts),
            ElementsAre(HasSubstr(fmt::format("{} was run on a clock that is off: that of node0 was 60 min {} that "
                                              "of the file system",
                                              file(1).string(), ahead > 0 ? "ahead of" : "behind"))));
    }
}

TEST_F(PartsOfACampaign, OfASmallerCampaignAreNamedAndOfAnotherRefused) {
    const std::vector<fs::path> grown{run(1), run(2, synthetic::campaign(4))};
    EXPECT_EQ(Parts(grown).campaign().arrangements, 8);
    EXPECT_THAT(remarks(grown),
                Contains(HasSubstr("was run for a smaller campaign: campaign.arrangements: 4 there, 8")));
    Campaign other = synthetic::campaign(8);
    other.seed = 8;
    const std::vector<fs::path> mixed{file(1), run(3, other)};
    EXPECT_THAT(refusal([&] { remarks(mixed); }), HasSubstr("belongs to a different campaign than"));
    EXPECT_THAT(refusal([&] { merge_campaigns(mixed, folder_ / "a.h5", false); }),
                HasSubstr("campaign.seed: 7 there, 8"));
}

TEST_F(PartsOfACampaign, AreMergedIntoAFileWithoutJournal) {
    const auto results = [](const fs::path& file) {
        std::vector<double> means;
        for (const MemberRow& row : read_campaign_file(file).members) means.push_back(row.done() ? row.load.mean : -1);
        return means;
    };
    const std::vector<fs::path> first{run(1)};
    merge_campaigns(first, folder_ / "a.h5", false);
    fs::remove(folder_ / "a.journal");
    const std::vector<fs::path> second{run(2)};
    merge_campaigns(second, folder_ / "a.h5", false);
    const std::vector<fs::path> both{file(1), file(2)};
    merge_campaigns(both, folder_ / "both.h5", false);
    EXPECT_EQ(results(folder_ / "a.h5"), results(folder_ / "both.h5"));
    // What a run that was stopped left of a journal that it made from the file.
    open_journal(folder_ / "a.journal", synthetic::campaign(8), Existing::replace)
        .append(synthetic::record(synthetic::campaign(8), 0));
    merge_campaigns(second, folder_ / "a.h5", false);
    EXPECT_EQ(results(folder_ / "a.h5"), results(folder_ / "both.h5")) << "only the file had them";
    write_file_bytes(folder_ / "no.h5", Bytes(100));
    const std::vector<fs::path> none{folder_ / "no.h5"};
    EXPECT_THAT(refusal([&] { merge_campaigns(none, folder_ / "a.h5", true); }), HasSubstr("is not an HDF5 file"));
    EXPECT_TRUE(fs::exists(folder_ / "a.journal")) << "nothing came in its place";
    fs::remove(journal_path(file(1)));
    EXPECT_THAT(refusal([&] { merge_campaigns(both, folder_ / "a.h5", false); }),
                HasSubstr("the two files stay together"));
    merge_campaigns(first, folder_ / "alone.h5", false);
    EXPECT_EQ(results(folder_ / "alone.h5"), results(file(1)));
}

/// As in precision_test: of all members of arrangements 0 to 26 it is known that they are enough.
Campaign precise_campaign() {
    Campaign made = synthetic::campaign(60);
    made.stop.half_width = 0.25;
    made.stop.minimum = 10;
    made.stop.look_ahead = 2;
    made.stop.batch = 4;
    return made;
}

std::vector<int> members_of_part(int part, int arrangements) {
    std::vector<int> members;
    for (int arrangement = part - 1; arrangement < arrangements; arrangement += 4)
        for (int k = 0; k < 3; ++k) members.push_back(3 * arrangement + k);
    return members;
}

TEST_F(PartsOfACampaign, EndWhenAllTogetherArePreciseEnough) {
    const Campaign campaign = precise_campaign();
    const std::vector<fs::path> parts{file(1), file(2), file(3), file(4)};
    for (const int part : {1, 2, 4}) killed(part, members_of_part(part, 40), synthetic::session(), campaign);
    killed(3, members_of_part(3, 22), synthetic::session(), campaign);
    EXPECT_FALSE(Parts(parts).rule()->met());
    killed(3, members_of_part(3, 27), synthetic::session(), campaign);
    EXPECT_TRUE(Parts(parts).rule()->met());

    fake::Run third(file(3), campaign);
    third.part = {3, 4};
    EXPECT_EQ(third(fake::wait_for_stop, Existing::resume), 0) << third.said;
    EXPECT_THAT(third.said,
                HasSubstr("precise enough: all parts together have the half-width 23.5 %, target 25 %, after "
                          "27 of at most 60 arrangements"));
    const Parts merged = merge_campaigns(parts, folder_ / "a.h5", false);
    EXPECT_EQ(merged.missing_members(), "");
    fake::Run whole(folder_ / "whole.h5", campaign);
    EXPECT_EQ(whole(fake::compute), 0) << whole.said;
    EXPECT_EQ(told(folder_ / "a.h5"), told(whole.file));
    const CampaignStatus status = read_status(parts);
    EXPECT_THAT(stop_sentence(*status.stop), HasSubstr("Precise enough after 27 arrangements of at most 60"));
    EXPECT_EQ(total_of(status).missing, 0);
}

TEST_F(PartsOfACampaign, FindTheOthersByTheirNames) {
    for (const int part : {1, 2, 4}) killed(part, {});
    EXPECT_THAT(other_parts(file(2), {2, 4}), ElementsAre(file(1), file(4)));
    EXPECT_THAT(other_parts(folder_ / "b.h5", {2, 4}), IsEmpty());
}

}  // namespace parts_test
}  // namespace floes
