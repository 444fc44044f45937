// Journals whose members are partly in pieces, which other ranks append to.

#include <gmock/gmock.h>

#include <set>

#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/small_journal.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace journal_pieces_test {

using testing::ElementsAre;
using testing::HasSubstr;

/// A journal with member 0 and, in its pieces 1 and 10, members 1 and 2 and member 3.
struct InPieces {
    TemporaryFolder folder;
    std::filesystem::path path = folder / "a.journal";

    InPieces() {
        Journal journal = open_journal(path, "", Existing::refuse);
        journal.begin_session(synthetic::session(0));
        for (const int number : {0, 1, 2, 3}) journal.started({"case", number}, 1);
        journal.append(small_record(0));
        Journal first = open_journal(piece_path(path, 1), "", Existing::resume);
        first.append(small_record(1));
        first.append(small_record(2));
        Journal tenth = open_journal(piece_path(path, 10), "", Existing::resume);
        tenth.append(small_record(3));
        for (const int number : {1, 2, 3}) journal.done_in_piece({"case", number});
    }

    std::set<int> arrangements() const {
        std::set<int> found;
        for (const MemberRecord& record : whole_records(read_journal(path), path)) found.insert(record.arrangement);
        return found;
    }
};

TEST(JournalPieces, StandBesideTheJournalByNumber) {
    const InPieces made;
    EXPECT_EQ(piece_path("folder/a.journal", 3), "folder/a.journal.3");
    for (const char* other : {"a.journal.tmp", "a.journal.01", "a.journal.0", "a.journal.-1", "b.journal.4"})
        write_file_bytes(made.folder / other, {});
    EXPECT_THAT(pieces_of(made.path), ElementsAre(1, 10));
    EXPECT_TRUE(pieces_of("no/such.journal").empty());
}

TEST(JournalPieces, AreReadWithTheJournal) {
    const InPieces made;
    expect_small_records(made.path, 4);
    const JournalContents contents = read_journal(made.path);
    EXPECT_EQ(contents.sessions.at(0).computed, 4);
    expect_small_records(open_journal(made.path, "", Existing::resume), 4);
}

TEST(JournalPieces, AreTakenInWhileTheyGrow) {
    const InPieces made;
    Journal journal = open_journal(made.path, "", Existing::resume);
    {
        Journal first = open_journal(piece_path(made.path, 1), "", Existing::resume);
        first.append(small_record(4));
        Journal fresh = open_journal(piece_path(made.path, 11), "", Existing::resume);
        fresh.append(small_record(5));
    }
    journal.take_in_pieces();
    journal.take_in_pieces();
    std::set<int> found;
    for (const MemberRecord& record : whole_records(journal.members())) found.insert(record.arrangement);
    EXPECT_EQ(found, (std::set<int>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(journal.members().notes().size(), 6u);
}

TEST(JournalPieces, AreTakenInAsTheirWritersTell) {
    const InPieces made;
    Journal journal = open_journal(made.path, "", Existing::resume);
    Journal fresh = open_journal(piece_path(made.path, 11), "", Existing::resume);
    fresh.append(small_record(4));
    fresh.hand_over();
    JournalContents::Place place = fresh.contents().places.at(0);
    place.piece = 11;
    journal.take_in(identity(small_record(4)), fresh.contents().members[0], place);
    EXPECT_EQ(journal.members().notes().size(), 5u);
    EXPECT_EQ(encode(journal.members().read(4)), encode(small_record(4)));
    journal.take_in_pieces();  // has it already
    EXPECT_EQ(journal.members().notes().size(), 5u);
}

// The note may be lost with the master, the record with a node: the record decides.
TEST(JournalPieces, DecideWhatIsDone) {
    const InPieces made;
    std::filesystem::remove(piece_path(made.path, 1));
    EXPECT_EQ(made.arrangements(), (std::set<int>{0, 3}));
    {
        Journal late = open_journal(piece_path(made.path, 2), "", Existing::resume);
        late.append(small_record(7));
    }
    EXPECT_EQ(made.arrangements(), (std::set<int>{0, 3, 7}));
    std::filesystem::remove(made.path);  // lost with its disk, say
    open_journal(made.path, "", Existing::resume);
    EXPECT_EQ(made.arrangements(), (std::set<int>{3, 7}));
}

// An attempt that began and never ended may be the cause of a lost session; one whose result is in a piece ended.
TEST(JournalPieces, EndTheAttemptsOfTheirMembers) {
    const InPieces made;
    { open_journal(made.path, "", Existing::resume).started({"case", 4}, 1); }
    const Journal journal = open_journal(made.path, "", Existing::resume);
    for (const int number : {0, 1, 2, 3}) EXPECT_EQ(journal.contents().attempts.lost({"case", number}), 0);
    EXPECT_EQ(journal.contents().attempts.lost({"case", 4}), 1);
}

TEST(JournalPieces, AreReplacedWithTheJournal) {
    const InPieces made;
    open_journal(made.path, "", Existing::replace);
    EXPECT_TRUE(pieces_of(made.path).empty());
    expect_small_records(made.path, 0);
}

TEST(JournalPieces, StillBeingWrittenAreRefused) {
    const InPieces made;
    const Journal orphan = open_journal(piece_path(made.path, 10), "", Existing::resume);
    for (const Existing existing : {Existing::resume, Existing::replace})
        EXPECT_THAT(refusal([&] { open_journal(made.path, "", existing); }),
                    HasSubstr("a.journal.10 is being written by another run"));
    EXPECT_EQ(made.arrangements().size(), 4u);  // reading changes nothing
}

TEST(JournalPieces, LoseOnlyWhatIsTornOrDamaged) {
    const InPieces made;
    const auto piece = piece_path(made.path, 1);
    const auto whole = file_bytes(piece);
    auto bytes = whole;
    bytes.resize(whole.size() - 1);
    write_file_bytes(piece, bytes);
    EXPECT_EQ(made.arrangements(), (std::set<int>{0, 1, 3}));
    EXPECT_EQ(read_journal(made.path).damaged_bytes, 0u);
    bytes = whole;
    bytes[whole.size() - 10] ^= std::byte{1};  // in the last record, which is whole but for this
    write_file_bytes(piece, bytes);
    EXPECT_EQ(made.arrangements(), (std::set<int>{0, 1, 3}));
    EXPECT_GT(read_journal(made.path).damaged_bytes, 0u);
    bytes.resize(10);  // its writer was stopped in the header
    write_file_bytes(piece, bytes);
    EXPECT_EQ(made.arrangements(), (std::set<int>{0, 3}));
    bytes[3] = std::byte{'x'};
    write_file_bytes(piece, bytes);
    EXPECT_THAT(refusal([&] { read_journal(made.path); }), HasSubstr("a.journal.1 is not a journal of floes"));
}

}  // namespace journal_pieces_test
}  // namespace floes
