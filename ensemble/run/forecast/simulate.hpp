#pragma once
// A run in simulated time: the real Scheduler gets the events of a real run, at times that follow from the members and
// the measured costs of the driver. Deterministic: the same members, machine and costs give the same forecast to the
// last bit.
//
//     const Forecast forecast = simulate(members, machine_of(1000, 16), measured_costs());

#include <span>
#include <vector>

#include "forecast/measured_costs.hpp"

namespace floes {

/// A member as the driver sees it.
struct SimulatedMember {
    double run_time = 0;       ///< s, >= 0
    double expected_cost = 1;  ///< used by the scheduler, any unit, > 0
    double record_bytes = 0;   ///< in a message and in the journal
    double file_bytes = 0;     ///< in the campaign file
    double packed_bytes = 0;   ///< part of the record: histories that the rank has to pack
};

struct Machine {
    std::vector<int> cores_of_rank;  ///< at least one rank; each at least one core
    /// Processors shared by all ranks if there are too few for all; members then sleep instead of computing. 0: every
    /// thread has its own processor.
    int processors = 0;
};

/// `cores` spread evenly over `ranks`. Throws InputError unless 1 <= ranks <= cores.
Machine machine_of(int cores, int ranks);

struct Forecast {
    double wall_time = 0;      ///< s, from the start of the program to its end
    double start_up = 0;       ///< s of it before the first member
    double last_member = 0;    ///< s from the start until the last answer is in the journal
    double run_time = 0;       ///< s, of all members together
    double efficiency = 0;     ///< run_time / (cores x wall_time)
    double master_load = 0;    ///< fraction of the time from start-up to the last answer in which the master works
    double journal_bytes = 0;  ///< of all records
    double file_bytes = 0;
};

Forecast simulate(std::span<const SimulatedMember> members, const Machine& machine, const DriverCosts& costs);

}  // namespace floes
