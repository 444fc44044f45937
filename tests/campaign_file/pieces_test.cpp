// Campaign files whose rows lie in pieces: the same to every reader as one file, and refused where a piece is not as it
// was written.

#include "campaign_file/pieces.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "campaign_file/kinds.hpp"
#include "campaign_file/publish.hpp"
#include "core/error.hpp"
#include "hdf5/pages.hpp"
#include "hdf5/read.hpp"
#include "support/everything_read.hpp"
#include "support/in_pieces.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace pieces_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class Pieces : public testing::Test {
  protected:
    fs::path path(const char* name) const { return folder_ / name; }

    void publish_both(int count) {
        publish(path("one.h5"), campaign_, records_, sessions_);
        publish_in_pieces(path("a.h5"), campaign_, records_, count, sessions_);
    }

    /// What is said when the file is read; empty where it is read.
    std::string said() const {
        try {
            everything_read(path("a.h5"));
            return "";
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    }

    std::vector<std::string> names_in(const char* folder) const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(path(folder)))
            names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }

    TemporaryFolder folder_;
    Campaign campaign_ = synthetic::campaign();
    std::vector<MemberRecord> records_ = synthetic::records(campaign_);
    std::vector<Session> sessions_{synthetic::session(0)};
};

/// everything_read() but when it was published.
Bytes results_read(const fs::path& path) {
    ByteWriter out;
    for (const auto& read : parts_read)
        if (read != origin_read) out.blob(read(path));
    return out.take();
}

/// The digest of each dataset outside /provenance.
std::map<std::string, std::string> digests_of(const fs::path& path) {
    const hdf5::Handle file = hdf5::open_for_reading(path);
    std::map<std::string, std::string> digests;
    for (const std::string& name : hdf5::paths_of(file.id()).datasets)
        if (!name.starts_with("/provenance/piece"))
            digests[name] = hdf5::digest_text(hdf5::read_digest(hdf5::open_dataset(file.id(), name).id()).value());
    return digests;
}

TEST_F(Pieces, HaveTheDigestsOfOneFile) {
    for (const int count : {1, 2, 3, 4}) {
        publish_both(count);
        EXPECT_EQ(digests_of(path("a.h5")), digests_of(path("one.h5"))) << count;
        const hdf5::FileCheck one = hdf5::check_file(path("one.h5"), {});
        const hdf5::FileCheck over = hdf5::check_file(path("a.h5"), {});
        EXPECT_TRUE(over.good()) << over.fault << over.between;
        EXPECT_EQ(over.contents, one.contents) << count;
        EXPECT_EQ(results_read(path("a.h5")), results_read(path("one.h5"))) << count;
    }
}

TEST_F(Pieces, HaveTheDigestsOfOneFileWithoutAnyMember) {
    records_.clear();
    publish_both(2);
    EXPECT_EQ(digests_of(path("a.h5")), digests_of(path("one.h5")));
    EXPECT_EQ(said(), "");
}

TEST_F(Pieces, AreGoodByThemselves) {
    publish_both(3);
    for (const char* name : {"1-1.h5", "1-2.h5", "1-3.h5"}) {
        const hdf5::FileCheck check = hdf5::check_file(path("a.pieces") / name, {});
        EXPECT_TRUE(check.good()) << check.fault;
        EXPECT_EQ(check.filetype, piece_kind.filetype);
    }
}

TEST_F(Pieces, MoveWithTheFile) {
    publish_both(3);
    const Bytes before = everything_read(path("a.h5"));
    fs::create_directory(path("elsewhere"));
    fs::rename(path("a.h5"), path("elsewhere") / "renamed.h5");
    fs::rename(path("a.pieces"), path("elsewhere") / "a.pieces");
    EXPECT_EQ(everything_read(path("elsewhere") / "renamed.h5"), before);
}

TEST_F(Pieces, LieBesideWhatALinkPointsTo) {
    fs::create_directory(path("there"));
    fs::create_symlink("there/a.h5", path("a.h5"));
    publish_both(2);
    EXPECT_TRUE(fs::is_symlink(path("a.h5")));
    EXPECT_THAT(names_in("there"), ElementsAre("a.h5", "a.pieces"));
    EXPECT_EQ(results_read(path("a.h5")), results_read(path("one.h5")));
}

TEST_F(Pieces, MayHavePercentSignsInTheirNames) {
    publish(path("one.h5"), campaign_, records_, sessions_);
    publish_in_pieces(path("50%b.h5"), campaign_, records_, 2, sessions_);
    EXPECT_EQ(results_read(path("50%b.h5")), results_read(path("one.h5")));
}

TEST_F(Pieces, ThatAreMissingAreNamed) {
    publish_both(3);
    fs::remove(path("a.pieces") / "1-2.h5");
    EXPECT_THAT(said(), AllOf(HasSubstr("a.pieces/1-2.h5"), HasSubstr("arrangement 1"), HasSubstr("3 pieces")));
}

TEST_F(Pieces, ThatAreCutOffAreNamed) {
    publish_both(3);
    const fs::path piece = path("a.pieces") / "1-3.h5";
    for (const std::uintmax_t size :
         {hdf5::CheckedPages::open(piece)->size() - 1, std::uint64_t{600}, std::uint64_t{0}}) {
        fs::resize_file(piece, size);
        EXPECT_THAT(said(), HasSubstr("a.pieces/1-3.h5")) << size;
    }
}

TEST_F(Pieces, OfOtherMembersAreRefused) {
    publish_both(3);
    records_[0].result.load.mean += 1;
    publish_in_pieces(path("b.h5"), campaign_, records_, 3, sessions_);
    fs::copy_file(path("b.pieces") / "1-1.h5", path("a.pieces") / "1-1.h5", fs::copy_options::overwrite_existing);
    EXPECT_THAT(said(), AllOf(HasSubstr("a.pieces/1-1.h5"), HasSubstr("not the piece")));
}

/// Zeros may be room that nothing fills.
std::uint64_t first_byte_in_use(const fs::path& path, std::uint64_t from) {
    std::ifstream file(path, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(from));
    while (file.get() == 0) ++from;
    return from;
}

TEST_F(Pieces, WithChangedBytesGiveNoNumber) {
    publish_both(2);
    const Bytes right = everything_read(path("a.h5"));
    const fs::path piece = path("a.pieces") / "1-1.h5";
    const std::uint64_t size = hdf5::CheckedPages::open(piece)->size();
    int refused = 0;
    for (std::uint64_t from = 1000; from < size; from += size / 24) {
        const std::uint64_t at = first_byte_in_use(piece, from);
        const auto flip = [&] {
            std::fstream file(piece, std::ios::in | std::ios::out | std::ios::binary);
            file.seekg(static_cast<std::streamoff>(at));
            const auto changed = static_cast<char>(file.get() ^ 16);
            file.seekp(static_cast<std::streamoff>(at));
            file.put(changed);
        };
        flip();
        const std::string words = said();
        if (words.empty()) {
            EXPECT_EQ(everything_read(path("a.h5")), right) << at;
        }
        refused += words.empty() ? 0 : 1;
        flip();
    }
    EXPECT_GT(refused, 3);
}

TEST_F(Pieces, OfAnOlderFileStayUntilTheNewOneStands) {
    publish_both(3);
    const Bytes before = results_read(path("a.h5"));
    publish_pieces(path("a.h5"), campaign_, records_, 2, 2);  // the run is killed before its file
    EXPECT_EQ(results_read(path("a.h5")), before);
    publish_in_pieces(path("a.h5"), campaign_, records_, 2, sessions_, {}, 3);
    EXPECT_THAT(names_in("a.pieces"), ElementsAre("3-1.h5", "3-2.h5"));
    EXPECT_EQ(results_read(path("a.h5")), before);
}

TEST_F(Pieces, GoWhenOneFileHasAllRows) {
    publish_both(3);
    publish(path("a.h5"), campaign_, records_, sessions_);
    EXPECT_FALSE(fs::exists(path("a.pieces")));
    EXPECT_EQ(results_read(path("a.h5")), results_read(path("one.h5")));
}

}  // namespace pieces_test
}  // namespace floes
