#pragma once
// Where the work of the tow goes: the mean load as a sum of what ice, water and structure do with it.

#include <vector>

#include "findings/evidence.hpp"

namespace floes {

/// One share of the load, over a case's arrangements.
struct EnergyRow {
    std::size_t case_index = 0;
    std::string_view key;    ///< of the quantity
    std::string_view words;  ///< in tables
    Interval force{};        ///< N: work over the distance towed
    double share = 0;        ///< of the sum of all, 0-1
    double members = 0;      ///< with a value
};

/// By case, in the order of the list of quantities; cases whose members did not measure it have none.
std::vector<EnergyRow> find_energy(const CampaignTable& table);

Section energy_section(Evidence& evidence);

}  // namespace floes
