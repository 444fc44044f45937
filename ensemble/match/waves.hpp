#pragma once
// The data of a matching: what was measured, the campaigns that are compared with it, and the scatter at their points.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "findings/design_points.hpp"
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

/// The axes, with the ranges of the first wave: from and to, or the least and the greatest value of a grid or list.
/// Throws InputError, one sentence, for no wave, a campaign without a design, an axis that takes words or has one value
/// only, and waves with other axes or other values of any key that is not an axis. Keys that only add figures
/// or history to the file may differ, and so may seeds and arrangements.
std::vector<RangedAxis> match_axes(std::span<const MatchWave> waves);

/// The names of the [[case]] tables that are run at the points of some wave, in order; "" where a design has none.
std::vector<std::string> match_cases(std::span<const MatchWave> waves);

/// The name nearest to a mistyped one, of one name at least.
std::string nearest(const std::vector<std::string>& names, const std::string& name);

// Means and scatter over arrangements at the points of a design. For this module only.

/// The runs at one point. Runs of two points of one wave with equal arrangements began from the same floes.
struct PointRuns {
    int wave = 0;
    std::vector<int> arrangements;
    std::vector<double> values;  ///< one an arrangement, at least one
};

/// The lists have an element for each point.
struct Scatter {
    std::vector<double> mean;             ///< over the runs
    std::vector<double> sample_variance;  ///< of single runs, n - 1; NaN for one run
    std::vector<double> variance;  ///< of single runs, weighted with the pooled one; used where it cannot be emulated
    double pooled = 0;             ///< variance of single runs over all points; NaN where each has one run
    /// Part of the variance that an arrangement has in common at all points, 0-1: where points begin from the same
    /// floes, their means err together. The error of the mean of n runs has variance v / n, and two such errors at
    /// different points with the same n arrangements the covariance shared v / n. An emulator that takes the errors for
    /// independent does not see this part, which must be added to the variance that it states. Where
    /// campaign.common_arrangements is false there is none.
    double shared = 0;
};

/// As match_data() says.
Scatter scatter_of(std::span<const PointRuns> points);

// The data of emulators: the coordinates of a design's points, and for each target mean and scatter at each point.

/// A point of a wave's design at which some member is done.
struct MatchPoint {
    std::vector<double>
        coordinates;  ///< one an axis; beyond ±1 where a later wave reaches beyond the first one's ranges
    int wave = 0;
    int number = 0;  ///< in the design of that wave
};

/// Results for one target. The lists have an element for each point with a done member of the target's case that
/// measured the quantity; numbers are in the quantity's stored unit.
struct TargetData : Scatter {
    Target target;
    std::vector<int> point;  ///< index into MatchData::points, rising
    std::vector<int> runs;   ///< done, at least 1
};

struct MatchData {
    std::vector<RangedAxis> axes;
    std::vector<MatchPoint> points;   ///< of all waves, in order of wave and point
    std::vector<TargetData> targets;  ///< one a target, in order
};

/// Weight of the variance pooled over all points, in runs.
inline constexpr double pooled_runs = 4;

/// Means and scatter of each target at the points of all waves. Members that are not done are left out, and so are
/// points without any.
///
/// Variance: a sample variance of four runs is right within a factor of 2 or 3 only, so it is averaged with the
/// variance V pooled over all points, Σ(nᵢ - 1) sᵢ² / Σ(nᵢ - 1), which has the weight of pooled_runs runs:
/// (pooled_runs V + (n - 1) s²) / (pooled_runs + n - 1). A point with one run has V, one with many its own.
///
/// Shared part: the mean product of the deviations from the points' means of two points of a wave on the same
/// arrangement, corrected for the means' own errors, over V; 0 where no two points share arrangements. Of points of
/// different waves it is not computed, though waves with one campaign.seed share arrangements, too.
///
/// A target without a case is about the only [[case]]. A target that is held out may be of a case or a time that no
/// wave has: then it has no points. Throws InputError, one sentence, for any other such target, for one with a single
/// run at every point, for two waves with the same simulations, and as match_axes() does. Within a wave, a point that
/// repeats an earlier one (whole-numbered axes) is left out.
MatchData match_data(std::span<const MatchWave> waves, std::span<const Target> targets);

}  // namespace floes
