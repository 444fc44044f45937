// Measured by
//
//     bench/dispatch.py build/bench/bench/floes_dispatch dispatch.json
//
// on two cores of a virtual machine (Intel Xeon, family 6 model 207; Open MPI 4.1.4, HDF5 1.10.8) that was busy with
// other work: processor times, the least of two rounds. On the same machine idle the plan made of them agrees with real
// runs within 20 % (docs/scaling.md). Not measured but taken from experience: start_up_per_rank, publish, latency,
// transfer_per_byte, and the variation of members. The run times of members: configs/table3.toml, three members, 181 s
// of processor time; the stock solver by the ratio in docs/performance.md.

#include "forecast/driver_costs.hpp"
#include "forecast/member_costs.hpp"

namespace floes {

DriverCosts measured_costs() {
    return {
        .start_up = 0.02,
        // Not measured but assumed: nodes launch their ranks side by side, and the master greets one after the other.
        // Where two processors launch them all it is 0.12 s.
        .start_up_per_rank = 2e-3,
        .send = 0.43e-6,
        .assign = 2e-6,
        .receive = 2.7e-6,
        .answer = 6e-6,
        .own_member = 54e-6,
        .receive_per_byte = 0,  // lost in the scatter of keep_per_byte
        .keep_per_byte = 1.6e-9,
        .sync = 2.1e-3,
        .sync_interval = 0.9,  // this one and those for publishing as in driver/recorder.cpp
        .publish = 0.02,
        .publish_per_member = 16e-6,
        .publish_per_byte = 0.9e-9,
        .publish_interval = 300,
        .publish_share = 1.0 / 20,
        .member = 120e-6,
        .member_per_byte = 25e-9,
        .report = 30e-6,
        .report_per_byte = 1e-9,
        .longest_held_back = 0.05,  // as in driver/silence.hpp; the next as in driver/worker.cpp
        .most_held_back = 256,
        .latency = 5e-6,  // between ranks of one machine
        .transfer_per_byte = 0.2e-9,
        .longest_pause = 10e-3,  // as in driver/pause.hpp
    };
}

MemberCosts measured_member_costs() {
    return {
        .lanes_per_unit = 3.1e-6,
        .stock_per_unit = 24e-6,
        .variation = 0.05,
        .history_bytes = 5.3,
        .file_per_record_byte = 0.5,
        .source = "the expected cost of each member and what a unit of it took on a Xeon of 2023 (AVX-512, busy)",
    };
}

}  // namespace floes
