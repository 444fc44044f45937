#pragma once
// The records of a journal as appended, read back from its file.

#include <vector>

#include "store/journal.hpp"

namespace floes {

inline std::vector<MemberRecord> whole_records(const StoredMembers& members) {
    std::vector<MemberRecord> whole;
    for (std::size_t k = 0; k < members.notes().size(); ++k) whole.push_back(members.read(k));
    return whole;
}

inline std::vector<MemberRecord> whole_records(const JournalContents& contents, const std::filesystem::path& path) {
    return whole_records(stored_members(contents, path));
}

}  // namespace floes
