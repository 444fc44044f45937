#pragma once
// What is done in a campaign and what is still to do, computed from the notes of its journal. No clock, and records are
// read for a stop rule only.

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/campaign_table.hpp"
#include "inference/precision_stop.hpp"
#include "run/attempt.hpp"
#include "run/progress.hpp"
#include "run/scheduler.hpp"
#include "store/member_record.hpp"
#include "store/session.hpp"

namespace floes {

/// Some of a campaign's arrangements, for independent runs: those whose number modulo `of` is `number` - 1. Cases that
/// share an arrangement stay together.
struct CampaignPart {
    int number = 1;  ///< 1 … of
    int of = 1;
    bool has(int arrangement) const { return arrangement % of == number - 1; }
};

/// The campaign's stop rule before any member. Empty if there is no rule, and for a part, which has no consecutive
/// arrangements: all parts meet it together (Recorder::together). Throws InputError as PrecisionStop does.
std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign, const CampaignPart& part);

struct Inventory {
    /// Members without a result, and failed ones with attempts of campaign.run left; none if the stop rule is met. A
    /// member is suspect if an attempt was started but neither answered nor closed by the end of its session: the
    /// process was lost, and this member may be the cause.
    std::vector<MemberTask> tasks;
    double tasks_cost = 0;       ///< their expected cost
    int total = 0;               ///< members of the part, and others with a result
    int done = 0;                ///< members with a result
    std::vector<int> set_aside;  ///< arrangement of each member without attempts left
    int retried = 0;             ///< tasks that failed or were lost before
    /// Seconds per unit of expected cost in the slowest member that has a result; 0 if there is none.
    double pace = 0;
    /// The stop rule with all members that are done or set aside.
    std::optional<PrecisionStop> precision;

    int reused() const { return done + static_cast<int>(set_aside.size()); }
    bool precise() const { return precision && precision->met(); }
};

/// `members` and `attempts`: of the campaign's journal, with no member running. `retry_failed` gives members that were
/// set aside the full number of attempts again. Throws InputError as stop_rule_of() does.
Inventory take_inventory(const Campaign& campaign, const StoredMembers& members, const AttemptBook& attempts,
                         const CampaignPart& part = {}, bool retry_failed = false);

/// Passes a member that is done or set aside to the stop rule, if there is one.
void tell(std::optional<PrecisionStop>& rule, const MemberKey& member, const MemberRecord& record);

// Progress of a run: what existed when its session began, and what the session added. No file, no clock.

class Tally {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `campaign` must outlive the tally. `begin`: of the session.
    Tally(const Campaign& campaign, Inventory found, Time begin);

    /// An attempt at the member begins.
    void started(int number, int attempt, Time now) { under_way_[identity_of(number)] = {number, attempt, now}; }
    /// How far members have come that are under way.
    void note(const std::vector<MemberProgress>& progress);
    /// A member is done or set aside.
    void kept(const MemberRecord& record);
    /// The same without its record, which only a stop rule needs.
    void kept(const MemberIdentity& member, MemberStatus status, const MemberRecord* record);

    /// What existed when the session began.
    const Inventory& found() const { return found_; }
    int computed() const { return computed_; }                             ///< members done in this session
    int set_aside() const { return static_cast<int>(set_aside_.size()); }  ///< members set aside in this session
    int done() const { return found_.done + computed_; }                   ///< of this session and before
    int running() const { return static_cast<int>(under_way_.size()); }
    int failed() const;  ///< members of published() that are set aside, in this session and before

    /// The campaign's stop rule with the members known so far; empty if there is no rule.
    const std::optional<PrecisionStop>& precision() const { return precision_; }
    /// The stop rule is met: no more members are needed, and the published campaign ends with the arrangement at which
    /// the rule stopped.
    bool precise() const { return precision_ && precision_->met(); }
    /// The campaign as published.
    Campaign published() const;

    /// The member's identity in the journal.
    MemberIdentity identity_of(int number) const;
    /// The heartbeat without host, process and time.
    Heartbeat heartbeat(Time now) const;
    /// Some of the members under way that have told how far they are and have run for more than some minutes, longest
    /// first.
    std::vector<Heartbeat::UnderWay> longest(Time now) const;

  private:
    struct UnderWay {
        int number = 0;
        int attempt = 1;
        Time since{};
        double time = 0, end = 0;  // s simulated, and in all
    };

    const Campaign& campaign_;
    std::vector<std::string> case_keys_;
    Inventory found_;
    std::optional<PrecisionStop> precision_;
    Time begin_;
    std::map<MemberIdentity, UnderWay> under_way_;
    int computed_ = 0;
    std::vector<int> set_aside_;  // arrangement of each
    double finished_cost_ = 0;    // expected, of both
};

// A campaign's stop rule, applied to its members.

/// The rule before any member; empty if the campaign has no rule. Throws InputError as PrecisionStop does.
std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign);

/// The rule with every done and every failed member of `table`, which belongs to the campaign.
std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign, const CampaignTable& table);

}  // namespace floes
