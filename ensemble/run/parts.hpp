#pragma once
// The parts of a campaign, each computed by a run of its own, read as one campaign from their journals: also while they
// run. `floes merge` makes a file of them, status and a stop rule count them.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "inference/precision_stop.hpp"
#include "run/inventory.hpp"
#include "store/journal.hpp"
#include "store/member_record.hpp"
#include "store/system.hpp"

namespace floes {

/// What a part has of the members that it is for.
struct PartCount {
    int done = 0;
    int failed = 0;
    int missing = 0;
};

class Parts {
  public:
    struct Part {
        std::filesystem::path file;     ///< as given
        std::filesystem::path journal;  ///< beside it
        JournalContents contents;
        Campaign campaign;
    };

    /// Records that follow each other in a journal or a piece of it, of one session or of none.
    struct Block {
        std::size_t part = 0;
        int piece = 0;  ///< as in JournalContents::Place
        std::uint64_t from = 0;
        std::uint64_t to = 0;
    };

    /// Reads the journals beside `files`. With `merged_before` the first file is what earlier ones were merged into.
    /// Throws InputError if one cannot be read, or if they belong to different campaigns, naming the keys that differ;
    /// a campaign may have grown from one part to the next.
    explicit Parts(std::span<const std::filesystem::path> files, bool merged_before = false);

    const std::vector<Part>& all() const { return parts_; }
    /// The largest of the parts' campaigns, or as many of its arrangements as its stop rule wants.
    const Campaign& campaign() const { return published_; }
    /// That of the journal, whatever the stop rule says.
    const Campaign& whole_campaign() const { return parts_[largest_].campaign; }
    /// The stop rule with all members; none if the campaign has none.
    const std::optional<PrecisionStop>& rule() const { return rule_; }
    /// All records; of a member that several parts have, the first part's comes first.
    StoredMembers members() const {
        return {notes_, [this](std::size_t k) { return read(k); }};
    }
    const MemberNotes& notes() const { return notes_; }
    /// By member of campaign(), as match_records() gives them.
    const std::vector<std::optional<std::size_t>>& matched() const { return matched_; }
    /// Each block once, first those of no session: the members in pieces, which a session counts by its notes, and what
    /// is before the first session. A member that came before, and a session that is a copy or the beginning of a
    /// longer one, are left out.
    const std::vector<Block>& blocks() const { return blocks_; }
    /// Those of the blocks, in the order of the parts.
    std::vector<Session> sessions() const;
    std::vector<CalibrationRecord> calibrations() const;

    /// What one part is for, by its sessions; the whole campaign if they do not say, or were merged.
    CampaignPart place_of(std::size_t part) const;
    PartCount count(std::size_t part) const;

    /// Sentences on what is told apart from the rest: members that two files have, whether their results are the same;
    /// another build; a smaller campaign; a clock that was off; parts that are not complete.
    std::vector<std::string> remarks() const;
    /// The sentence on parts of which no file was given; empty if all were, or if there are none.
    std::string missing_parts() const;
    /// The sentence on members that no part has; empty if there are none.
    std::string missing_members() const;

  private:
    struct Place {
        std::size_t part = 0;
        std::size_t record = 0;  ///< of its contents
    };

    void check_campaigns();
    void apply_rule();
    void gather_loose();
    void gather_sessions();
    bool is_loose(const Place& place) const;
    bool begins_with(const Block& longer, const Block& shorter) const;
    void add_twins(std::vector<std::string>& sentences) const;
    void add_builds(std::vector<std::string>& sentences) const;
    void add_clocks(std::vector<std::string>& sentences) const;
    void add_unfinished(std::vector<std::string>& sentences) const;
    MemberRecord read(std::size_t record) const;

    std::vector<Part> parts_;
    bool merged_before_;
    std::size_t largest_ = 0;
    MemberNotes notes_;
    std::deque<Place> places_;  ///< by record
    std::vector<Block> blocks_;
    std::optional<PrecisionStop> rule_;
    Campaign published_;
    std::vector<std::optional<std::size_t>> matched_;
    mutable OpenFile latest_;  ///< that a record was read from: opening costs a network file system more than reading
};

/// Whether a run writes the journal: by its lock, or where a lock cannot be seen by a fresh heartbeat.
bool is_at_work(const std::filesystem::path& journal);

/// Where the other parts lie of which `file` is part K of N, if it is named as they are: NAME.partK.h5. Those of which
/// there is a journal.
std::vector<std::filesystem::path> other_parts(const std::filesystem::path& file, const CampaignPart& part);

// Merges parts, each computed by a separate run with --part, into one campaign.

/// Makes the campaign file and its journal from everything in the journals beside `parts`, of one whole campaign
/// without a journal from its file, and from what `output` has already: a merge takes what is new. Parts may be
/// unfinished, still running, or overlapping. The file equals that of an undisturbed run of the same members, which a
/// stop rule ends. Returns what was read. `overwrite`: what `output` has is replaced. Throws InputError if a part
/// cannot be read, if parts or output belong to different campaigns (naming the keys that differ), or if the output is
/// one of the parts or is being written.
Parts merge_campaigns(std::span<const std::filesystem::path> parts, const std::filesystem::path& output,
                      bool overwrite);

}  // namespace floes
