#include "campaign_file/load_map_tables.hpp"

#include "statistics/load_map.hpp"

namespace floes {
namespace {

/// A scale of the values that a function gives of 0, 1, …, count - 1.
template <class Function>
hdf5::Scale write_middles(hid_t file, const hdf5::Label& label, std::size_t count, Function middle) {
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k) values.push_back(middle(k));
    return hdf5::write_scale(file, label, values);
}

}  // namespace

LoadMapTables::LoadMapTables(hid_t file, const CampaignScales& scales)
    : height_(write_middles(file, {"height", "1", "height on the structure over its depth, from the keel"},
                            LoadMap::heights, middle_height)),
      angle_(write_middles(file, {"angle", "degree", "angle round the structure's axis, 0 ahead, positive towards +z"},
                           LoadMap::angles, middle_angle)),
      tow_(write_middles(file, {"tow", "1", "time in the window over its length"}, LoadMap::parts, middle_part)),
      group_(hdf5::create_group(file, "load_map")),
      surge_(group_.id(), {"surge_load", "N", "mean surge load that acts here"}, scales.member, {height_, angle_}),
      normal_(group_.id(), {"normal_force", "N", "mean sum of the magnitudes of the normal forces here"}, scales.member,
              {height_, angle_}),
      along_tow_(group_.id(), {"surge_load_along_tow", "N", "mean surge load in this part of the window"},
                 scales.member, {tow_}) {}

void LoadMapTables::write(std::size_t member, const PackedLoadMap& map) {
    surge_.write(member, map.surge);
    normal_.write(member, map.normal);
    along_tow_.write(member, map.along_tow);
}

void LoadMapTables::finish() {
    for (hdf5::Rows* one : {&surge_, &normal_, &along_tow_}) one->finish();
}

}  // namespace floes
