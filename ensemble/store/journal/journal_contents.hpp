#pragma once
// The contents of a journal, and how each record changes them, both when appended and when read.

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "records/attempt_book.hpp"
#include "records/calibration_record.hpp"
#include "records/session.hpp"
#include "records/stored_members.hpp"

namespace floes {

struct JournalContents {
    /// Position of a member's record in the file.
    struct Place {
        std::uint64_t offset = 0;
        std::uint64_t size = 0;
    };

    std::string campaign_text;      ///< resolved configuration, TOML
    MemberNotes members;            ///< in order of arrival; their records are left in the file
    std::deque<Place> places;       ///< of these records
    std::vector<Session> sessions;  ///< in order of time
    std::vector<CalibrationRecord> calibrations;
    AttemptBook attempts;
    std::uint64_t good_bytes = 0;     ///< up to the end of the last whole record
    std::uint64_t damaged_bytes = 0;  ///< bytes among these that belong to no whole record and were skipped
    std::uint64_t torn_bytes = 0;     ///< after these: a torn or damaged tail, or a record being written

    /// Adds a member whose record is at `place`, and counts it in the current session.
    void add(const MemberRecord& record, Place place);
    /// A session begins; attempts left open by the previous one are lost.
    void begin(const Session& session);
    /// The latest session has ended properly.
    void end(const std::string& when, const std::string& outcome);
};

}  // namespace floes
