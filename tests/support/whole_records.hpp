#pragma once
// The records of a journal as appended, with their histories, which a journal leaves in its file.

#include <vector>

#include "journal/journal.hpp"

namespace floes {

inline std::vector<MemberRecord> whole_records(const Journal& journal) {
    std::vector<MemberRecord> whole;
    for (const MemberRecord& record : journal.records()) {
        whole.push_back(record);
        whole.back().history = journal.history(record);
    }
    return whole;
}

}  // namespace floes
