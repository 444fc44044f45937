#pragma once
// What of a campaign is done and what is still to do, computed from the records of its journal. No file, no clock.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "inference/precision_stop.hpp"
#include "records/attempt_book.hpp"
#include "records/member_record.hpp"
#include "schedule/events.hpp"

namespace floes {

/// Some of a campaign's arrangements, for runs that know nothing of one another: those whose number leaves number - 1
/// when divided by `of`. Cases that share an arrangement stay together.
struct Part {
    int number = 1;  ///< 1 … of
    int of = 1;
    bool has(int arrangement) const { return arrangement % of == number - 1; }
};

/// The campaign's stop rule without any member; none where there is no rule, nor for a part, which has no arrangements
/// in a row and is run whole. Throws InputError as PrecisionStop does.
std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign, const Part& part);

struct Inventory {
    /// Members without a result, and failed ones with attempts of campaign.run left; none when the stop rule holds. An
    /// attempt that was started and neither answered nor ended by the end of its session makes a suspect of its member:
    /// it, or one beside it, or nobody, took the process down.
    std::vector<MemberTask> tasks;
    double tasks_cost = 0;       ///< their expected cost
    int total = 0;               ///< members of the part, and others that have a result
    int done = 0;                ///< members with a result
    std::vector<int> set_aside;  ///< arrangement of each member without attempts left
    int retried = 0;             ///< of the tasks, those that failed or were lost before
    /// Seconds that a unit of expected cost took in the slowest member that has a result; 0 when there is none.
    double pace = 0;
    /// The stop rule, told of all members that are done or set aside.
    std::optional<PrecisionStop> precision;

    int reused() const { return done + static_cast<int>(set_aside.size()); }
    bool precise() const { return precision && precision->met(); }
};

/// `records` and `attempts`: of the campaign's journal, nothing being under way. `retry_failed` gives members that were
/// set aside as many attempts again. Throws InputError as stop_rule_of() does.
Inventory take_inventory(const Campaign& campaign, std::span<const MemberRecord> records, const AttemptBook& attempts,
                         const Part& part = {}, bool retry_failed = false);

/// The fingerprint of each case.
std::vector<std::string> case_fingerprints(const Campaign& campaign);

/// Tells the stop rule, where there is one, of a member that is done or set aside.
void tell(std::optional<PrecisionStop>& rule, const Campaign& campaign, const MemberKey& member,
          const MemberResult& result);

}  // namespace floes
