#include "campaign_file/campaign_content.hpp"

namespace floes {

void add_levels(hid_t file, const CampaignContent& content, const CampaignScales& scales, MemberTables& tables) {
    if (content.table().levels.empty()) return;
    const hdf5::Scale level =
        hdf5::write_scale(file, {"level", "N", "surge load that steps are counted above"}, content.table().levels);
    const hdf5::Handle group = hdf5::create_group(file, "exceedance");
    const auto counts = [&](const char* name, const char* long_name, std::vector<double> MemberRow::*field) {
        tables.add_numbers<double>(group.id(), {name, "1", long_name}, {scales.member, level}, nan,
                                   [field](const FiledMember& m) { return std::span<const double>(m.row.*field); });
    };
    counts("steps_above", "steps of the window with a surge load above the level", &MemberRow::steps_above);
    counts("upcrossings", "rises of the surge load through the level within the window", &MemberRow::upcrossings);
}

}  // namespace floes
