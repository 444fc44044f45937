#pragma once
// What one attempt at a member may take, and sentences for an attempt that has no result to show. They depend on the
// member alone where they can: a reason stands in the campaign file.

#include <cstdint>
#include <string>

#include "campaign/run_rules.hpp"

namespace floes {

struct AttemptLimits {
    double deadline = 0;  ///< s of wall clock; 0: none
    std::uint64_t memory =
        0;              ///< bytes more than its process began with; 0: no limit. Kept only in a process of its own.
    double grace = 60;  ///< s that one who was asked to end, and looks at it every step, may still take
};

AttemptLimits limits_of(const RunRules& rules);

/// How the process of a member ended, as its helper saw it.
struct Ending {
    int wait_status = 0;            ///< of waitpid()
    bool at_deadline = false;       ///< the helper ended it for that reason
    std::uint64_t peak_memory = 0;  ///< largest resident set, bytes
};

/// "The process of the member was killed by SIGSEGV (Segmentation fault)."
std::string reason_of(const Ending& ending, const AttemptLimits& limits);

std::string deadline_reason(const AttemptLimits& limits);
std::string memory_reason(const AttemptLimits& limits);

}  // namespace floes
