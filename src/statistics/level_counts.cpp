#include "statistics/level_counts.hpp"

#include <limits>

namespace floes {

std::vector<LevelCount> count_levels(std::span<const double> window, std::span<const double> levels) {
    std::vector<LevelCount> counts(levels.size());
    double before = std::numeric_limits<double>::infinity();  // a window that begins above a level does not rise to it
    for (const double load : window) {
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const bool above = load > levels[k];
            counts[k].steps_above += above ? 1 : 0;
            counts[k].upcrossings += above && !(before > levels[k]) ? 1 : 0;
        }
        before = load;
    }
    return counts;
}

}  // namespace floes
