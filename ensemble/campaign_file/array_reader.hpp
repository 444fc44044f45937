#pragma once
// How the numbers of members are read out of a campaign file. For this module only.

#include <optional>
#include <string>
#include <vector>

#include "campaign_file/content.hpp"
#include "campaign_file/read.hpp"
#include "hdf5/columns.hpp"
#include "hdf5/read.hpp"
#include "member/array_output.hpp"

namespace floes {

/// An array with a row for each member, or for each arrangement, read row by row.
class ArrayReader {
  public:
    /// `places`: of the file's campaign. Of an array that the file does not have every read is empty. Throws RunError
    /// where its rows do not fit the campaign.
    ArrayReader(const CampaignFile& file, const ArrayOutput& array, const ArrayPlaces& places)
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
            sizes_.push_back(longest ? rows_->width() / std::max<std::size_t>(known, 1)
                                     : places.axis(*axis).places.size());
        }
        hdf5::check_count(file.id(), name, rows_->width(), hdf5::product(std::span<const std::size_t>(sizes_)));
    }

    ArrayValues read(std::size_t row, int case_index) {
        if (!rows_) return {std::vector<std::size_t>(2, 0), {}};
        return places_->own(*array_, case_index, rows_->read(row), sizes_);
    }

    void read(std::size_t row, int case_index, MemberResult& into) { array_->access.set(into, read(row, case_index)); }

  private:
    const ArrayOutput* array_;
    const ArrayPlaces* places_;
    std::vector<std::size_t> sizes_;
    std::optional<hdf5::RowReader<double>> rows_;
};

/// A result for each member with its quantities only. Throws RunError where they do not fit.
std::vector<MemberResult> read_quantities(const CampaignFile& file, std::size_t count);

}  // namespace floes
