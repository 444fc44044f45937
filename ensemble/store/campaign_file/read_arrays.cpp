#include "campaign_file/read_arrays.hpp"

#include <algorithm>
#include <string>

#include "hdf5/columns.hpp"

namespace floes {

ArrayReader::ArrayReader(const CampaignFile& file, const ArrayOutput& array, const ArrayPlaces& places)
    : array_(&array), places_(&places) {
    const std::string name(array.path);
    if (!hdf5::exists(file.id(), name)) return;
    rows_.emplace(file.id(), name);
    std::size_t known = 1;
    for (const ArrayAxis* axis : array.axes)
        if (axis != nullptr && axis->kind != AxisKind::longest) known *= places.axis(*axis).places.size();
    for (const ArrayAxis* axis : array.axes) {
        if (axis == nullptr) break;
        const bool longest = axis->kind == AxisKind::longest;
        sizes_.push_back(longest ? rows_->width() / std::max<std::size_t>(known, 1) : places.axis(*axis).places.size());
    }
    std::size_t width = 1;
    for (const std::size_t size : sizes_) width *= size;
    hdf5::check_count(file.id(), name, rows_->width(), width);
}

ArrayValues ArrayReader::read(std::size_t row, int case_index) {
    if (!rows_) return {std::vector<std::size_t>(2, 0), {}};
    return places_->own(*array_, case_index, rows_->read(row), sizes_);
}

std::vector<ArrayReader> array_readers(const CampaignFile& file, std::string_view group_or_path,
                                       const ArrayPlaces& places) {
    std::vector<ArrayReader> readers;
    for (const ArrayOutput& array : array_outputs)
        if (array.path == group_or_path || array.group() == group_or_path) readers.emplace_back(file, array, places);
    return readers;
}

std::vector<RowStatus> read_states(const CampaignFile& file) {
    const auto count = static_cast<std::size_t>(member_count(file.campaign()));
    const auto values = hdf5::read_numbers<std::int8_t>(file.id(), "members/status", count, -1, 1);
    std::vector<RowStatus> states;
    for (const std::int8_t value : values) states.push_back(static_cast<RowStatus>(value));
    return states;
}

}  // namespace floes
