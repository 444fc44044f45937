#pragma once
// Keeps the results of a campaign, and says when heartbeat and campaign file are written.

#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "campaign_file/filed_campaign.hpp"
#include "campaign_file/publish.hpp"
#include "run/inventory.hpp"
#include "run/messages.hpp"
#include "run/saved_members.hpp"
#include "run/writer.hpp"

namespace floes {

class UpkeepTimer {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `publish_every`: minimum time between two publications.
    UpkeepTimer(Time begin, std::chrono::seconds publish_every);

    /// Notes that the journal has a new result, not yet in the campaign file.
    void kept() { unpublished_ = true; }

    /// True at the beginning, then every 5 s.
    bool heartbeat_is_due(Time now) const { return now >= next_heartbeat_; }
    void heartbeat_written(Time now);

    /// True if the campaign file lacks a result and publishing is due.
    bool publishing_is_due(Time now) const { return unpublished_ && now >= next_publishing_; }
    /// Publishing is due now, with whatever there is.
    void publish_first(Time now);
    /// Publishing took from `begin` to `end`. The next one, also after a failure, is delayed so that publishing takes
    /// at most a twentieth of the time.
    void published(Time begin, Time end, bool success);

  private:
    std::chrono::seconds publish_every_;
    Time next_heartbeat_;
    Time next_publishing_;
    bool unpublished_ = false;
};

// Keeps the results of a campaign: in the journal at once, on the disk within a second, in the campaign file from time
// to time and at the end. Writes a heartbeat every few seconds.

class Recorder {
  public:
    using Time = std::chrono::steady_clock::time_point;

    struct Places {
        std::filesystem::path campaign_file;
        Existing existing = Existing::refuse;
        std::chrono::seconds publish_every{300};
        std::vector<CalibrationRecord> calibrations = {};  ///< that gave cases their Σ, stored with the members
        CampaignPart part = {};                            ///< what to compute; default: the whole campaign
        bool with_file = true;                             ///< publish; otherwise there are journals only
        std::filesystem::path metrics = {};    ///< file of metrics, replaced with every heartbeat; empty: none
        bool retry_failed = false;             ///< give members set aside before the full number of attempts again
        std::mutex* publishing = nullptr;      ///< held meanwhile where several runs of this process publish: HDF5 need
                                               ///< not be thread-safe
        const System& system = this_system();  ///< that has the files
        ContentWriter content = write_content;
        ContentReader filed = read_filed;
        bool keep_journal = true;  ///< also where the file has all members of the campaign
    };

    /// What the campaign file has, under the lock of `places`.
    static FiledCampaign filed(const Places& places);

    /// Throws InputError if the files exist and `existing` does not allow it.
    static void check(const Places& places);

    /// Whether a campaign that is to be resumed is published, every member done, and has no journal any more.
    static bool is_over(const Campaign& campaign, const Places& places);

    /// Opens the journal, gives it what only the campaign file has, and takes its inventory. `campaign` must outlive
    /// the recorder. Throws InputError as check() and take_inventory() do, and if the journal belongs to another
    /// campaign or another run is writing it.
    Recorder(const Campaign& campaign, Places places);

    const Tally& tally() const { return tally_; }
    const Journal& journal() const { return keeper_.journal(); }

    /// Notes that a session begins now. Returns what has changed since the previous session, see changed_software();
    /// empty if there are no earlier members.
    std::vector<std::string> begin(Session session);

    /// Notes that an attempt at the member begins, so that a later session can see if it never ended.
    void started(int number, int attempt);

    /// How far running members have come.
    void note(const std::vector<MemberProgress>& progress) { tally_.note(progress); }

    /// Keeps a result. It reaches the disk within a second.
    void keep(const MemberRecord& record);

    /// Notes a result that another writer keeps, in that piece of the journal.
    void kept_in_piece(const Kept& kept, int piece);

    /// On return, everything noted and kept so far survives the end of this process, whatever its cause.
    void hand_over() { keeper_.hand_over(); }

    /// To be called often: syncs the journal to the disk and publishes when due, with other writers not before the end;
    /// of a part under a stop rule it looks whether all parts meet it together. Returns a sentence if publishing or
    /// looking failed; nothing is lost then, because the journal has all results.
    std::string tend(Time now);

    /// Of a part: the stop rule with the members of all parts that lie beside it, once it is met.
    const std::optional<PrecisionStop>& together() const { return together_; }

    /// Syncs the journal to the disk now.
    void sync() { keeper_.sync(); }

    /// To be called when the other writers have closed their journals: takes in what they kept. With `lost_a_writer` it
    /// is read in their journals, not taken as they told it; returns the number of members of this session that are in
    /// no journal, since a writer was lost with its machine.
    int take_in_pieces(bool lost_a_writer);

    /// Ends the session as far as possible after an error. Otherwise the running members would count as lost with their
    /// process.
    void give_up() noexcept;

    /// Ends the session and publishes, if there is to be a file. Throws RunError if that fails. `together`: publishes
    /// by several ranks, or returns false where this one has to. Then removes the journal of a campaign that is whole
    /// in its file, unless it is to be kept.
    void finish(const std::string& outcome, const std::function<bool()>& together = {});

    const Places& places() const { return places_; }

  private:
    void publish_now();
    /// Every member of the campaign is done, and in the published file.
    bool is_whole_in_file() const;
    /// The other writers' journals are as long as they have told.
    bool has_all_pieces() const;
    void say_at_rest() const;  ///< to whoever watches: no heartbeat, and metrics of a run that has ended
    void write_metrics_now(Time now, bool at_work) const;
    void remove_saved_of_done(HalfWritten half_written) const;
    void look_at_other_parts();

    const Campaign& campaign_;
    Places places_;
    Keeper keeper_;
    Tally tally_;
    UpkeepTimer timer_;
    std::optional<PrecisionStop> together_;
    Time next_look_{};  ///< at other parts

    struct InPiece {
        int number = 0;
        MemberNote note;
        JournalContents::Place place;
    };
    std::deque<InPiece> in_pieces_;  ///< what other writers have told of in this session
};

}  // namespace floes
