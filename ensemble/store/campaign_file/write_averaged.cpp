#include <fmt/format.h>

#include <algorithm>

#include "campaign_file/campaign_content.hpp"

namespace floes {
namespace {

/// The loads of a member over each averaging time, `width` of them; NaN where there is none.
auto of_each_time(const std::vector<double>& times, std::size_t width, std::vector<double> AveragedLoad::*loads) {
    return [times, width, loads](const FiledMember& m) {
        std::vector<double> values(times.size() * width, nan);
        for (std::size_t k = 0; k < times.size(); ++k)
            if (const AveragedLoad* one = m.row.averaged_over(times[k]))
                std::ranges::copy(one->*loads, values.begin() + static_cast<std::ptrdiff_t>(k * width));
        return values;
    };
}

}  // namespace

void add_averaged(hid_t file, const CampaignContent& content, const CampaignScales& scales, MemberTables& tables) {
    const std::vector<double>& averaging_times = content.table().averaging_times;
    if (averaging_times.empty()) return;
    const hdf5::Scale times =
        hdf5::write_scale(file, {"averaging_time", "s", "time that the surge load is averaged over"}, averaging_times);
    const hdf5::Handle group = hdf5::create_group(file, "averaged");
    for (const Quantity& one : quantities) {
        if (one.averaged == nullptr) continue;
        std::vector<Quantity> over_times;
        for (const double time : averaging_times) over_times.push_back(averaged_over(one, time));
        tables.add_numbers<double>(group.id(),
                                   {std::string{one.key.view()}, std::string{one.unit},
                                    fmt::format("{}, of its running means", one.long_name)},
                                   {scales.member, times}, nan, [over_times](const FiledMember& m) {
                                       std::vector<double> values;
                                       for (const Quantity& averaged : over_times)
                                           values.push_back(m.row.value(averaged));
                                       return values;
                                   });
    }
    tables.add_numbers<double>(group.id(), {"segment_maximum", "N", "largest running mean that ends in each segment"},
                               {scales.member, times, scales.segment}, nan,
                               of_each_time(averaging_times, scales.segment.size(), &AveragedLoad::segment_maximum));
    const std::size_t most_peaks = content.most_peaks();
    if (most_peaks == 0) return;
    const hdf5::Scale peak =
        hdf5::write_index_scale(file, "peak", "declustered peak of a member, the highest first", most_peaks);
    tables.add_numbers<double>(
        group.id(), {"peaks", "N", "declustered peaks of the running means above their mean, falling"},
        {scales.member, times, peak}, nan, of_each_time(averaging_times, most_peaks, &AveragedLoad::peaks));
}

}  // namespace floes
