// The verb `verify`: what it says of whole and damaged files, and its exit status.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "campaign_file/read.hpp"
#include "cli/verb_output.hpp"
#include "cli/verify.hpp"
#include "core/error.hpp"
#include "hdf5/dataset.hpp"
#include "hdf5/read.hpp"
#include "store/journal.hpp"
#include "support/file_bytes.hpp"
#include "support/published.hpp"
#include "support/refusal.hpp"
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
        synthetic::publish(file_, campaign);
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

/// What another program does to an HDF5 file.
class VerifyOfOthers : public Verify {
  protected:
    hdf5::Handle opened() const {
        const hdf5::Handle access = hdf5::access_without_locks();
        return {H5Fopen(file_.c_str(), H5F_ACC_RDWR, access.id()), H5Fclose, "H5Fopen", "a.h5"};
    }

    /// Notes, faults, state and exit status after the change.
    struct Told {
        std::string notes, faults, state;
        int status;
    };
    Told after(const std::function<void(hid_t)>& change) {
        change(opened().id());
        const auto [text, status] = verify(file_.string() + " --format json");
        const auto found = nlohmann::json::parse(text).at("files").at(0);
        const auto lines = [&](const char* name) { return found.contains(name) ? found.at(name).dump() : ""; };
        return {lines("notes"), lines("faults"), found.at("state"), status};
    }

    static void note(hid_t file, const char* path, const char* name) {
        const hdf5::Handle object(H5Oopen(file, path, H5P_DEFAULT), H5Oclose, "H5Oopen", path);
        hdf5::write_attribute(object.id(), name, std::string("checked by Anna"));
    }
};

TEST_F(VerifyOfOthers, NamesWhatTheyAddedToAGoodFile) {
    const Told told = after([](hid_t file) {
        note(file, "/", "my note");
        note(file, "/members/mean_load", "note");
        note(file, "/members", "note");
        note(file, "/provenance", "note");
        const std::array<hsize_t, 1> two{2};
        const std::array<const char*, 2> words{"a", "b"};
        hdf5::write_attribute_of(file, "words", two, hdf5::text_type().id(), hdf5::text_type().id(), words.data());
        const hdf5::Handle group = hdf5::create_group(file, "mine");
        const hdf5::Handle empty = hdf5::create_group(file, "notes");
        note(file, "/notes", "who");
        const std::array<hsize_t, 1> size{3};
        const hdf5::Handle set(H5Dcreate2(group.id(), "extra", H5T_NATIVE_DOUBLE, hdf5::simple_space(size).id(),
                                          H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                               H5Dclose, "H5Dcreate", "extra");
        const hdf5::Handle beside(H5Dcreate2(file, "members/extra", H5T_NATIVE_INT, hdf5::simple_space(size).id(),
                                             H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                  H5Dclose, "H5Dcreate", "members/extra");
        H5Lcreate_soft("/members/mean_load", file, "latest", H5P_DEFAULT, H5P_DEFAULT);
        H5Lcreate_soft("/nowhere", file, "lost", H5P_DEFAULT, H5P_DEFAULT);
    });
    EXPECT_EQ(told.state, "good") << told.faults;
    EXPECT_EQ(told.status, 0);
    EXPECT_THAT(told.notes,
                HasSubstr("Added by other programs, and not checked: /latest, /lost, /members/extra, /mine, "
                          "/mine/extra, /notes, the attribute my note of /, the attribute words of /, the attribute "
                          "note of /members, "
                          "the attribute note of /members/mean_load, the attribute note of /provenance."));
    const CampaignFile file(file_);
    EXPECT_EQ(read_campaign_file(file).members.size(), static_cast<std::size_t>(member_count(synthetic::campaign())));
}

TEST_F(VerifyOfOthers, FindsWhatTheyChangedBesideWhatTheyAdded) {
    const auto changed = [&](const std::function<void(hid_t)>& change) {
        synthetic::publish(file_);
        const Told told = after([&](hid_t file) {
            note(file, "/", "my note");
            change(file);
        });
        EXPECT_EQ(told.status, 1);
        EXPECT_EQ(told.state, "damaged");
        return told.faults;
    };
    EXPECT_THAT(changed([](hid_t file) {
                    const hdf5::Handle set(H5Dopen2(file, "members/mean_load", H5P_DEFAULT), H5Dclose, "", "");
                    auto values = hdf5::read_values<double>(file, "members/mean_load");
                    values[3] += 1;
                    H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
                }),
                HasSubstr("/members/mean_load does not fit its digest"));
    EXPECT_THAT(changed([](hid_t file) {
                    const hdf5::Handle set(H5Dopen2(file, "members/mean_load", H5P_DEFAULT), H5Dclose, "", "");
                    H5Adelete(set.id(), "units");
                    hdf5::write_attribute(set.id(), "units", std::string("kN"));
                }),
                HasSubstr("its attributes, or the names of its datasets, are not those that were written"));
    EXPECT_THAT(changed([](hid_t file) {
                    H5Adelete(file, "title");
                    hdf5::write_attribute(file, "title", std::string("another"));
                }),
                HasSubstr("its attributes"));
    EXPECT_THAT(changed([](hid_t file) { H5Ldelete(file, "members/trend", H5P_DEFAULT); }),
                HasSubstr("its attributes"));
    EXPECT_THAT(changed([](hid_t file) {
                    const hdf5::Handle set(H5Dopen2(file, "members/trend", H5P_DEFAULT), H5Dclose, "", "");
                    H5Adelete(set.id(), "digest");
                }),
                HasSubstr("/members/trend has no digest"));
}

// HDF5 marks a file that is open for writing. It is not damaged, and its numbers are not to be had.
TEST_F(VerifyOfOthers, SaysThatTheFileIsOpenElsewhere) {
    {
        const hdf5::Handle file = opened();
        note(file.id(), "/", "my note");
        H5Fflush(file.id(), H5F_SCOPE_GLOBAL);
        const std::filesystem::path held = folder_ / "held file.h5";
        std::filesystem::copy_file(file_, held);  // this process may open its own
        const auto [text, status] = verb_answer(add_verify, {"verify", held.string()});
        EXPECT_EQ(status, 2);
        EXPECT_THAT(text, HasSubstr("held file.h5: open elsewhere"));
        EXPECT_THAT(text, HasSubstr("is open for writing in another program"));
        EXPECT_THAT(text, HasSubstr("h5clear -s '"));
        EXPECT_THAT(refusal([&] { CampaignFile{held}; }), HasSubstr("close it there, and try again"));
    }
    EXPECT_EQ(verify(file_.string()).second, 0);
    synthetic::publish(file_);
    Bytes bytes = file_bytes(file_);
    bytes.at(11) |= std::byte{1};  // the mark alone is a damaged byte
    write_file_bytes(file_, bytes);
    EXPECT_THAT(verify(file_.string()).first, HasSubstr("a.h5: damaged"));
}

}  // namespace verify_test
}  // namespace floes
