#pragma once
// The entry point of src/: one simulation from its scenario to its row of Table 3.
//
//   scenario, seed, arrangement number -> arrangement -> run -> statistics -> MemberResult
//
// Except for its times a pure function of its first three arguments: any thread, any rank, any day, the same bits.

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <stop_token>

#include "core/error.hpp"
#include "member/result.hpp"
#include "scenario/scenario.hpp"
#include "simulation/simulation.hpp"

namespace floes {

/// The member was stopped on request before its end. There is no result: the member is to be run again.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Processor time of the thread that calls, s.
double cpu_seconds_of_this_thread();

/// The state that a member was to go on from is not one of it. Without that state it can be run.
class SavedOtherwise : public RunError {
  public:
    using RunError::RunError;
};

/// Runs the member. If its state becomes meaningless, the status is failed, with the reason, NaN statistics, and the
/// histories and breaks up to then. Throws Interrupted if `stop` is requested before the end (checked every step), and
/// InputError for a scenario that cannot be built or an arrangement that cannot be made.
/// saved: Simulation::saved() of this member, from where it then goes on, with the bits of one that never stopped;
/// empty: from its start. Throws SavedOtherwise where it is not that.
MemberResult run_member(const Scenario& scenario, std::uint64_t seed, std::uint32_t arrangement,
                        std::stop_token stop = {}, const Watcher& watch = {}, std::span<const std::byte> saved = {});

}  // namespace floes
