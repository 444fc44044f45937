#pragma once
// How far a campaign is: from its journal, also while a run is going on, or from its campaign file alone. A campaign
// that ended because its stop rule held ends with the arrangement that the rule stopped after: beyond it nothing is
// missing.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/stop_rule.hpp"
#include "driver/heartbeat.hpp"
#include "records/session.hpp"

namespace floes {

struct CaseStatus {
    std::string name;
    int done = 0;
    int failed = 0;
    int missing = 0;  ///< not computed yet
};

struct FailedMember {
    int number = 0;
    std::string case_name;
    int arrangement = 0;  ///< arrangement number
    std::string reason;
};

/// A member under way, or one that took long.
struct TimedMember {
    int number = 0;
    std::string case_name;
    int arrangement = 0;  ///< arrangement number
    int attempt = 1;
    double seconds = 0;
};

/// A campaign's stop rule and how near it is.
struct StopStatus {
    StopRule rule;
    bool met = false;
    int arrangements = 0;       ///< in a row from the first on that count; once met, those of the campaign
    int most_arrangements = 0;  ///< that would be run without the rule
    double achieved = 0;  ///< largest half-width over its mean, a part of 1; NaN before there are two values of each
};

struct CampaignStatus {
    std::string title;
    std::vector<CaseStatus> cases;
    std::vector<FailedMember> failures;  ///< in member order
    std::vector<Session> sessions;       ///< in order of time; of a campaign file alone, none
    std::optional<StopStatus> stop;      ///< none where there is no rule
    bool at_work = false;                ///< a run writes the journal now, as far as its lock or heartbeat tell
    std::optional<Heartbeat> heartbeat;  ///< of a run at work, or of one that did not end
    std::optional<double> rate;          ///< members finished a second in the present run
    std::vector<TimedMember> under_way;  ///< in the present run, longest first
    std::vector<TimedMember> slowest;    ///< of the done, at most five; of a campaign file alone, none
    /// Wall time until the last member if the present run goes on as it does, s; none when nobody is at work or no
    /// member is done yet.
    std::optional<double> seconds_left;
};

/// Throws InputError when neither the campaign file nor its journal can be read.
CampaignStatus read_status(const std::filesystem::path& campaign_file);

}  // namespace floes
