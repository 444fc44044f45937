#pragma once
// The front door of src/: one simulation from its scenario to its row of Table 3.
//
//   scenario, seed, arrangement number -> arrangement -> run -> statistics -> MemberResult
//
// A pure function of its first three arguments but for its times: any thread, any rank, any day, the same bits.

#include <cstdint>
#include <stdexcept>
#include <stop_token>

#include "member/result.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// The stop that was asked for came before the member's end. There is no result: the member is to be run again.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Runs the member. A run that leaves all sense gives status failed with the reason, NaN statistics, and the histories
/// and breaks up to then. Throws Interrupted when `stop` is requested before the end (looked at every step), and
/// InputError for a scenario that cannot be built or an arrangement that cannot be made.
MemberResult run_member(const Scenario& scenario, std::uint64_t seed, std::uint32_t arrangement,
                        std::stop_token stop = {});

}  // namespace floes
