#pragma once
// Keeps the results of a campaign: into the journal at once, onto the disk within a second, into the campaign file now
// and then and at the end; and tells others every few seconds that the run is alive.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "driver/tally.hpp"
#include "driver/upkeep_timer.hpp"
#include "journal/journal.hpp"

namespace floes {

class Recorder {
  public:
    using Time = std::chrono::steady_clock::time_point;

    struct Places {
        std::filesystem::path campaign_file;
        Existing existing = Existing::refuse;
        std::chrono::seconds publish_every{300};
        std::vector<CalibrationRecord> calibrations = {};  ///< that gave cases their Σ, to be kept beside the members
        Part part = {};             ///< what is to be computed; the whole campaign when not given
        bool retry_failed = false;  ///< give members that were set aside before as many attempts again
    };

    /// Throws InputError when there is something already and `existing` does not say what to do about it.
    static void check(const Places& places);

    /// Opens the journal and takes the inventory of it. `campaign` must outlive the recorder. Throws InputError as
    /// check() and take_inventory() do, when the journal is another campaign's, or when somebody writes it.
    Recorder(const Campaign& campaign, Places places);

    const Tally& tally() const { return tally_; }
    const Journal& journal() const { return journal_; }

    /// Notes that a session begins now. Returns what has changed since the session before it, see changed_software();
    /// empty when there are no members from before.
    std::vector<std::string> begin(Session session);

    /// Notes that an attempt at the member begins, so that a later session knows when it never ended.
    void started(int number, int attempt);

    /// Keeps a result. It may take a second until it is on the disk.
    void keep(const MemberRecord& record);

    /// What was noted and kept so far survives the end of this process, whatever ends it.
    void hand_over() { journal_.hand_over(); }

    /// To be called often: brings the journal to the disk and publishes when it is time. Returns a sentence when
    /// publishing did not succeed; nothing is lost then, the journal has it.
    std::string tend(Time now);

    /// Brings the journal to the disk now.
    void sync();

    /// Ends the session as far as that is possible after an error: without it the members under way would stand as
    /// attempts that took their process down.
    void give_up() noexcept;

    /// Ends the session and publishes. Throws RunError when that is impossible.
    void finish(const std::string& outcome);

  private:
    void publish_now();

    Places places_;
    Journal journal_;
    Tally tally_;
    UpkeepTimer timer_;
};

}  // namespace floes
