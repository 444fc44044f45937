#pragma once
// Keeps the results of a campaign: into the journal at once, onto the disk within a second, into the campaign file now
// and then and at the end; and tells others every few seconds that the run is alive.

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "inference/precision_stop.hpp"
#include "journal/journal.hpp"
#include "schedule/events.hpp"

namespace floes {

/// Some of a campaign's arrangements, for runs that know nothing of one another: those whose number leaves number - 1
/// when divided by `of`. Cases that share an arrangement stay together.
struct Part {
    int number = 1;  ///< 1 … of
    int of = 1;
    bool has(int arrangement) const { return arrangement % of == number - 1; }
};

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

    /// Opens the journal. `campaign` must outlive the recorder. Throws InputError as check()
    /// does, when the journal is another campaign's, or when somebody writes it.
    Recorder(const Campaign& campaign, Places places);

    /// What is still to be computed: members without a result, and failed ones with attempts of campaign.run left. An
    /// attempt that was started() and neither answered nor ended by the end of its session makes a suspect of its
    /// member: it, or one beside it, or nobody, took the process down.
    std::vector<MemberTask> tasks() const { return tasks_; }
    int total() const { return total_; }  ///< members of the part, and others that the journal has
    /// Seconds that a unit of expected cost took in the slowest member that has a result; 0 when there is none.
    double pace() const { return pace_; }
    int done() const { return done_; }      ///< members with a result, of this session and before
    int failed() const;                     ///< members set aside as failed, likewise; of published() alone
    int reused() const { return reused_; }  ///< of both, those from before
    bool resumed() const { return journal_.sessions().size() > 1; }  ///< of begin() on: there was a session before
    /// Of the tasks, those that failed or were lost before; of members, those set aside in this session.
    int retried() const { return retried_; }
    int set_aside() const { return set_aside_; }
    int computed() const { return computed_; }  ///< members done in this session

    /// The campaign's stop rule on the members known so far; none where there is no rule.
    const std::optional<PrecisionStop>& precision() const { return precision_; }
    /// The rule holds: no more members are wanted, and what is published ends with the arrangement it stopped after.
    bool precise() const { return precision_ && precision_->met(); }
    /// The campaign that is published.
    Campaign published() const;

    /// In what the campaign has grown since the sessions before, one line a key; empty when it has not.
    const std::vector<std::string>& extension() const { return journal_.extension(); }

    /// Bytes of the journal that the disk has damaged; their members are among the tasks.
    std::uint64_t damaged_bytes() const { return journal_.damaged_bytes(); }

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
    struct UnderWay {
        int number = 0;
        int attempt = 1;
        Time since{};
    };

    void take_stock();
    void tell(Time now) const;
    MemberIdentity identity_of(int number) const;
    void tell_precision(int arrangement, int case_index, const MemberResult* result);
    void publish_now();

    const Campaign& campaign_;
    Places places_;
    std::vector<std::string> case_keys_;
    std::optional<PrecisionStop> precision_;
    Journal journal_;
    std::vector<MemberTask> tasks_;
    int total_ = 0;
    std::map<MemberIdentity, UnderWay> under_way_;
    int finished_ = 0;
    double finished_cost_ = 0;
    double tasks_cost_ = 0;
    double pace_ = 0;
    int done_ = 0;
    std::vector<int> failed_;  ///< arrangement of each member set aside
    int reused_ = 0;
    int retried_ = 0;
    int set_aside_ = 0;
    int computed_ = 0;
    bool synced_ = true;
    bool published_ = true;
    Time begin_ = std::chrono::steady_clock::now();
    Time next_heartbeat_ = begin_;
    Time last_sync_ = std::chrono::steady_clock::now();
    Time next_publish_;
};

}  // namespace floes
