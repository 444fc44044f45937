#include "findings/levels.hpp"

#include <cmath>
#include <limits>

namespace floes {

std::vector<LevelRow> find_levels(const CampaignTable& table) {
    std::vector<LevelRow> rows;
    for (std::size_t index = 0; index < table.cases.size(); ++index) {
        const CaseRow& about = table.cases[index];
        for (std::size_t level = 0; level < table.levels.size(); ++level) {
            std::vector<double> shares;
            std::vector<double> rates;
            for (const MemberRow& member : table.members) {
                if (member.case_index != static_cast<int>(index) || std::isnan(member.steps_above[level])) continue;
                shares.push_back(member.steps_above[level] / about.window_steps());
                rates.push_back(member.upcrossings[level] / about.analysis.window);
            }
            if (shares.empty()) continue;
            rows.push_back({index, table.levels[level], static_cast<int>(shares.size()),
                            clipped(mean_interval(shares), 0, 1),
                            clipped(mean_interval(rates), 0, std::numeric_limits<double>::infinity())});
        }
    }
    return rows;
}

}  // namespace floes
