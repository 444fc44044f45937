#pragma once
// The entry point of src/: one simulation from its scenario to its row of Table 3.
//
//   scenario, seed, arrangement number -> arrangement -> run -> statistics -> MemberResult
//
// Except for its times a pure function of its first three arguments: any thread, any rank, any day, the same bits.

#include <cstdint>
#include <stdexcept>
#include <stop_token>

#include "member/result.hpp"
#include "scenario/scenario.hpp"
#include "simulation/simulation.hpp"

namespace floes {

/// The member was stopped on request before its end. There is no result: the member is to be run again.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Runs the member. If its state becomes meaningless, the status is failed, with the reason, NaN statistics, and the
/// histories and breaks up to then. Throws Interrupted if `stop` is requested before the end (checked every step), and
/// InputError for a scenario that cannot be built or an arrangement that cannot be made.
MemberResult run_member(const Scenario& scenario, std::uint64_t seed, std::uint32_t arrangement,
                        std::stop_token stop = {}, const Watcher& watch = {});

}  // namespace floes
