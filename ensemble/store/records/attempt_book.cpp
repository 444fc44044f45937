#include "records/attempt_book.hpp"

namespace floes {

void AttemptBook::session_ended() {
    std::erase_if(entries_, [](const auto& entry) { return entry.second.lost == 0; });
    for (auto& [member, entry] : entries_) entry.open = false;
}

void AttemptBook::close_session() {
    for (auto& [member, entry] : entries_) entry.lost += std::exchange(entry.open, false) ? 1 : 0;
}

int AttemptBook::lost(const MemberIdentity& member) const {
    const auto found = entries_.find(member);
    return found == entries_.end() ? 0 : found->second.lost;
}

}  // namespace floes
