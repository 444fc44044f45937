#pragma once
// The pressure of ice over the area of each part of a hull.
//
// A part's normal force, averaged over a time, over the area of the part that the ice can lie against: its surface
// between the lower and the upper side of floating ice of the case's thickness, along the wall. What acts on the part
// above or below that is counted as if it acted there, so the pressure is not below that of the ice at the waterline.

#include <optional>
#include <string>
#include <vector>

#include "findings/evidence.hpp"

namespace floes {

/// At full scale.
struct PressureRow {
    std::size_t case_index = 0;
    std::string part;
    double surface = 0;    ///< of the whole part, m²
    double reached = 0;    ///< of what floating ice lies against, m²
    double averaging = 0;  ///< s
    /// Largest over that time, Pa: mean over segments and arrangements; none where no ice lies against the part.
    std::optional<Interval> pressure = {};
    std::optional<double> line =
        {};  ///< pressure_of_area(), Pa; none where there is no pressure, or the ice is a tank's
    double members = 0;
};

/// Ice thinner than this, m, is taken as a tank's. Judgement: tanks make a few centimetres, and ice of no thickness
/// that structures are designed for is thinner.
inline constexpr double tank_ice = 0.15;

/// By case, part and averaging time; nothing of members that were computed without normal forces. `scale`: length at
/// full scale over length in the campaign; lengths grow with it, pressures likewise, times with its square root.
std::vector<PressureRow> find_pressures(const Campaign& campaign, const CampaignTable& table, double scale);

Section pressure_section(const Evidence& evidence);

// Loads on the parts of a hull and moments on the whole of it, over the arrangements of each case.

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
