#pragma once
// How members are run: nothing that a result depends on. Not part of a campaign's fingerprint, so a resume may change
// it.

#include <cstdint>

namespace floes {

/// Where a member is computed: in the process that was given it, or in a process of its own.
enum class Isolation { none, process };

struct RunRules {
    Isolation isolation = Isolation::none;
    double member_deadline = 6 * 3600;            ///< s of wall clock for one attempt; 0: none
    double member_memory = 2048.0 * 1024 * 1024;  ///< bytes, for a member in a process of its own; 0: no limit
    int attempts = 2;                             ///< failed ones after which a member is set aside, >= 1
};

}  // namespace floes
