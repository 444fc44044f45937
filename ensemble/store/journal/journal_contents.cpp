#include "journal/journal_contents.hpp"

namespace floes {

void JournalContents::add(const MemberRecord& record, Place place) {
    attempts.finished(identity(record));
    if (!sessions.empty()) {
        Session& session = sessions.back();
        ++(record.result.status == MemberStatus::done ? session.computed : session.set_aside);
    }
    members.add(record);
    places.push_back(place);
}

void JournalContents::begin(const Session& session) {
    attempts.close_session();
    sessions.push_back(session);
}

void JournalContents::end(const std::string& when, const std::string& outcome) {
    attempts.session_ended();
    if (sessions.empty()) return;
    sessions.back().ended = when;
    sessions.back().outcome = outcome;
}

}  // namespace floes
