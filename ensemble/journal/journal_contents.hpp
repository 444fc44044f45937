#pragma once
// All that a journal holds, and what each of its records adds to that: the same when it is appended and when it is
// read.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "records/attempt_book.hpp"
#include "records/calibration_record.hpp"
#include "records/member_record.hpp"
#include "records/session.hpp"

namespace floes {

/// Whether the load histories of members, nearly all that a journal holds, are kept in memory or left in the file.
enum class Histories { keep, leave };

struct JournalContents {
    /// Where the record of a member stands in the file.
    struct Place {
        std::uint64_t offset = 0;
        std::uint64_t size = 0;
    };

    std::string campaign_text;          ///< resolved configuration, TOML
    std::vector<MemberRecord> members;  ///< in order of arrival
    std::vector<Place> places;          ///< of the members
    std::vector<Session> sessions;      ///< in order of time
    std::vector<CalibrationRecord> calibrations;
    AttemptBook attempts;
    std::uint64_t good_bytes = 0;     ///< up to the end of the last whole record
    std::uint64_t damaged_bytes = 0;  ///< of these, those that belong to no whole record and were passed over
    std::uint64_t torn_bytes = 0;     ///< after that: a torn or damaged tail, or a record just being written

    /// Enters a member, which is one more of the session that it came in.
    void add(MemberRecord record, Place place, Histories histories);
    /// A session begins; attempts that the one before it left open are lost.
    void begin(const Session& session);
    /// The session begun last has ended by itself.
    void end(const std::string& when, const std::string& outcome);
};

}  // namespace floes
