// The verb `verify`: what it says of whole and damaged files, and its exit status.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "campaign_file/publish.hpp"
#include "cli/verb_output.hpp"
#include "cli/verify.hpp"
#include "core/error.hpp"
#include "store/journal.hpp"
#include "support/file_bytes.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace verify_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Verify : public testing::Test {
  protected:
    Verify() {
        const Campaign campaign = synthetic::campaign();
        const std::vector<MemberRecord> records = synthetic::records(campaign);
        publish(file_, campaign, records, std::vector<Session>{synthetic::session()});
        Journal journal = open_journal(journal_, campaign, Existing::refuse);
        for (const MemberRecord& record : records) {
            journal.append(record);
            journal.hand_over();
            ends_.push_back(std::filesystem::file_size(journal_));
        }
    }

    std::pair<std::string, int> verify(const std::string& arguments) {
        return verb_answer(add_verify, words_of("verify " + arguments));
    }

    static void flip(const std::filesystem::path& path, std::uint64_t at) {
        Bytes bytes = file_bytes(path);
        bytes.at(at) ^= std::byte{4};
        write_file_bytes(path, bytes);
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "a.h5";
    std::filesystem::path journal_ = folder_ / "a.journal";
    std::vector<std::uint64_t> ends_;  ///< of the records of the journal
};

TEST_F(Verify, SaysThatAllIsWell) {
    const auto [text, status] = verify(file_.string() + " " + journal_.string());
    EXPECT_EQ(status, 0);
    EXPECT_THAT(text, HasSubstr("a.h5: good, campaign file, "));
    EXPECT_THAT(text, HasSubstr(", digest "));
    EXPECT_THAT(text, HasSubstr("a.journal: good, journal, 11 members"));
}

TEST_F(Verify, SaysWhatIsDamagedAndHowToMakeItAnew) {
    flip(file_, std::filesystem::file_size(file_) / 2);
    const auto [text, status] = verify(file_.string() + " --format json");
    EXPECT_EQ(status, 1);
    const auto found = nlohmann::json::parse(text).at("files").at(0);
    EXPECT_EQ(found.at("state"), "damaged");
    EXPECT_FALSE(found.at("faults").empty());
    EXPECT_THAT(found.at("remedy").get<std::string>(),
                HasSubstr("--resume makes it anew from its journal, which is whole"));
    std::filesystem::remove(journal_);
    EXPECT_THAT(verify(file_.string()).first, HasSubstr("There is no journal beside it"));
}

// Also between what HDF5 stores, and where HDF5 passes a damaged byte on.
TEST_F(Verify, NoticesAFlippedByteOfEveryPage) {
    const Bytes whole = file_bytes(file_);
    std::filesystem::remove(journal_);
    for (std::size_t k = 77; k < whole.size(); k += 512) {
        Bytes bytes = whole;
        bytes[k] ^= std::byte{1};
        write_file_bytes(file_, bytes);
        EXPECT_EQ(verify_file(file_).state, FileState::damaged) << k;
    }
}

TEST_F(Verify, EndsForADamagedFileUnderTheNameOfAJournal) {
    Bytes bytes = file_bytes(file_);
    bytes[bytes.size() / 2] ^= std::byte{1};
    write_file_bytes(journal_, bytes);
    const FileVerdict verdict = verify_file(journal_);
    EXPECT_EQ(verdict.state, FileState::damaged);
    EXPECT_THAT(verdict.remedy, HasSubstr("Its journal is damaged as well"));
}

TEST_F(Verify, CallsAJournalOfANewerFloesNeitherGoodNorDamaged) {
    Bytes bytes = file_bytes(journal_);
    bytes[8] = std::byte{journal_format::schema + 1};
    const std::uint32_t crc = journal_format::crc32c(std::span(bytes).first(journal_format::fixed_header_bytes - 4));
    for (int k = 0; k < 4; ++k) bytes[20 + static_cast<std::size_t>(k)] = static_cast<std::byte>(crc >> 8 * k);
    write_file_bytes(journal_, bytes);
    const auto [text, status] = verify(journal_.string());
    EXPECT_EQ(status, 2);
    EXPECT_THAT(text, HasSubstr("a.journal: of a newer floes, journal\n  "));
    EXPECT_THAT(text, HasSubstr("Use the version of floes that wrote it"));
}

TEST_F(Verify, TellsATornJournalFromADamagedOne) {
    const Bytes whole = file_bytes(journal_);
    write_file_bytes(journal_, std::span(whole).first(ends_.back() - 7));
    FileVerdict verdict = verify_file(journal_);
    EXPECT_EQ(verdict.state, FileState::good);
    EXPECT_THAT(verdict.notes, ElementsAre(HasSubstr("a record that was begun and never finished")));
    EXPECT_THAT(verdict.counts, HasSubstr("10 members"));

    write_file_bytes(journal_, whole);
    flip(journal_, ends_[3] + 100);
    verdict = verify_file(journal_);
    EXPECT_EQ(verdict.state, FileState::damaged);
    EXPECT_THAT(verdict.faults, ElementsAre(HasSubstr("bytes inside it belong to no whole record")));
    EXPECT_THAT(verdict.whole, HasSubstr("10 members in it are whole"));

    write_file_bytes(journal_, whole);
    flip(journal_, ends_.back() - 50);
    verdict = verify_file(journal_);
    EXPECT_EQ(verdict.state, FileState::damaged);
    EXPECT_THAT(verdict.faults, ElementsAre(HasSubstr("are damaged")));

    write_file_bytes(journal_, whole);
    flip(journal_, 40);
    verdict = verify_file(journal_);
    EXPECT_EQ(verdict.state, FileState::damaged);
    EXPECT_THAT(verdict.faults, ElementsAre(HasSubstr("whose configuration is damaged")));
}

TEST_F(Verify, NoticesEveryFlippedByteOfASmallJournal) {
    const Bytes whole = file_bytes(journal_);
    const Bytes small(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(ends_.front()));
    for (std::size_t k = 0; k < small.size(); k += 7) {
        Bytes bytes = small;
        bytes[k] ^= std::byte{1};
        write_file_bytes(journal_, bytes);
        const FileVerdict verdict = verify_file(journal_);
        EXPECT_FALSE(verdict.state == FileState::good && verdict.notes.empty()) << k;
    }
}

TEST_F(Verify, KnowsWhatIsNoFileOfFloes) {
    const std::string text = "Dear reader";
    write_file_bytes(folder_ / "letter", std::as_bytes(std::span(text)));
    EXPECT_EQ(verify((folder_ / "letter").string()).second, 2);
    EXPECT_EQ(verify((folder_ / "nothing.h5").string()).second, 2);
    EXPECT_THAT(verify((folder_ / "letter").string()).first, HasSubstr("not of floes"));
}

}  // namespace verify_test
}  // namespace floes
