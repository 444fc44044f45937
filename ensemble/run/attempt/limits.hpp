#pragma once
// Limits of one attempt at a member, and reasons for attempts without a result. If possible, a reason depends on the
// member alone, because it is stored in the campaign file.

#include <cstdint>
#include <string>

#include "campaign/rules.hpp"

namespace floes {

struct AttemptLimits {
    double deadline = 0;  ///< s of wall clock; 0: none
    std::uint64_t memory =
        0;              ///< bytes beyond those at process start; 0: no limit. Enforced only in isolated processes.
    double grace = 60;  ///< s in which a member that polls every step must react to a stop
};

AttemptLimits limits_of(const RunRules& rules);

/// How the process of a member ended, as seen by its helper.
struct Ending {
    int wait_status = 0;            ///< of waitpid()
    bool at_deadline = false;       ///< the helper killed it at its deadline
    std::uint64_t peak_memory = 0;  ///< largest resident set, bytes
};

/// "The process of the member was killed by SIGSEGV (Segmentation fault)."
std::string reason_of(const Ending& ending, const AttemptLimits& limits);

std::string deadline_reason(const AttemptLimits& limits);
std::string memory_reason(const AttemptLimits& limits);

}  // namespace floes
