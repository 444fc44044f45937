#pragma once
// What is done in a campaign and what is still to do, computed from the notes of its journal. No clock, and records are
// read for a stop rule only.

#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "inference/precision_stop.hpp"
#include "records/attempt_book.hpp"
#include "records/stored_members.hpp"
#include "schedule/events.hpp"

namespace floes {

/// Some of a campaign's arrangements, for independent runs: those whose number modulo `of` is `number` - 1. Cases that
/// share an arrangement stay together.
struct CampaignPart {
    int number = 1;  ///< 1 … of
    int of = 1;
    bool has(int arrangement) const { return arrangement % of == number - 1; }
};

/// The campaign's stop rule before any member. Empty if there is no rule, and for a part, which has no consecutive
/// arrangements and is run in full. Throws InputError as PrecisionStop does.
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

/// The fingerprint of each case.
std::vector<std::string> case_fingerprints(const Campaign& campaign);

/// Passes a member that is done or set aside to the stop rule, if there is one.
void tell(std::optional<PrecisionStop>& rule, const MemberKey& member, const MemberRecord& record);

}  // namespace floes
