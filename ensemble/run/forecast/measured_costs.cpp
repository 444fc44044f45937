#include "forecast/measured_costs.hpp"

// Measured by
//
//     bench/dispatch.py build/release/bench/floes_dispatch dispatch.json
//
// on two cores of an otherwise idle virtual machine (Intel Xeon, family 6 model 207; Open MPI 4.1.4, HDF5 1.10.8):
// processor times, the smaller of two rounds. docs/scaling.md compares the resulting plan with real runs. Not measured
// but taken from experience: start_up_per_rank, publish, latency, transfer_per_byte, and the variation of members. Run
// times of members: configs/table3.toml, 94 s of processor time for three members, 234 s for one with the stock solver.
// Bytes: the 90 members of that campaign. Memory: what 200,001 members of tests/faults take more than 50,001, at
// most at any moment.

namespace floes {

DriverCosts measured_costs() {
    return {
        .start_up = 0.01,
        // Assumed, not measured: nodes launch their ranks in parallel, and the master greets them one after the other.
        // If two processors launch all ranks it is 0.12 s.
        .start_up_per_rank = 2e-3,
        .send = 0.4e-6,
        .assign = 2.1e-6,
        .receive = 1.5e-6,
        .answer = 6.2e-6,
        .own_member = 17e-6,
        .receive_per_byte = 0.24e-9,
        .keep_per_byte = 1.3e-9,
        .sync = 0.6e-3,
        .sync_interval = 0.9,  // this one and those for publishing as in driver/upkeep_timer.cpp
        .publish = 0.02,
        .publish_per_member = 12e-6,
        .publish_per_byte = 0.54e-9,
        .publish_interval = 300,
        .publish_share = 1.0 / 20,
        .memory_per_member = 290,
        .member = 24e-6,
        .member_per_byte = 21e-9,
        .report = 11e-6,
        .report_per_byte = 1.1e-9,
        .longest_held_back = 0.05,  // as in driver/silence.hpp; the next as in driver/worker.cpp
        .most_held_back = 256,
        .latency = 5e-6,  // between ranks of one machine
        .transfer_per_byte = 0.2e-9,
        .longest_pause = 10e-3,  // as in driver/pause.hpp
    };
}

MemberCosts measured_member_costs() {
    return {
        .lanes_per_unit = 1.6e-6,
        .stock_per_unit = 12e-6,
        .variation = 0.05,
        .history_bytes = 5.3,
        .file_per_record_byte = 0.5,
        .source = "the expected cost of each member, times the measured time per unit on a Xeon of 2023 (AVX-512)",
    };
}

}  // namespace floes
