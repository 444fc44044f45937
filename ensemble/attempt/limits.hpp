#pragma once
// What one attempt at a member may take.

#include <cstdint>

#include "campaign/run_rules.hpp"

namespace floes {

struct AttemptLimits {
    double deadline = 0;  ///< s of wall clock; 0: none
    std::uint64_t memory =
        0;              ///< bytes more than its process began with; 0: no limit. Kept only in a process of its own.
    double grace = 60;  ///< s that one who was asked to end, and looks at it every step, may still take
};

inline AttemptLimits limits_of(const RunRules& rules) {
    return {.deadline = rules.member_deadline, .memory = static_cast<std::uint64_t>(rules.member_memory)};
}

}  // namespace floes
