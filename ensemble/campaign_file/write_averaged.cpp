#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "campaign_file/campaign_content.hpp"

namespace floes {
namespace {

/// The loads of each member and averaging time, `width` of them; NaN where there is none.
std::vector<double> of_each_time(const CampaignTable& table, std::size_t width,
                                 std::vector<double> AveragedLoad::*loads) {
    std::vector<double> values(table.members.size() * table.averaging_times.size() * width,
                               std::numeric_limits<double>::quiet_NaN());
    auto place = values.begin();
    for (const MemberRow& row : table.members) {
        for (const double time : table.averaging_times) {
            if (const AveragedLoad* one = row.averaged_over(time)) std::ranges::copy(one->*loads, place);
            place += static_cast<std::ptrdiff_t>(width);
        }
    }
    return values;
}

void write_peaks(hid_t group, hid_t file, const CampaignTable& table, const CampaignScales& scales,
                 const hdf5::Scale& times) {
    std::size_t most = 0;
    for (const MemberRow& row : table.members)
        for (const AveragedLoad& one : row.averaged) most = std::max(most, one.peaks.size());
    if (most == 0) return;
    const hdf5::Scale peak =
        hdf5::write_index_scale(file, "peak", "declustered peak of a member, the highest first", most);
    hdf5::write_values(group, {"peaks", "N", "declustered peaks of the running means above their mean, falling"},
                       {scales.member, times, peak}, of_each_time(table, most, &AveragedLoad::peaks));
}

}  // namespace

void write_averaged(hid_t file, const CampaignContent& content, const CampaignScales& scales) {
    const CampaignTable& table = content.table;
    if (table.averaging_times.empty()) return;
    const hdf5::Scale times = hdf5::write_scale(
        file, {"averaging_time", "s", "time that the surge load is averaged over"}, table.averaging_times);
    const hdf5::Handle group = hdf5::create_group(file, "averaged");
    for (const Quantity& one : quantities) {
        if (one.averaged == nullptr) continue;
        std::vector<Quantity> over_times;
        for (const double time : table.averaging_times) over_times.push_back(averaged_over(one, time));
        std::vector<double> values;
        for (const MemberRow& row : table.members)
            for (const Quantity& averaged : over_times) values.push_back(row.value(averaged));
        hdf5::write_values(group.id(),
                           {std::string{one.key.view()}, std::string{one.unit},
                            fmt::format("{}, of its running means", one.long_name)},
                           {scales.member, times}, values);
    }
    hdf5::write_values(group.id(), {"segment_maximum", "N", "largest running mean that ends in each segment"},
                       {scales.member, times, scales.segment},
                       of_each_time(table, scales.segment.size(), &AveragedLoad::segment_maximum));
    write_peaks(group.id(), file, table, scales, times);
}

}  // namespace floes
