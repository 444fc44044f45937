#pragma once
// How an attempt ended that has no result to show, as sentences. They depend on the member alone where they can: a
// reason stands in the campaign file.

#include <cstdint>
#include <string>

#include "attempt/limits.hpp"

namespace floes {

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
