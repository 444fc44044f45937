#include "campaign_file/read_load_map.hpp"

#include <cmath>

#include "campaign_file/campaign_table.hpp"
#include "hdf5/columns.hpp"

namespace floes {

void for_each_load_map(const CampaignFile& file, const std::function<void(int, const LoadMap&)>& use) {
    const hdf5::QuietErrors quiet;
    if (!hdf5::exists(file.id(), "load_map")) return;  // before layout 1.7
    const auto status = hdf5::read_values<std::int8_t>(file.id(), "members/status");
    hdf5::RowReader<double> surge(file.id(), "load_map/surge_load");
    hdf5::RowReader<double> normal(file.id(), "load_map/normal_force");
    hdf5::RowReader<double> along_tow(file.id(), "load_map/surge_load_along_tow");
    hdf5::check_count(file.id(), "load_map/surge_load", surge.width(), LoadMap::heights * LoadMap::angles);
    hdf5::check_count(file.id(), "load_map/normal_force", normal.width(), LoadMap::heights * LoadMap::angles);
    hdf5::check_count(file.id(), "load_map/surge_load_along_tow", along_tow.width(), LoadMap::parts);
    const auto values = [](std::span<const double> row) { return std::vector(row.begin(), row.end()); };
    for (std::size_t member = 0; member < status.size(); ++member) {
        if (static_cast<RowStatus>(status[member]) != RowStatus::done) continue;
        const LoadMap map{values(surge.read(member)), values(normal.read(member)), values(along_tow.read(member))};
        if (!std::isnan(map.surge.at(0))) use(static_cast<int>(member), map);
    }
}

}  // namespace floes
