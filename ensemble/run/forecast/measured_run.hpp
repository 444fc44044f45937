#pragma once
// Run times and sizes measured in a finished or running campaign.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

struct MeasuredRun {
    Campaign campaign;
    std::vector<double> wall_time;    ///< s, of each member, in member order; NaN unless it is done
    double file_per_record_byte = 0;  ///< size of the campaign file over that of the journal; 0: one of them is missing
};

/// From the journal beside the campaign file, or from the campaign file alone. Throws InputError if neither can be
/// read.
MeasuredRun read_measured_run(const std::filesystem::path& campaign_file);

}  // namespace floes
