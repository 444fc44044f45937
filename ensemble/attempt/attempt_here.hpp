#pragma once
// One attempt at a member in this process.

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "attempt/limits.hpp"
#include "attempt/member_function.hpp"

namespace floes {

/// How an attempt ended. No result: abandoned on request, to be done again another time.
struct Attempted {
    std::optional<MemberResult> result;
    std::uint64_t peak_memory = 0;  ///< of the process that computed it, bytes
};

/// A member that failed for `reason` and left nothing.
MemberResult failed_result(std::string reason);

/// The result itself when its statistics are numbers, or when it is a failed one. Throws MemberFailure else: a value
/// that is not a number must not pass for a measured one.
MemberResult checked(MemberResult result);

/// Computes the member. What it throws, and a deadline that passes, is a failed result with the reason; a stop that
/// comes before the result is none. The deadline is a stop of the member's own, which it is to look at. One that does
/// not for limits.grace after it cannot be ended in this process: `stuck` is then called, once, from another thread.
Attempted attempt_here(const MemberFunction& compute, const Campaign& campaign, int number, const AttemptLimits& limits,
                       std::stop_token stop, const std::function<void()>& stuck);

}  // namespace floes
