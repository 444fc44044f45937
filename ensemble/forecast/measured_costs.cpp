#include "forecast/driver_costs.hpp"
#include "forecast/member_costs.hpp"

namespace floes {

DriverCosts measured_costs() {
    return {
        .start_up = 0.05,
        .start_up_per_rank = 0.02,
        .assign = 5e-6,
        .answer = 40e-6,
        .own_member = 40e-6,
        .keep_per_byte = 4e-9,
        .sync = 4e-3,
        .sync_interval = 0.9,
        .publish = 0.02,
        .publish_per_member = 20e-6,
        .publish_per_byte = 20e-9,
        .publish_interval = 300,
        .publish_share = 1.0 / 20,
        .member = 10e-6,
        .report = 30e-6,
        .report_per_byte = 2e-9,
        .latency = 5e-6,
        .transfer_per_byte = 0.2e-9,
        .longest_pause = 2e-3,
    };
}

MemberCosts measured_member_costs() {
    return {
        .lanes_per_unit = 3.1e-6,
        .stock_per_unit = 24e-6,
        .variation = 0.05,
        .file_per_record_byte = 0.87,
        .source = "the expected cost of each member and what a unit of it took on a Xeon of 2023 (AVX-512, busy)",
    };
}

}  // namespace floes
