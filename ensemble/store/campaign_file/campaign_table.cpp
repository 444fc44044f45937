#include "campaign_file/campaign_table.hpp"

#include <algorithm>
#include <limits>

namespace floes {

double MemberRow::value(const Quantity& quantity) const {
    return done() ? quantity.of(*this) : std::numeric_limits<double>::quiet_NaN();
}

const AveragedLoad* MemberRow::averaged_over(double time) const {
    const auto found = std::ranges::find(averaged, time, &AveragedLoad::time);
    return done() && found != averaged.end() ? &*found : nullptr;
}

void set_levels(MemberRow& row, std::span<const double> all, std::span<const double> own,
                std::span<const LevelCount> counts) {
    for (std::size_t k = 0; k < std::min(own.size(), counts.size()); ++k) {
        const auto place = static_cast<std::size_t>(std::ranges::lower_bound(all, own[k]) - all.begin());
        row.steps_above.at(place) = counts[k].steps_above;
        row.upcrossings.at(place) = counts[k].upcrossings;
    }
}

std::optional<int> member_with_largest_load(const CampaignTable& table,
                                            const std::function<bool(const MemberRow&)>& counts) {
    std::optional<int> largest;
    for (std::size_t k = 0; k < table.members.size(); ++k) {
        const MemberRow& row = table.members[k];
        if (!row.done() || !counts(row)) continue;
        if (!largest || row.load.maximum > table.members[static_cast<std::size_t>(*largest)].load.maximum)
            largest = static_cast<int>(k);
    }
    return largest;
}

}  // namespace floes
