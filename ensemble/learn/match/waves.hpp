#pragma once
// The campaigns of a matching: waves of one design after another, which vary the same inputs under the same conditions.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "campaign_file/campaign_table.hpp"

namespace floes {

/// One campaign file.
struct MatchWave {
    std::string file;  ///< names it in messages
    Campaign campaign;
    CampaignTable table;
};

/// Throws InputError as read_campaign_file() does.
MatchWave read_wave(const std::filesystem::path& path);

/// An input that the design varies, as a coordinate from -1 to 1.
struct MatchAxis {
    std::string key;
    double from = 0;  ///< in the key's unit
    double to = 0;    ///< above from
    AxisScale scale = AxisScale::linear;
    bool whole = false;  ///< the key takes whole numbers only; value() does not round

    /// -1 at `from`, 1 at `to`, on the axis's scale. `value` is in the key's unit, above 0 on a logarithmic axis.
    double coordinate(double value) const;
    /// The inverse.
    double value(double coordinate) const;
};

/// The axes, with the ranges of the first wave: from and to, or the least and the greatest value of a grid or list.
/// Throws InputError, one sentence, for no wave, a campaign without a design, an axis that takes words or has one value
/// only, and waves with other axes or other values of any key that is not an axis. Keys that only add figures
/// or history to the file may differ, and so may seeds and arrangements.
std::vector<MatchAxis> match_axes(std::span<const MatchWave> waves);

/// The names of the [[case]] tables that are run at the points of some wave, in order; "" where a design has none.
std::vector<std::string> match_cases(std::span<const MatchWave> waves);

}  // namespace floes
