#pragma once
// The ice load of a run over time.

#include <array>
#include <vector>

namespace floes {

/// Contact force on the structure in each step, N. Entry k belongs to the step that ends at (k + 1) Δt; where a member
/// keeps means over `analysis.history_steps` = N steps, to the N that end at (k + 1) N Δt. The water's force on the
/// structure is not in it, so there is no open-water resistance to subtract.
struct LoadHistory {
    std::vector<double> surge;  ///< positive against the tow (-x)
    std::vector<double> sway;   ///< positive towards +z
    std::vector<double> heave;  ///< positive up
};

inline constexpr std::array load_histories{&LoadHistory::surge, &LoadHistory::sway, &LoadHistory::heave};

}  // namespace floes
