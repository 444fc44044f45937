#pragma once
// Which keys of a text have an effect. One that is set and has none would be taken for one that has.

#include <map>
#include <set>
#include <string>
#include <utility>

#include "campaign/read_design.hpp"
#include "keys/key.hpp"

namespace floes {

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
