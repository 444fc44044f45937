#pragma once
// Status of a campaign: from its journal, also during a run, or from its campaign file alone. A campaign that was ended
// by its stop rule consists of the arrangements up to that point; nothing after them is missing.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/campaign_table.hpp"
#include "run/progress.hpp"
#include "store/session.hpp"

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

/// A running member, or a slow one.
struct TimedMember {
    int number = 0;
    std::string case_name;
    int arrangement = 0;  ///< arrangement number
    int attempt = 1;
    double seconds = 0;
    double time = 0;  ///< simulated, s
    double end = 0;   ///< of its simulation, s; 0: not known
};

/// A campaign's stop rule and how close the campaign is to its target.
struct StopStatus {
    StopRule rule;
    bool met = false;
    int arrangements = 0;       ///< complete ones in index order; once met, those of the campaign
    int most_arrangements = 0;  ///< number without the rule
    int minimum = 0;            ///< arrangements before which the rule is not applied
    double achieved = 0;  ///< largest half-width over its mean, a fraction; NaN before there are two values of each
    std::string obstacle = {};  ///< why it is NaN, without a full stop; empty if that is plain
};

/// Of several parts that were given.
struct PartsAtWork {
    int parts = 0;
    int running = 0;
    int threads = 0;  ///< of these
    int hosts = 0;    ///< that these run on
};

struct CampaignStatus {
    std::string title;
    std::vector<CaseStatus> cases;
    std::vector<FailedMember> failures;  ///< in member order
    std::vector<Session> sessions;       ///< in order of time
    std::optional<StopStatus> stop;      ///< empty if there is no rule
    std::vector<std::string> remarks;    ///< sentences on what is told apart from the rest, as Parts has them
    std::optional<PartsAtWork> parts;    ///< empty: of one file
    bool at_work = false;                ///< a run is writing the journal now, judged by its lock or heartbeat
    std::optional<Heartbeat> heartbeat;  ///< of an active run, or of one that did not end properly
    std::optional<double> rate;          ///< members finished per second in the present run
    std::vector<TimedMember> under_way;  ///< in the present run, longest first
    std::vector<TimedMember> slowest;    ///< of the done members, at most five
    /// Wall time until the last member at the present rate, s; empty if no run is active or no member is done yet.
    std::optional<double> seconds_left;
};

/// A status with the results that there are so far.
struct CampaignSnapshot {
    CampaignStatus status;
    Campaign campaign;    ///< as its stop rule wants it
    CampaignTable table;  ///< of its members
};

/// Of one campaign file, or of several parts together. Throws InputError when neither the campaign file nor its journal
/// can be read, of several a journal, or as Parts does.
CampaignSnapshot read_snapshot(std::span<const std::filesystem::path> campaign_files);
inline CampaignSnapshot read_snapshot(const std::filesystem::path& campaign_file) {
    return read_snapshot(std::span(&campaign_file, 1));
}

/// The same without the results.
CampaignStatus read_status(std::span<const std::filesystem::path> campaign_files);
inline CampaignStatus read_status(const std::filesystem::path& campaign_file) {
    return read_status(std::span(&campaign_file, 1));
}

// A campaign's status in sentences, the same on a terminal and on a page.

/// All cases together.
CaseStatus total_of(const CampaignStatus& status);

int members_of(const CaseStatus& one);

/// "smoke: 5 of 12 members done, 0 failed, 7 to do".
std::string counts_sentence(const CampaignStatus& status);

/// What runs, or how it ended and what to type if anything is left; empty if there is nothing to say.
std::string work_sentence(const CampaignStatus& status);

/// How close the campaign is to the precision that ends it.
std::string stop_sentence(const StopStatus& stop);

/// "12 min", and where it is known how far the member has come: ", at 43 % (86 of 200 s)".
std::string time_words(const TimedMember& one);

/// "mean_load of every case", "mean_load of E200 - E60".
std::string what_of(const StopRule& rule);

}  // namespace floes
