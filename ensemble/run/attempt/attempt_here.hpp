#pragma once
// One attempt at a member in this process.

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "attempt/limits.hpp"
#include "attempt/member_function.hpp"

namespace floes {

/// How an attempt ended. No result: abandoned on request, to be run again later.
struct Attempted {
    std::optional<MemberResult> result;
    std::uint64_t peak_memory = 0;  ///< of the process that computed it, bytes
};

/// The result of a member that failed for `reason`.
MemberResult failed_result(std::string reason);

/// Returns the result if it is a failed one or if its statistics are numbers. Throws MemberFailure otherwise: NaN must
/// not pass as a measured value.
MemberResult checked(MemberResult result);

/// Computes the member. An exception or a missed deadline gives a failed result with the reason; a stop before the
/// result gives none. The deadline requests a stop that the member must poll. A member that still runs limits.grace
/// after it cannot be ended in this process: `stuck` is then called, once, from another thread.
Attempted attempt_here(const MemberFunction& compute, const Campaign& campaign, int number, const AttemptLimits& limits,
                       std::stop_token stop, const std::function<void()>& stuck);

}  // namespace floes
