#pragma once
// A journal of three small members, and the common parts of the tests of journals.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "store/journal.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"
#include "support/whole_records.hpp"

namespace floes {

// A record of a few hundred bytes, so that every byte can be damaged in turn.
inline MemberRecord small_record(int number) {
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
            journal.hand_over();
            ends.push_back(std::filesystem::file_size(path));
        }
    }

    // Whether a byte is of the header or where a record begins: its length and kind.
    bool is_in_a_head(std::uint64_t byte) const {
        constexpr std::uint64_t head = 64;
        return byte < ends[0] ||
               std::ranges::any_of(ends, [&](std::uint64_t at) { return byte >= at && byte < at + head; });
    }

    // Whole records in the first `size` bytes.
    std::size_t whole_records(std::uint64_t size) const {
        std::size_t count = 0;
        while (count + 1 < ends.size() && ends[count + 1] <= size) ++count;
        return count;
    }
};

inline void expect_small_records(const std::vector<MemberRecord>& records, std::size_t count) {
    ASSERT_EQ(records.size(), count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(encode(records[k]), encode(small_record(static_cast<int>(k))));
}

inline void expect_small_records(const std::filesystem::path& journal, std::size_t count) {
    expect_small_records(whole_records(read_journal(journal), journal), count);
}

inline void expect_small_records(const Journal& journal, std::size_t count) {
    expect_small_records(whole_records(journal.members()), count);
}

}  // namespace floes
