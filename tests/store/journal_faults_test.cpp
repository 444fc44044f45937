// Damage to a journal by disks and other processes: cut, flipped, full, gone, shared.

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <ctime>
#include <fstream>

#include "core/error.hpp"
#include "store/journal.hpp"
#include "support/file_bytes.hpp"
#include "support/small_journal.hpp"

namespace floes {
namespace journal_faults_test {

using testing::HasSubstr;

TEST(JournalFaults, CutAtEveryByteKeepsEveryWholeRecordAndGoesOn) {
    const SmallJournal small;
    const Bytes whole = file_bytes(small.path);
    const auto torn = small.folder / "torn.journal";
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        SCOPED_TRACE(size);
        write_file_bytes(torn, std::span(whole).first(size));
        const std::size_t kept = small.whole_records(size);
        if (size >= small.ends[0]) {
            const JournalContents contents = read_journal(torn);
            expect_small_records(torn, kept);
            EXPECT_EQ(contents.torn_bytes, size - small.ends[kept]);
            EXPECT_EQ(std::filesystem::file_size(torn), size) << "reading must not change the file";
        } else {
            EXPECT_THAT(refusal([&] { read_journal(torn); }), HasSubstr("is still empty"));
        }
        {
            Journal journal = open_journal(torn, "name = \"small\"\n", Existing::resume);
            expect_small_records(journal, kept);
            EXPECT_EQ(journal.contents().torn_bytes, size >= small.ends[0] ? size - small.ends[kept] : 0);
            journal.append(small_record(static_cast<int>(kept)));
        }
        expect_small_records(torn, kept + 1);
        EXPECT_EQ(read_journal(torn).torn_bytes, 0u);
    }
}

// Reading a megabyte for each took minutes.
TEST(JournalFaults, DamageAtManyPlacesIsSkippedInTime) {
    const TemporaryFolder folder;
    const auto path = folder / "many.journal";
    Bytes bytes = journal_format::header("name = \"many\"\n");
    const Bytes one = journal_format::record(journal_format::RecordType::member, encode(small_record(1)));
    constexpr int members = 10'000;
    for (int k = 0; k < members; ++k) {
        bytes.push_back(std::byte{0xff});
        bytes.insert(bytes.end(), one.begin(), one.end());
    }
    write_file_bytes(path, bytes);
    const std::clock_t begin = std::clock();  // of the processor
    const JournalContents contents = read_journal(path);
    EXPECT_LT(std::clock() - begin, 10 * CLOCKS_PER_SEC);
    EXPECT_EQ(contents.members.size(), static_cast<std::size_t>(members));
    EXPECT_EQ(contents.damaged_bytes, static_cast<std::uint64_t>(members));
}

// Each place looked like a record as long as the file, of which the checksum was computed.
TEST(JournalFaults, BytesThatAllLookLikeRecordsAreRefusedInTime) {
    const TemporaryFolder folder;
    const auto path = folder / "made.journal";
    Bytes bytes = journal_format::header("name = \"made\"\n");
    ByteWriter head;
    for (int k = 0; k < 200'000; ++k) {
        head.u64(1'000'000);
        head.u32(static_cast<std::uint32_t>(journal_format::RecordType::member));
    }
    bytes.push_back(std::byte{0xff});
    bytes.insert(bytes.end(), head.bytes().begin(), head.bytes().end());
    write_file_bytes(path, bytes);
    const std::clock_t begin = std::clock();  // of the processor
    EXPECT_THAT(refusal([&] { read_journal(path); }),
                HasSubstr("is a journal with so much that looks like a record after byte "));
    EXPECT_LT(std::clock() - begin, 10 * CLOCKS_PER_SEC);
}

TEST(JournalFaults, FlippedBitAtEveryByteNeverGivesAFalseRecord) {
    const SmallJournal small;
    const Bytes whole = file_bytes(small.path);
    const auto damaged = small.folder / "damaged.journal";
    for (std::size_t k = 0; k < whole.size(); ++k) {
        for (std::size_t bit = 0; bit < 8; ++bit) {
            if (!small.is_in_a_head(k) && bit != k % 8) continue;  // under a checksum one bit is as good as another
            SCOPED_TRACE(testing::Message() << "byte " << k << " bit " << bit);
            const bool opens = (8 * k + bit) % 61 == 0;  // for writing, which syncs
            Bytes bytes = whole;
            bytes[k] ^= std::byte{1} << bit;
            write_file_bytes(damaged, bytes);
            if (k < small.ends[0]) {
                EXPECT_THROW(read_journal(damaged), InputError);
                if (opens) {
                    EXPECT_THROW(open_journal(damaged, "", Existing::resume), InputError);
                }
                EXPECT_EQ(file_bytes(damaged), bytes) << "what cannot be read must not be cut";
            } else {
                // All but the damaged one, and opening for writing does not cut those behind it off.
                const std::size_t lost = small.whole_records(k);
                if (opens) open_journal(damaged, "", Existing::resume);
                const JournalContents contents = read_journal(damaged);
                const std::vector<MemberRecord> whole_ones = whole_records(contents, damaged);
                ASSERT_EQ(whole_ones.size(), 2u);
                for (std::size_t i = 0, number = 0; i < 2; ++i, ++number) {
                    if (number == lost) ++number;
                    EXPECT_EQ(encode(whole_ones[i]), encode(small_record(static_cast<int>(number))));
                }
                EXPECT_EQ(contents.damaged_bytes, lost == 2 ? 0 : small.ends[lost + 1] - small.ends[lost]);
            }
        }
    }
}

TEST(JournalFaults, GarbageLengthAsksForNoMemory) {
    const SmallJournal small;
    Bytes bytes = file_bytes(small.path);
    ByteWriter garbage;
    garbage.u64(0x7fffffffffffffff);
    for (int k = 0; k < 20; ++k) garbage.u32(1);
    bytes.insert(bytes.end(), garbage.bytes().begin(), garbage.bytes().end());
    write_file_bytes(small.path, bytes);
    expect_small_records(small.path, 3);
    EXPECT_EQ(read_journal(small.path).torn_bytes, 88u);
}

TEST(JournalFaults, AdmitsOneWriter) {
    const SmallJournal small;
    EXPECT_FALSE(is_being_written(small.path));
    {
        const Journal first = open_journal(small.path, "", Existing::resume);
        EXPECT_TRUE(is_being_written(small.path));
        for (const Existing existing : {Existing::resume, Existing::replace, Existing::refuse})
            EXPECT_THAT(refusal([&] { open_journal(small.path, "", existing); }), HasSubstr("written by another run"));
        expect_small_records(small.path, 3);
    }
    EXPECT_FALSE(is_being_written(small.path));
    expect_small_records(open_journal(small.path, "", Existing::resume), 3);
}

TEST(JournalFaults, ReadsRecordsFromTheFile) {
    const SmallJournal small;
    Journal journal = open_journal(small.path, "", Existing::resume);
    journal.append(small_record(3));
    journal.hand_over();
    expect_small_records(journal, 4);
    std::fstream file(small.path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(small.ends[1]) + 40);
    file.put('!');  // as if the disk lost something during the run
    file.close();
    EXPECT_THROW(journal.members().read(1), RunError);
    EXPECT_EQ(encode(journal.members().read(2)), encode(small_record(2)));
}

TEST(JournalFaults, SaysWhenItsFolderIsGone) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "run");
    Journal journal = open_journal(folder / "run/a.journal", "", Existing::refuse);
    journal.append(small_record(0));
    journal.sync();
    std::filesystem::rename(folder / "run", folder / "moved");
    journal.append(small_record(1));
    EXPECT_THROW(journal.sync(), RunError);
    expect_small_records(folder / "moved/a.journal", 2);
    std::filesystem::remove_all(folder / "moved");
    EXPECT_THROW(journal.sync(), RunError);
}

// A limit on the size of files stands for a full disk: the write that does not fit is undone.
TEST(JournalFaults, StaysWholeWhenTheDiskIsFull) {
    const SmallJournal small;
    Journal journal = open_journal(small.path, "", Existing::resume);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit full{small.ends[3] + 20, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
    journal.append(small_record(3));
    EXPECT_THROW(journal.hand_over(), RunError);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(std::filesystem::file_size(small.path), small.ends[3]);
    journal.append(small_record(3));
    journal.hand_over();
    expect_small_records(small.path, 4);
}

}  // namespace journal_faults_test
}  // namespace floes
