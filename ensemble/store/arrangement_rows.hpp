#pragma once
// The rows of /arrangements: cases whose fields have the same geometry begin from the same floes and share a row.

#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// Rows are ordered by arrangement number, then by geometry in order of its first case.
class ArrangementRows {
  public:
    explicit ArrangementRows(const Campaign& campaign);

    int count() const { return geometries_ * arrangements_; }
    int row(MemberKey member) const;
    /// Arrangement number of a row.
    int number(int row) const { return row / geometries_; }

  private:
    std::vector<int> geometry_of_case_;
    int geometries_ = 0;
    int arrangements_ = 0;
};

}  // namespace floes
