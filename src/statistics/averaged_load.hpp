#pragma once
// The load as a structure and its parts feel it: peaks, running means and cycles.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace floes {

// Peaks of a load that count once each, however ragged they are.

/// Declustered peaks, falling: the highest local maximum, then the highest of those at least `apart` places from it,
/// and so on, down to those above `least`. So the peaks above any higher level are the declustered peaks of that level.
/// The ends count as local maxima where the values rise towards them. `apart`: at least 1.
std::vector<double> declustered_peaks(std::span<const double> values, std::size_t apart, double least);

// The load as something slower than a time step feels it: statistics of its running means.
//
// A rigid contact passes its impulse on within one step, so a maximum over single steps grows as the step shrinks. A
// maximum of running means over a stated time does not.

/// Statistics of the running mean over `time`.
struct AveragedLoad {
    double time = 0;                      ///< averaging time, s
    double sd = 0;                        ///< population standard deviation of the running means in the window, N
    std::vector<double> segment_maximum;  ///< largest running mean that ends in each segment, N
    double mean_maximum = 0;              ///< mean of the segment maxima, N
    double sd_maximum = 0;                ///< population SD of the segment maxima, N
    std::vector<double> peaks = {};       ///< declustered peaks of the running means above their mean, falling, N
};

/// Largest running mean of the window, N; NaN where there is none.
double largest_of(const AveragedLoad& load);

/// How a window is looked at.
struct Averaging {
    double time_step = 0;           ///< s
    int segments = 0;               ///< equal parts of the window
    std::span<const double> times;  ///< s, that the load is averaged over
    double peak_separation = 0;     ///< s, between peaks that count as two
};

/// Mean of each `count` successive values, by one pass with a compensated sum: result k is that of values[k] …
/// values[k + count - 1]. `count` at least 1; none where there are fewer values than that.
std::vector<double> running_means(std::span<const double> values, std::size_t count);

/// One for each of the times, which are rounded to whole steps, at least one. The running means of a window are those
/// of which every step lies in the window; each belongs to the segment in which it ends, so the first segment has fewer
/// by the averaging time less one step. `window`: as load_statistics() takes it; throws ContractError for a
/// time longer than a segment.
std::vector<AveragedLoad> averaged_load(std::span<const double> window, const Averaging& how);

// Loads on the parts of a structure.

/// Over the steps of the window.
struct PartLoad {
    double mean = 0;        ///< surge load, N
    double sd = 0;          ///< population standard deviation of the surge load, N
    double maximum = 0;     ///< largest surge load, N
    double mean_sway = 0;   ///< N, towards +z
    double mean_heave = 0;  ///< N, upwards
    /// Mean of the segment maxima of the surge load's running means over each averaging time, N.
    std::vector<double> mean_maximum{};
    /// The same of the sum of the magnitudes of the normal forces, N: what presses on its surface, whichever way the
    /// surface faces. Over an area it is the pressure averaged over that.
    std::vector<double> normal_maximum{};
};

/// What acts on a part at every step of the window, as averaged_load() takes it, N.
struct PartHistory {
    std::vector<double> surge, sway, heave, normal;

    std::array<std::vector<double>*, 4> all() { return {&surge, &sway, &heave, &normal}; }
};

PartLoad part_load(const PartHistory& part, const Averaging& how);

// Cycles of a load for fatigue.

struct LoadCycle {
    double range = 0;  ///< from trough to peak, in the unit of the load
    double mean = 0;   ///< of trough and peak
    double count = 1;  ///< 1, or 1/2 where the load does not come back
};

/// Rainflow counting by ASTM E1049-85 (2017), section 5.4.4: of the successive ranges X (the latest) and Y (before it),
/// Y is a cycle where X is not smaller; half a cycle if it begins where the history does, and so is what remains.
/// Plateaus have no ranges. In the order in which they are found; none for fewer than two different values.
std::vector<LoadCycle> rainflow(std::span<const double> values);

/// Σ count range^exponent: what a material whose S-N curve has that slope suffers, up to a factor (Palmgren and Miner).
double damage_sum(std::span<const LoadCycle> cycles, double exponent);

}  // namespace floes
