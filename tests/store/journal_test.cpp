#include "store/journal.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/small_journal.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace journal_test {

using testing::HasSubstr;

TEST(Journal, StandsBesideTheCampaignFile) {
    EXPECT_EQ(journal_path("folder/a.h5"), "folder/a.journal");
    EXPECT_EQ(journal_path("a.b.h5"), "a.b.journal");
    EXPECT_EQ(journal_path("plain"), "plain.journal");
}

TEST(Journal, GivesBackWhatWasAppended) {
    const TemporaryFolder folder;
    const auto path = folder / "a.journal";
    const Campaign campaign = synthetic::campaign();
    const auto records = synthetic::records(campaign);
    {
        Journal journal = open_journal(path, campaign, Existing::resume);
        for (const MemberRecord& record : records) journal.append(record);
        journal.sync();
        EXPECT_EQ(journal.members().notes().size(), records.size());
    }
    const JournalContents contents = read_journal(path);
    EXPECT_EQ(contents.campaign_text, write_campaign(campaign));
    EXPECT_EQ(contents.torn_bytes, 0u);
    EXPECT_EQ(contents.good_bytes, std::filesystem::file_size(path));
    const std::vector<MemberRecord> whole = whole_records(contents, path);
    ASSERT_EQ(whole.size(), records.size());
    for (std::size_t k = 0; k < records.size(); ++k) EXPECT_EQ(encode(whole[k]), encode(records[k]));
}

TEST(Journal, TellsOfSessions) {
    const TemporaryFolder folder;
    const auto path = folder / "a.journal";
    Session killed = synthetic::session(0);
    Session finished = synthetic::session(1);
    {
        Journal journal = open_journal(path, "", Existing::refuse);
        journal.begin_session(killed);
    }
    Journal journal = open_journal(path, "", Existing::resume);
    journal.begin_session(finished);
    journal.append(small_record(0));
    journal.end_session("complete");
    finished.ended = journal.contents().sessions[1].ended;
    finished.outcome = "complete";
    finished.computed = 1;
    EXPECT_EQ(finished.ended.size(), std::string("2026-01-01T10:00:00Z").size());
    EXPECT_THAT(journal.contents().sessions, testing::ElementsAre(killed, finished));
    EXPECT_THAT(read_journal(path).sessions, testing::ElementsAre(killed, finished));
}

TEST(Journal, KnowsTheAttemptsThatNeverEnded) {
    const TemporaryFolder folder;
    const auto path = folder / "a.journal";
    const MemberIdentity ended{"case", 0};
    const MemberIdentity lost{"case", 1};
    for (int session = 0; session < 2; ++session) {
        Journal journal = open_journal(path, "", Existing::resume);
        EXPECT_EQ(journal.contents().attempts.lost(lost), session);
        journal.begin_session(synthetic::session(session));
        journal.started(ended, 1);
        journal.started(lost, session + 1);
        EXPECT_EQ(journal.contents().attempts.lost(lost), session) << "it is running";
        journal.append(small_record(0));
    }  // killed
    {
        Journal journal = open_journal(path, "", Existing::resume);
        EXPECT_EQ(journal.contents().attempts.lost(ended), 0);
        EXPECT_EQ(journal.contents().attempts.lost(lost), 2);
        journal.begin_session(synthetic::session(2));
        journal.started({"case", 2}, 1);
        journal.started(lost, 3);
        journal.end_session("stopped");
    }
    EXPECT_EQ(read_journal(path).attempts.lost(lost), 2) << "a clean end blames nobody";
    EXPECT_EQ(read_journal(path).attempts.lost({"case", 2}), 0);
    open_journal(path, "", Existing::resume).append(small_record(1));
    EXPECT_EQ(read_journal(path).attempts.lost(lost), 0) << "a result begins the account anew";
}

TEST(Journal, PassesOverRecordsOfAnUnknownType) {
    const SmallJournal small;
    Bytes bytes = file_bytes(small.path);
    const Bytes unknown = journal_format::record(static_cast<journal_format::RecordType>(99), bytes);
    bytes.insert(bytes.end(), unknown.begin(), unknown.end());
    write_file_bytes(small.path, bytes);
    EXPECT_EQ(read_journal(small.path).torn_bytes, 0u);
    expect_small_records(open_journal(small.path, "", Existing::resume), 3);
}

TEST(Journal, ChecksumIsCrc32c) {
    const std::string digits = "123456789";
    EXPECT_EQ(journal_format::crc32c(std::as_bytes(std::span(digits))), 0xE3069283u);
}

TEST(Journal, RefusesANewerSchemaInASentence) {
    const SmallJournal small;
    Bytes bytes = file_bytes(small.path);
    bytes[8] = std::byte{journal_format::schema + 1};
    ByteWriter crc;
    crc.u32(journal_format::crc32c(std::span(bytes).first(20)));
    std::copy(crc.bytes().begin(), crc.bytes().end(), bytes.begin() + 20);
    write_file_bytes(small.path, bytes);
    EXPECT_THAT(refusal([&] { read_journal(small.path); }),
                HasSubstr(fmt::format("schema {}", journal_format::schema + 1)));
}

TEST(Journal, RefusesAFileThatIsNoJournal) {
    const TemporaryFolder folder;
    const auto path = folder / "letter.journal";
    for (const std::string text : {"Dear", "Dear reader, this is a letter."}) {
        write_file_bytes(path, std::as_bytes(std::span(text)));
        EXPECT_THAT(refusal([&] { read_journal(path); }), HasSubstr("is not a journal of floes"));
        EXPECT_THROW(open_journal(path, "", Existing::resume), InputError);
        EXPECT_EQ(std::filesystem::file_size(path), text.size());
    }
    EXPECT_THAT(refusal([&] { read_journal(folder / "none"); }), HasSubstr("cannot be opened"));
    EXPECT_THAT(refusal([&] { open_journal(folder / "no/folder", "", Existing::resume); }), HasSubstr("folder"));
}

TEST(Journal, NeverBeginsAnewUnlessToldTo) {
    const SmallJournal small;
    EXPECT_THAT(refusal([&] { open_journal(small.path, "", Existing::refuse); }), HasSubstr("--resume"));
    expect_small_records(small.path, 3);
    EXPECT_EQ(open_journal(small.path, "other", Existing::replace).members().notes().size(), 0u);
    EXPECT_EQ(read_journal(small.path).campaign_text, "other");
}

TEST(Journal, GrowsWithItsCampaignAndNeverShrinks) {
    const TemporaryFolder folder;
    const auto path = folder / "a.journal";
    Campaign small = synthetic::campaign(2);
    small.cases.pop_back();
    {
        Journal journal = open_journal(path, small, Existing::refuse);
        for (int number = 0; number < 4; ++number) journal.append(synthetic::record(small, number));
        EXPECT_TRUE(journal.extension().empty());
    }
    Campaign large = synthetic::campaign(3);
    std::swap(large.cases[0], large.cases[2]);
    {
        const Journal journal = open_journal(path, large, Existing::resume);
        EXPECT_THAT(journal.extension(), testing::ElementsAre("campaign.arrangements: 2 there, 3 here",
                                                              "cases: soft, stiff there, open, stiff, soft here"));
        // The members have other numbers now, and are found all the same.
        const auto known = match_records(large, journal.members().notes());
        for (const int number : {1, 2, 4, 5}) EXPECT_TRUE(known[static_cast<std::size_t>(number)]) << number;
        EXPECT_EQ(std::count(known.begin(), known.end(), std::nullopt), 5);
    }
    EXPECT_TRUE(open_journal(path, large, Existing::resume).extension().empty())
        << "the journal is of the large one now";
    EXPECT_EQ(fingerprint(read_stored_campaign(read_journal(path), path)), fingerprint(large));
    const std::uint64_t size = std::filesystem::file_size(path);
    const std::string message = refusal([&] { open_journal(path, small, Existing::resume); });
    EXPECT_THAT(message, HasSubstr("campaign.arrangements: 3 there, 2 here"));
    EXPECT_THAT(message, HasSubstr("may grow but not shrink"));
    large.cases[1].scenario.general.iterations = 20;
    large.arrangements = 9;
    EXPECT_THAT(refusal([&] { open_journal(path, large, Existing::resume); }),
                testing::AllOf(HasSubstr("another campaign"), HasSubstr("case stiff: general.iterations")));
    EXPECT_EQ(std::filesystem::file_size(path), size);
}

TEST(Journal, OfAnotherCampaignIsRefusedWithTheDifferenceNamed) {
    const TemporaryFolder folder;
    const auto path = folder / "a.journal";
    Campaign campaign = synthetic::campaign();
    open_journal(path, campaign, Existing::refuse).append(synthetic::record(campaign, 0));
    Campaign other = campaign;
    for (Case& one : other.cases) one.scenario.general.iterations = 20;
    const std::string message = refusal([&] { open_journal(path, other, Existing::resume); });
    EXPECT_THAT(message, HasSubstr("another campaign"));
    EXPECT_THAT(message, HasSubstr("iterations"));
    EXPECT_THAT(message, HasSubstr("20"));
    EXPECT_EQ(open_journal(path, campaign, Existing::resume).members().notes().size(), 1u);
    campaign.name = "renamed";
    EXPECT_EQ(open_journal(path, campaign, Existing::resume).members().notes().size(), 1u);
}

}  // namespace journal_test
}  // namespace floes
