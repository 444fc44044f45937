#pragma once
// The rows of /arrangements: cases that begin from the same floes share a row.

#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// Rows are ordered by arrangement number, then by sharing_groups().
class ArrangementRows {
  public:
    explicit ArrangementRows(const Campaign& campaign);

    int count() const { return groups_ * arrangements_; }
    /// Rows of each arrangement number.
    int groups() const { return groups_; }
    int row(MemberKey member) const;
    /// Arrangement number of a row.
    int number(int row) const { return row / groups_; }

  private:
    std::vector<int> group_of_case_;
    int groups_ = 0;
    int arrangements_ = 0;
};

}  // namespace floes
