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

/// How many arrangements are drawn, and not run, to know what is usual.
inline constexpr int control_draws = 200;

/// For each case the quantities of the headlines. Arrangements of a geometry are drawn once, those after the campaign's
/// last; poses from a file give nothing to draw, and no rows.
std::vector<ControlRow> find_control(const Campaign& campaign, const CampaignTable& table);

Section control_section(const Summary& summary, const std::vector<ControlRow>& rows);

}  // namespace floes
