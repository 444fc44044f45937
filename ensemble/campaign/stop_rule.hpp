#pragma once
// Which cases the stop rule names.

#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "core/error.hpp"

namespace floes {

/// Two cases, by index, of which the difference is of - minus.
struct StopPair {
    int of = 0;
    int minus = 0;
};

/// The case that stop.case names; none where it is "all" or "none". Throws InputError for a name that no case has.
std::optional<int> stop_case(const StopRule& rule, const std::vector<std::string>& cases);

/// The cases that stop.contrast names; none where it is "all" or "none". `groups`: a number for each case, equal for
/// cases that share arrangements (sharing_groups()); empty: all share them. Throws InputError for what is no contrast,
/// names that no case has, cases that cannot be paired, and an active rule that names nothing at all.
std::optional<StopPair> stop_pair(const StopRule& rule, const std::vector<std::string>& cases,
                                  const std::vector<int>& groups);

/// For cases of which `which` do not share their arrangements.
InputError no_stop_pair(const StopRule& rule, const std::string& which);

struct StopFault {
    std::string key;       ///< that says so
    std::string sentence;  ///< without a full stop
};

/// What is wrong with the cases that the rule of a campaign names: what stop_case() and stop_pair() refuse, and a
/// difference that is 0 in every arrangement, which would be precise at once.
std::optional<StopFault> stop_case_fault(const Campaign& campaign);

}  // namespace floes
