#pragma once
// The journal of a campaign: its contents as records change them, its bytes, and the file that is appended to.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign.hpp"
#include "core/bytes.hpp"
#include "core/error.hpp"
#include "store/file_calls.hpp"
#include "store/member_record.hpp"
#include "store/session.hpp"
#include "store/system.hpp"

namespace floes {

struct JournalContents {
    /// Position of a member's record.
    struct Place {
        std::uint64_t offset = 0;
        std::uint64_t size = 0;
        int piece = 0;  ///< of the journal, in which the record is; 0: in the journal itself
    };
    /// What a writer other than the master appends to: see piece_path().
    struct Piece {
        int number = 1;
        std::uint64_t good_bytes = 0;  ///< up to the end of the last whole record
    };

    std::uint64_t first_record = 0;             ///< offset in the file
    std::string campaign_text;                  ///< resolved configuration, TOML
    MemberNotes members;                        ///< in order of arrival, piece by piece; their records stay in files
    std::deque<Place> places;                   ///< of these records
    std::vector<Session> sessions;              ///< in order of time
    std::vector<std::uint64_t> session_begins;  ///< offset in the file of each
    std::vector<CalibrationRecord> calibrations;
    AttemptBook attempts;
    std::vector<Piece> pieces;        ///< in order of their numbers
    std::uint64_t good_bytes = 0;     ///< up to the end of the last whole record
    std::uint64_t damaged_bytes = 0;  ///< bytes among these, of pieces too, that belong to no whole record and are
                                      ///< skipped; the members in them are computed again
    std::uint64_t torn_bytes = 0;     ///< after these: a torn or damaged tail, or a record being written

    /// Adds a member whose record is at `place`, and counts it in the current session unless it is in a piece.
    void add(const MemberRecord& record, Place place);
    /// Counts a member whose record is in a piece.
    void add_done(const MemberIdentity& member);
    /// A session begins; attempts left open by the previous one are lost.
    void begin(const Session& session, std::uint64_t at);
    /// The latest session has ended properly.
    void end(const std::string& when, const std::string& outcome);
};

}  // namespace floes

namespace floes::journal_format {

// The binary layout of a journal. All numbers are little endian.
//
//     header   magic (8)  schema (u32)  text length (u64)  CRC32C of these 20 bytes (u32)
//              text  CRC32C of the text (u32)
//     record   payload length (u64)  type (u32)  payload  CRC32C of all before in the record (u32)

inline constexpr std::string_view magic = "floesjnl";
inline constexpr std::uint32_t schema = 4;  ///< of floes 2.0: arrays have their keys
inline constexpr std::uint64_t fixed_header_bytes = 24;
inline constexpr std::uint64_t record_head_bytes = 12;
inline constexpr std::uint64_t crc_bytes = 4;

/// Types are only added. A reader skips unknown ones.
enum class RecordType : std::uint32_t {
    session_begin = 2,
    session_end = 3,
    calibration = 4,
    attempt_started = 5,
    campaign = 6,
    member = 8,  ///< 7 was that of floes 1.0
    session_surroundings = 9,
    done_in_piece = 10,
    session_counts = 11  ///< of a session whose members were appended before it
};

/// A whole journal, of a schema that only a newer floes reads.
class NewerJournal : public InputError {
  public:
    using InputError::InputError;
};

std::uint32_t crc32c(std::span<const std::byte> bytes);
Bytes header(std::string_view text);
Bytes record(RecordType type, std::span<const std::byte> payload);

/// The member whose record is at `place`. Throws RunError if it is damaged.
MemberRecord read_member(const OpenFile& file, JournalContents::Place place);

/// The contents of a file open for reading, without its pieces. None if the file ends inside the header, or if a power
/// cut tore the header, of one of these texts then: its writer was stopped before it kept anything. Throws InputError
/// if the file is not a readable journal.
std::optional<JournalContents> read(const OpenFile& file, std::span<const std::string> texts = {});

/// Adds the members of the pieces beyond what was read of them. Throws as read() does.
void read_pieces(const std::filesystem::path& path, JournalContents& contents, const System& system = this_system());

/// Whether what follows the last whole record, read of the file at `path`, is the begin of a record only. A whole one
/// that is damaged is not.
bool tail_is_torn(const std::filesystem::path& path, const JournalContents& contents);

/// Where the whole records between two offsets of the file are.
std::vector<JournalContents::Place> records_between(const OpenFile& file, std::uint64_t from, std::uint64_t to);

}  // namespace floes::journal_format

namespace floes {

// The authoritative record of a campaign: an append-only file beside the campaign file, with a header (magic, schema
// version, resolved configuration) and records {length, type, payload, CRC32C}. Once sync() has returned, the records
// survive kill -9 of the program and loss of the machine. A torn tail is recognised and cut. In a large run other ranks
// than the master's append members to pieces, journals of their own beside it; who reads a journal reads its pieces.
//
//     Journal journal = open_journal(journal_path("a.h5"), campaign, Existing::resume);
//     journal.begin_session(describe_session(ranks, threads, {}));
//     journal.append(record);  …  journal.sync();
//     journal.end_session("complete");

/// What to do with an existing journal.
enum class Existing { refuse, replace, resume };

/// A journal open for writing, locked against a second writer during its lifetime.
class Journal {
  public:
    Journal(Journal&&) = default;
    /// Calls hand_over().
    ~Journal();

    /// Appends a record. It reaches the operating system with the next hand_over() and the disk with the next sync().
    void append(const MemberRecord& record);
    /// The same for a calibration; one that exists already is not added again.
    void append(const CalibrationRecord& record);
    /// Notes that the member's record is in a piece. Needs no sync(), because the piece is what is believed.
    void done_in_piece(const MemberIdentity& member);
    /// Takes in what was appended to pieces since the journal was opened or this was called, and syncs them: a writer
    /// that was lost may not have.
    void take_in_pieces();
    /// The same by what their writers have told, without reading them: the member's record is at `place` in a piece
    /// that is on the disk.
    void take_in(const MemberIdentity& member, const MemberNote& note, const JournalContents::Place& place);
    /// Notes earlier sessions that the campaign file knows and this journal, which is not the first, does not.
    void append(std::span<const Session> earlier);
    /// Notes that an attempt at the member begins. Needs no sync(): a lost note only costs one more attempt.
    void started(const MemberIdentity& member, int attempt);
    /// Passes everything appended so far to the operating system by one write(), so that it survives the end of this
    /// process.
    void hand_over();
    /// On return everything appended so far is on the disk. Throws RunError if the disk refuses, or if the file no
    /// longer exists under its name.
    void sync();
    /// Records the start of a session and, by the file that is written, how far the clock is off; and syncs.
    void begin_session(const Session& session);
    /// Records that the latest session has ended now, and syncs.
    void end_session(const std::string& outcome);

    /// All members. Their records are in the file alone, and can be read once they were handed over.
    StoredMembers members() const;
    /// As they are now, but torn_bytes: those of the tail that was cut off when the journal was opened. Attempts that
    /// were lost with earlier sessions are counted as lost().
    const JournalContents& contents() const { return contents_; }
    /// How the campaign has grown since the journal was last opened, see differences().
    const std::vector<std::string>& extension() const { return extension_; }
    /// That has the file.
    const System& system() const { return file_.system(); }

  private:
    friend Journal open_journal(const std::filesystem::path&, const std::string&, Existing, const System&,
                                const std::string&);
    friend Journal open_journal(const std::filesystem::path&, const Campaign&, Existing, const System&,
                                const std::string&);
    Journal(std::filesystem::path path, OpenFile file, JournalContents contents);
    void extend(const Campaign& there, const Campaign& here);
    void write_record(journal_format::RecordType type, std::span<const std::byte> payload);

    std::filesystem::path path_;
    OpenFile file_;
    JournalContents contents_;
    std::vector<std::string> extension_;
    Bytes appended_;  ///< not handed over yet: the last of contents_.good_bytes
};

/// `a.h5` -> `a.journal`, in the same folder.
std::filesystem::path journal_path(const std::filesystem::path& campaign_file);

/// `a.journal` -> `a.journal.2`: the piece of that number, from 1; of 0 the journal itself.
std::filesystem::path piece_path(const std::filesystem::path& journal, int number);

/// The numbers of the pieces that are there, in order.
std::vector<int> pieces_of(const std::filesystem::path& journal, const System& system = this_system());

/// Removes a journal and its pieces. What was in them must be on the disk elsewhere.
void remove_journal(const std::filesystem::path& path, const System& system = this_system());

/// Throws InputError, which names the keys that differ, unless `here` has all members of the campaign `there`, that the
/// file at `path` is of.
void expect_to_continue(const Campaign& there, const Campaign& here, const std::filesystem::path& path);

/// Opens for writing. refuse: throws InputError if the journal exists; replace: starts afresh; resume: keeps every
/// whole record, cuts a torn tail, and starts afresh if there is no journal. Throws InputError if another process is
/// writing this journal or a piece of it, if it has a newer schema, a damaged header or is not a journal; RunError if
/// the file system refuses.
/// `before`: what a journal that is made begins with where the campaign is there already, without a journal.
Journal open_journal(const std::filesystem::path& path, const std::string& campaign_text, Existing existing,
                     const System& system = this_system(), const std::string& before = {});

/// As above for a campaign. A campaign that has all members of the journal's campaign and more extends it. Resuming
/// with any other is refused (InputError), and the error names the keys that differ.
Journal open_journal(const std::filesystem::path& path, const Campaign& campaign, Existing existing,
                     const System& system = this_system(), const std::string& before = {});

/// Reads without locking or changing anything, also during a run. Throws as open_journal() does.
JournalContents read_journal(const std::filesystem::path& path, const System& system = this_system());

/// The members of a journal that was read from `path`; `contents` must outlive them.
StoredMembers stored_members(const JournalContents& contents, const std::filesystem::path& path,
                             const System& system = this_system());

/// The campaign that a journal belongs to. Throws InputError if this program does not accept its configuration.
Campaign read_stored_campaign(const JournalContents& contents, const std::filesystem::path& path);

/// True if a process has the journal open for writing (on file systems with locks).
bool is_being_written(const std::filesystem::path& path, const System& system = this_system());

}  // namespace floes
