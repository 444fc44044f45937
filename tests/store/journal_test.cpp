#include "store/journal.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>

#include "core/error.hpp"
#include "store/file_bytes.hpp"
#include "store/journal_format.hpp"
#include "store/synthetic.hpp"
#include "store/temporary_folder.hpp"
#include "store/whole_records.hpp"

namespace floes {
namespace {

using testing::HasSubstr;

// Runs the action and gives the message of the InputError that it must throw.
template <class Action>
std::string refusal(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "not refused";
    return {};
}

// A record of a few hundred bytes, so that every byte can be damaged in turn.
MemberRecord small_record(int number) {
    MemberRecord record;
    record.case_key = "case";
    record.arrangement = number;
    record.host = "node";
    record.result.load.mean = 0.1 * number;
    record.result.history.surge = {1.0 * number, 2.0, 3.0};
    record.result.breaks = {{0.02, number, 1, FailureMode::shear}};
    return record;
}

struct SmallJournal {
    TemporaryFolder folder;
    std::filesystem::path path = folder / "small.journal";
    std::vector<std::uint64_t> ends;  // of the header, and of each record

    SmallJournal() {
        Journal journal = open_journal(path, "name = \"small\"\n", Existing::refuse);
        ends.push_back(std::filesystem::file_size(path));
        for (int k = 0; k < 3; ++k) {
            journal.append(small_record(k));
            ends.push_back(std::filesystem::file_size(path));
        }
    }

    // Whole records in the first `size` bytes.
    std::size_t whole_records(std::uint64_t size) const {
        std::size_t count = 0;
        while (count + 1 < ends.size() && ends[count + 1] <= size) ++count;
        return count;
    }
};

void expect_small_records(const std::vector<MemberRecord>& records, std::size_t count) {
    ASSERT_EQ(records.size(), count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(encode(records[k]), encode(small_record(static_cast<int>(k))));
}

void expect_small_records(const Journal& journal, std::size_t count) {
    expect_small_records(whole_records(journal), count);
}

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
        EXPECT_EQ(journal.records().size(), records.size());
    }
    const JournalContents contents = read_journal(path);
    EXPECT_EQ(contents.campaign_text, write_campaign(campaign));
    EXPECT_EQ(contents.torn_bytes, 0u);
    EXPECT_EQ(contents.good_bytes, std::filesystem::file_size(path));
    ASSERT_EQ(contents.members.size(), records.size());
    for (std::size_t k = 0; k < records.size(); ++k) EXPECT_EQ(encode(contents.members[k]), encode(records[k]));
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
    finished.ended = journal.sessions()[1].ended;
    finished.outcome = "complete";
    finished.computed = 1;
    EXPECT_EQ(finished.ended.size(), std::string("2026-01-01T10:00:00Z").size());
    EXPECT_THAT(journal.sessions(), testing::ElementsAre(killed, finished));
    EXPECT_THAT(read_journal(path).sessions, testing::ElementsAre(killed, finished));
}

TEST(Journal, KnowsTheAttemptsThatNeverEnded) {
    const TemporaryFolder folder;
    const auto path = folder / "a.journal";
    const MemberIdentity ended{"case", 0};
    const MemberIdentity lost{"case", 1};
    for (int session = 0; session < 2; ++session) {
        Journal journal = open_journal(path, "", Existing::resume);
        EXPECT_EQ(journal.attempts().lost(lost), session);
        journal.begin_session(synthetic::session(session));
        journal.started(ended, 1);
        journal.started(lost, session + 1);
        EXPECT_EQ(journal.attempts().lost(lost), session) << "it is under way";
        journal.append(small_record(0));
    }  // killed
    {
        Journal journal = open_journal(path, "", Existing::resume);
        EXPECT_EQ(journal.attempts().lost(ended), 0);
        EXPECT_EQ(journal.attempts().lost(lost), 2);
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

TEST(Journal, CutAtEveryByteKeepsEveryWholeRecordAndGoesOn) {
    const SmallJournal small;
    const Bytes whole = file_bytes(small.path);
    const auto torn = small.folder / "torn.journal";
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        SCOPED_TRACE(size);
        write_file_bytes(torn, std::span(whole).first(size));
        const std::size_t kept = small.whole_records(size);
        if (size >= small.ends[0]) {
            const JournalContents contents = read_journal(torn);
            expect_small_records(contents.members, kept);
            EXPECT_EQ(contents.torn_bytes, size - small.ends[kept]);
            EXPECT_EQ(std::filesystem::file_size(torn), size) << "reading must not change the file";
        } else {
            EXPECT_THAT(refusal([&] { read_journal(torn); }), HasSubstr("holds nothing yet"));
        }
        {
            Journal journal = open_journal(torn, "name = \"small\"\n", Existing::resume);
            expect_small_records(journal, kept);
            EXPECT_EQ(journal.cut_bytes(), size >= small.ends[0] ? size - small.ends[kept] : 0);
            journal.append(small_record(static_cast<int>(kept)));
        }
        expect_small_records(read_journal(torn).members, kept + 1);
        EXPECT_EQ(read_journal(torn).torn_bytes, 0u);
    }
}

TEST(Journal, FlippedBitAtEveryByteNeverGivesAFalseRecord) {
    const SmallJournal small;
    const Bytes whole = file_bytes(small.path);
    const auto damaged = small.folder / "damaged.journal";
    for (std::size_t k = 0; k < whole.size(); ++k) {
        for (int bit = 0; bit < 8; ++bit) {
            SCOPED_TRACE(testing::Message() << "byte " << k << " bit " << bit);
            Bytes bytes = whole;
            bytes[k] ^= std::byte{1} << bit;
            write_file_bytes(damaged, bytes);
            if (k < small.ends[0]) {
                EXPECT_THROW(read_journal(damaged), InputError);
                EXPECT_THROW(open_journal(damaged, "", Existing::resume), InputError);
                EXPECT_EQ(file_bytes(damaged), bytes) << "what cannot be read must not be cut";
            } else {
                expect_small_records(read_journal(damaged).members, small.whole_records(k));
            }
        }
    }
}

TEST(Journal, GarbageLengthAsksForNoMemory) {
    const SmallJournal small;
    Bytes bytes = file_bytes(small.path);
    ByteWriter garbage;
    garbage.u64(0x7fffffffffffffff);
    for (int k = 0; k < 20; ++k) garbage.u32(1);
    bytes.insert(bytes.end(), garbage.bytes().begin(), garbage.bytes().end());
    write_file_bytes(small.path, bytes);
    expect_small_records(read_journal(small.path).members, 3);
    EXPECT_EQ(read_journal(small.path).torn_bytes, 88u);
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
    bytes[8] = std::byte{2};
    ByteWriter crc;
    crc.u32(journal_format::crc32c(std::span(bytes).first(20)));
    std::copy(crc.bytes().begin(), crc.bytes().end(), bytes.begin() + 20);
    write_file_bytes(small.path, bytes);
    EXPECT_THAT(refusal([&] { read_journal(small.path); }), HasSubstr("schema 2"));
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
    expect_small_records(read_journal(small.path).members, 3);
    EXPECT_EQ(open_journal(small.path, "other", Existing::replace).records().size(), 0u);
    EXPECT_EQ(read_journal(small.path).campaign_text, "other");
}

TEST(Journal, AdmitsOneWriter) {
    const SmallJournal small;
    EXPECT_FALSE(is_being_written(small.path));
    {
        const Journal first = open_journal(small.path, "", Existing::resume);
        EXPECT_TRUE(is_being_written(small.path));
        for (const Existing existing : {Existing::resume, Existing::replace, Existing::refuse})
            EXPECT_THAT(refusal([&] { open_journal(small.path, "", existing); }), HasSubstr("written by another run"));
        expect_small_records(read_journal(small.path).members, 3);
    }
    EXPECT_FALSE(is_being_written(small.path));
    expect_small_records(open_journal(small.path, "", Existing::resume), 3);
}

TEST(Journal, LeavesHistoriesInTheFile) {
    const SmallJournal small;
    Journal journal = open_journal(small.path, "", Existing::resume);
    journal.append(small_record(3));
    for (const MemberRecord& record : journal.records()) EXPECT_TRUE(record.result.history.surge.empty());
    expect_small_records(journal, 4);
    Bytes bytes = file_bytes(small.path);
    bytes[small.ends[1] + 40] ^= std::byte{1};
    write_file_bytes(small.path, bytes);  // as if the disk lost a bit during the run
    EXPECT_THROW(journal.history(journal.records()[1]), RunError);
    EXPECT_EQ(journal.history(journal.records()[2]).surge, small_record(2).result.history.surge);
}

TEST(Journal, SaysWhenItsFolderIsGone) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "run");
    Journal journal = open_journal(folder / "run/a.journal", "", Existing::refuse);
    journal.append(small_record(0));
    journal.sync();
    std::filesystem::rename(folder / "run", folder / "moved");
    journal.append(small_record(1));
    EXPECT_THROW(journal.sync(), RunError);
    expect_small_records(read_journal(folder / "moved/a.journal").members, 2);
    std::filesystem::remove_all(folder / "moved");
    EXPECT_THROW(journal.sync(), RunError);
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
        const auto known = match_records(large, journal.records());
        for (const int number : {1, 2, 4, 5}) EXPECT_NE(known[static_cast<std::size_t>(number)], nullptr) << number;
        EXPECT_EQ(std::ranges::count(known, nullptr), 5);
    }
    EXPECT_TRUE(open_journal(path, large, Existing::resume).extension().empty())
        << "the journal is of the large one now";
    EXPECT_EQ(fingerprint(read_stored_campaign(read_journal(path), path)), fingerprint(large));
    const std::uint64_t size = std::filesystem::file_size(path);
    const std::string message = refusal([&] { open_journal(path, small, Existing::resume); });
    EXPECT_THAT(message, HasSubstr("campaign.arrangements: 3 there, 2 here"));
    EXPECT_THAT(message, HasSubstr("may grow and never shrinks"));
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
    EXPECT_EQ(open_journal(path, campaign, Existing::resume).records().size(), 1u);
    campaign.name = "renamed";
    EXPECT_EQ(open_journal(path, campaign, Existing::resume).records().size(), 1u);
}

// A limit on the size of files stands for a full disk: the write that does not fit is undone.
TEST(Journal, StaysWholeWhenTheDiskIsFull) {
    const SmallJournal small;
    Journal journal = open_journal(small.path, "", Existing::resume);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit full{small.ends[3] + 20, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
    EXPECT_THROW(journal.append(small_record(3)), RunError);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(std::filesystem::file_size(small.path), small.ends[3]);
    journal.append(small_record(3));
    expect_small_records(read_journal(small.path).members, 4);
}

}  // namespace
}  // namespace floes
