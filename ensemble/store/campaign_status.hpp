#pragma once
// How far a campaign is: from its journal, also while a run is going on, or from its campaign file alone.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

struct CampaignStatus {
    std::string title;
    std::vector<CaseStatus> cases;
    std::vector<FailedMember> failures;  ///< in member order
    std::vector<Session> sessions;       ///< in order of time; of a campaign file alone, none
    bool at_work = false;                ///< a run writes the journal now, as far as the file system tells
    /// Wall time until the last member if the present run goes on as it does, s; none when nobody is at work or no
    /// member is done yet.
    std::optional<double> seconds_left;
};

/// Throws InputError when neither the campaign file nor its journal can be read.
CampaignStatus read_status(const std::filesystem::path& campaign_file);

}  // namespace floes
