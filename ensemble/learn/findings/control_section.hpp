#pragma once
// Means corrected for what is known of the arrangements before they are run: their local order and the coverage ahead.

#include <string>
#include <vector>

#include "findings/summary.hpp"
#include "inference/control.hpp"

namespace floes {

struct ControlRow {
    std::size_t case_index = 0;
    Quantity quantity{};
    ControlledMean found;
};

/// Arrangements that are drawn, not run, for the means of the covariates.
inline constexpr int control_draws = 200;

/// For each case the quantities of the headlines. Arrangements of a geometry are drawn once, those after the campaign's
/// last; cases with poses from a file have no rows.
std::vector<ControlRow> find_control(const Campaign& campaign, const CampaignTable& table);

Section control_section(const Summary& summary, const std::vector<ControlRow>& rows);

}  // namespace floes
