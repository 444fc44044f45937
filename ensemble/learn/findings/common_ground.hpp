#pragma once
// What the cases of a campaign have in common, and what varies between them. No case speaks for the others.

#include <string>
#include <vector>

#include "findings/summary.hpp"

namespace floes {

/// "0.02", "0.02 to 0.04": the least and the largest of the values.
std::string range_text(const std::vector<double>& values);

/// "24 floes of 0.6 m x 0.6 m x 0.02 to 0.04 m at 75 %, scattered at random; structure towed at 0.1 m/s."
std::string field_words(const Campaign& campaign);

/// A sentence for each key in which the cases differ, "Varies: thickness 0.02 m (soft), 0.03 m (stiff, open)."; of a
/// design one for its axes. At most a handful, and then how many more.
std::vector<std::string> variation_lines(const Campaign& campaign, const Summary& summary);

/// Groups of cases that are equal in what `of` gives, in order of their first case.
template <class Of>
std::vector<std::vector<std::size_t>> alike(const Campaign& campaign, const Of& of) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        const auto same = [&](const std::vector<std::size_t>& group) {
            return of(campaign.cases[group.front()].scenario) == of(campaign.cases[k].scenario);
        };
        bool found = false;
        for (std::vector<std::size_t>& group : groups) {
            if (!same(group)) continue;
            group.push_back(k);
            found = true;
            break;
        }
        if (!found) groups.push_back({k});
    }
    return groups;
}

}  // namespace floes
