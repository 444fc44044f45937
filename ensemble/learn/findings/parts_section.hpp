#pragma once
// Loads on the parts of a hull and moments on the whole of it, over the arrangements of each case.

#include <string>
#include <vector>

#include "findings/evidence.hpp"

namespace floes {

/// A statistic of the surge load on one part, over a case's arrangements.
struct PartRow {
    std::size_t case_index = 0;
    std::string part;
    std::string statistic;  ///< "mean_N", "sd_N", "maximum_N", "mean_maximum_0.5s_N", "mean_sway_N", "mean_heave_N"
    Interval load{};        ///< N
    double members = 0;
};

/// By case, part and statistic; cases of a structure that is one part have none.
std::vector<PartRow> find_parts(const Campaign& campaign, const CampaignTable& table);

/// Parts, pressures on them, then moments.
std::vector<Section> parts_sections(Evidence& evidence);

}  // namespace floes
