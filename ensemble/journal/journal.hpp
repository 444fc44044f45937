#pragma once
// The truth about a campaign under way: an append-only file beside the campaign file. A header (magic, schema version,
// resolved configuration) and records {length, type, payload, CRC32C}. A record that
// sync() has returned for survives kill -9 of the program and loss of the machine. A torn tail is recognised and cut.
// docs/campaign_file.md has the layout.
//
//     Journal journal = open_journal(journal_path("a.h5"), campaign, Existing::resume);
//     journal.begin_session(describe_session(ranks, threads, {}));
//     journal.append(record);  …  journal.sync();
//     journal.end_session("complete");

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "journal/journal_contents.hpp"
#include "records/file_calls.hpp"

namespace floes {

/// What to do about a journal that is already there.
enum class Existing { refuse, replace, resume };

/// A journal open for writing, locked against a second writer as long as the object lives.
class Journal {
  public:
    Journal(Journal&&) = default;
    /// Hands over what was appended.
    ~Journal();

    /// Adds a record. It is in the hands of the operating system after the next hand_over(), on the disk after the next
    /// sync().
    void append(const MemberRecord& record);
    /// Likewise what gave a case its Σ; one that is there already is not added again.
    void append(const CalibrationRecord& record);
    /// Notes that an attempt at the member begins. Not worth a sync(): a lost note costs one attempt more.
    void started(const MemberIdentity& member, int attempt);
    /// Everything appended so far is in the hands of the operating system on return, by one write(): it survives the
    /// end of this process.
    void hand_over();
    /// Everything appended so far is on the disk on return. Throws RunError when the disk refuses, or when the file is
    /// no longer there under its name.
    void sync();
    /// Records the start of a session, and syncs.
    void begin_session(const Session& session);
    /// Records that the session begun last has ended now, and syncs.
    void end_session(const std::string& outcome);

    /// All members, without their load histories.
    const std::vector<MemberRecord>& records() const { return contents_.members; }
    /// The load history of one of records() that was handed over, from the file. Throws RunError when it cannot be read
    /// back.
    PackedHistory history(const MemberRecord& record) const;
    const std::vector<Session>& sessions() const { return contents_.sessions; }
    const std::vector<CalibrationRecord>& calibrations() const { return contents_.calibrations; }
    /// Attempts that earlier sessions began and that were lost with them are lost() here.
    const AttemptBook& attempts() const { return contents_.attempts; }
    const std::string& campaign_text() const { return contents_.campaign_text; }
    /// In what the campaign has become larger since the journal was begun or opened last, see differences().
    const std::vector<std::string>& extension() const { return extension_; }
    /// Bytes inside the journal that are damaged and were passed over; what they held is computed again.
    std::uint64_t damaged_bytes() const { return contents_.damaged_bytes; }
    /// Bytes of torn tail that were cut off when the journal was opened.
    std::uint64_t cut_bytes() const { return contents_.torn_bytes; }

  private:
    friend Journal open_journal(const std::filesystem::path&, const std::string&, Existing);
    friend Journal open_journal(const std::filesystem::path&, const Campaign&, Existing);
    Journal(std::filesystem::path path, Descriptor file, JournalContents contents);
    void extend(const Campaign& there, const Campaign& here);
    void write_record(std::uint32_t type, std::span<const std::byte> payload);

    std::filesystem::path path_;
    Descriptor file_;
    JournalContents contents_;
    std::vector<std::string> extension_;
    Bytes appended_;  ///< and not handed over yet: the last of contents_.good_bytes
};

/// `a.h5` -> `a.journal`, in the same folder.
std::filesystem::path journal_path(const std::filesystem::path& campaign_file);

/// Opens for writing. refuse: throws InputError when a journal is there; replace: begins anew; resume: keeps every
/// whole record, cuts a torn tail, and begins anew when there is nothing yet. Throws InputError when another process
/// writes this journal, when it is of a newer schema or no journal at all, when its header is damaged; RunError when
/// the file system refuses.
Journal open_journal(const std::filesystem::path& path, const std::string& campaign_text, Existing existing);

/// As above for a campaign. One that has all members of the journal's and more extends it; resuming any other one is
/// refused (InputError) with the differing keys named.
Journal open_journal(const std::filesystem::path& path, const Campaign& campaign, Existing existing);

/// Reads without locking or changing anything, also while a run is going on. Throws as open_journal() does.
JournalContents read_journal(const std::filesystem::path& path, Histories histories = Histories::keep);

/// The campaign that a journal belongs to. Throws InputError when this program does not accept its configuration.
Campaign read_stored_campaign(const JournalContents& contents, const std::filesystem::path& path);

/// True when a process has the journal open for writing (where the file system knows locks).
bool is_being_written(const std::filesystem::path& path);

}  // namespace floes
