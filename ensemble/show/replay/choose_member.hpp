#pragma once
// Which member of a campaign file is to be replayed, and from when to when.

#include <filesystem>
#include <optional>
#include <string>

#include "campaign_file/campaign_table.hpp"
#include "replay/replay_member.hpp"

namespace floes {

/// How a member may be named. `worst`: the one with the largest load of those that the others leave.
struct MemberChoice {
    std::optional<int> number = {};
    std::string case_name = {};  ///< empty: any
    std::optional<int> arrangement = {};
    bool worst = false;

    bool given() const { return number || !case_name.empty() || arrangement || worst; }
};

/// Throws InputError when no member, or more than one, is meant.
int chosen_member(const CampaignTable& table, const MemberChoice& choice);

/// Which times of a run are wanted, s; what is not given is the whole run or, of the worst moment, the 20 s round it.
struct TimeChoice {
    bool worst = false;
    std::optional<double> from = {};
    std::optional<double> to = {};
    std::optional<double> every = {};  ///< not given: 0.1 s, over more than a minute 0.25 s

    bool given() const { return worst || from || to || every; }
};

/// Throws InputError for the worst moment of a member whose load history the file does not keep.
FrameTimes chosen_times(const ReplaySubject& subject, const TimeChoice& choice);

}  // namespace floes
