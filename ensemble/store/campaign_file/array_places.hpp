#pragma once
// Where the values of a member's arrays lie in the rows of a campaign file, which are as wide as all cases together
// need. For this room only.

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "campaign/campaign.hpp"
#include "member/array_output.hpp"

namespace floes {

/// An axis in a file.
struct FiledAxis {
    std::vector<double> places;                       ///< none of axes that members find
    std::vector<std::size_t> own_sizes;               ///< by case; likewise
    std::vector<std::vector<std::size_t>> positions;  ///< by case: of its own places; empty: they are the first ones
    bool alike = true;                                ///< the places of each case are the first ones
};

class ArrayPlaces {
  public:
    explicit ArrayPlaces(const Campaign& campaign);

    const FiledAxis& axis(const ArrayAxis& axis) const { return axes_.at(&axis); }

    /// Sizes of the array in a member of the case; 0 along the axes that members find.
    std::vector<std::size_t> own_sizes(const ArrayOutput& array, int case_index) const;

    /// The member's values in a row of these sizes, NaN elsewhere.
    std::vector<double> row(const ArrayOutput& array, int case_index, const ArrayValues& own,
                            std::span<const std::size_t> sizes) const;

    /// The way back. Where all are NaN, the member does not have the array.
    ArrayValues own(const ArrayOutput& array, int case_index, std::span<const double> row,
                    std::span<const std::size_t> sizes) const;

  private:
    template <class Use>
    void for_each_place(const ArrayOutput& array, int case_index, std::span<const std::size_t> own,
                        std::span<const std::size_t> sizes, const Use& use) const;

    std::map<const ArrayAxis*, FiledAxis> axes_;
};

}  // namespace floes
