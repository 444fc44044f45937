#pragma once
// The arrays of members in a campaign file, by their list. For this room only.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "campaign_file/array_places.hpp"
#include "campaign_file/campaign_file.hpp"
#include "campaign_file/campaign_table.hpp"
#include "hdf5/read.hpp"

namespace floes {

/// An array with a row for each member, or for each arrangement, read row by row.
class ArrayReader {
  public:
    /// `places`: of the file's campaign. Of an array that the file does not have every read is empty. Throws RunError
    /// where its rows do not fit the campaign.
    ArrayReader(const CampaignFile& file, const ArrayOutput& array, const ArrayPlaces& places);

    ArrayValues read(std::size_t row, int case_index);
    void read(std::size_t row, int case_index, MemberResult& into) { array_->access.set(into, read(row, case_index)); }

  private:
    const ArrayOutput* array_;
    const ArrayPlaces* places_;
    std::vector<std::size_t> sizes_;
    std::optional<hdf5::RowReader<double>> rows_;
};

/// Readers of the arrays of one group, or of one array.
std::vector<ArrayReader> array_readers(const CampaignFile& file, std::string_view group_or_path,
                                       const ArrayPlaces& places);

/// Of each member, in member order.
std::vector<RowStatus> read_states(const CampaignFile& file);

}  // namespace floes
