#pragma once
// A run as it goes, filling a terminal: floes status --watch.

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "run/campaign_status.hpp"
#include "tables/figure_text.hpp"
#include "tables/section.hpp"
#include "tables/units.hpp"

namespace floes {

/// The mean load of a case as far as its members are done.
struct WatchedLoad {
    Estimate mean;  ///< N
    /// Half-width of its interval over the first so many members, share of the mean; at most 60 of them.
    std::vector<std::pair<int, double>> half_widths = {};
};

struct WatchedRun {
    CampaignStatus status;
    std::vector<WatchedLoad> loads;      ///< by case
    Units units = {};                    ///< of loads
    std::optional<double> memory = {};   ///< of the run's processes on this host, bytes; none: it runs elsewhere or not
    std::optional<double> at_hand = {};  ///< of this host, bytes
};

/// What is to be seen of a campaign, without memory.
WatchedRun watched(const CampaignSnapshot& snapshot);

struct Screen {
    int columns = 80;
    int rows = 24;
    Letters letters = Letters::ascii;
};

/// Lines of the picture, at most `rows` of at most `columns` characters: counts, rate, time left and memory; a bar and
/// the mean load of each case; failures, running and slowest members; half-widths over members where there is room.
/// Side by side from 120 columns on.
std::vector<std::string> watch_frame(const WatchedRun& run, const Screen& screen);

// From one look at a campaign to the next, by whatever is longer.
inline constexpr std::chrono::seconds watch_interval{2};
inline constexpr int least_pause_per_look = 10;  ///< reading a large campaign takes seconds

/// Fills the terminal of standard output until no run is active or q or Ctrl-C is pressed, and leaves it as it was.
void watch_on_terminal(std::span<const std::filesystem::path> campaign_files);

}  // namespace floes
