#pragma once
// The identity of campaigns and cases: digests that are equal exactly when the members are, and what differs otherwise.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/design.hpp"
#include "keys/key.hpp"

namespace floes {

/// 32 hex digits: equal exactly when every member of the two campaigns is the same and they have the same members.
std::string fingerprint(const Campaign& campaign);

/// 32 hex digits of one case's physics (scenario and seed, not its name or the number of arrangements): what a stored
/// member of it is valid for.
std::string case_fingerprint(const Campaign& campaign, int case_index);

/// True if every member of `part` is one of `whole`. Names and order of cases do not matter.
bool is_part_of(const Campaign& part, const Campaign& whole);

/// One line a differing key: "general.iterations: 50 there, 20 here". Empty when equal.
std::vector<std::string> differences(const Campaign& there, const Campaign& here);

// Which keys of a text have an effect. One that is set and has none would be taken for one that has.

class KeyEffects {
  public:
    /// Notes the keys that are given (`origins` tells where) and have an effect in the case that `keys` are bound to,
    /// and those that have none though they are set to an unusual value.
    void note(const Keys& keys, const Origins& origins);

    /// Throws InputError for a key without effect in any case.
    void refuse_without() const;

  private:
    std::map<std::string, std::pair<std::string, std::string>> idle_;  ///< by path: where and what, what it needs
    std::set<std::string> effective_;
};

}  // namespace floes
