#pragma once
// Targets: what was measured, as numbers that members of a campaign can be compared with.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "member/quantity.hpp"

namespace floes {

/// A measured figure. All numbers are in the quantity's stored unit; ratios are 0-1.
struct Target {
    Quantity quantity;         ///< of the list, or averaged ("mean_maximum_0.5s")
    std::string case_name;     ///< the [[case]] that it is about; empty where the campaign has only one
    double value = 0;          ///< measured
    double uncertainty = 0;    ///< standard uncertainty of the measurement itself
    int runs = 1;              ///< measured runs behind it; of one run the scatter over arrangements counts in full
    double discrepancy = 0;    ///< standard deviation by which the model itself may miss it
    bool held_out = false;     ///< rules nothing out; kept for a check
    std::string name() const;  ///< "E60 mean_load"; without a case "mean_load"
    /// "24 N", "7.5 %": a value of the quantity as it is shown.
    std::string shown(double stored, int digits = 4) const;
};

/// Reads the [[target]] tables of a TOML text; `file` names it in messages.
///
///     [[target]]
///     quantity = "mean_load"
///     case = "E60"
///     value = 38.8                # N
///     uncertainty = 0.5           # N, 0 unless given
///     runs = 1                    # 1 unless given
///     discrepancy_percent = 5     # of the value; or discrepancy, in N; 0 unless given
///     held_out = false            # false unless given
///
/// value, uncertainty and discrepancy are in the unit in which the quantity is shown: N, percent of a ratio.
/// Throws InputError, one sentence: file, line, key, value, what is allowed, and the nearest known key or quantity; for
/// two targets of one quantity and case, and for a text without targets, too.
std::vector<Target> read_targets(std::string_view text, const std::string& file);

// The campaigns of a matching: waves of one design after another, which vary the same inputs under the same conditions.

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
