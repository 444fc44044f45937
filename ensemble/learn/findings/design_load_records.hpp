#pragma once
// Design loads for programs.

#include <vector>

#include "findings/design_load.hpp"
#include "tables/section.hpp"

namespace floes {

/// A line for each case, method and figure.
DataRows load_records(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                      const DesignLoadRequest& request);

/// What the loads rest on, one record for each case, at the scale of the campaign.
DataRows basis_records(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                       const DesignLoadRequest& request);

/// Peaks above each of them, with the rate that each tail gives: a curve for each case, at the scale of the campaign.
DataRows rate_records(const Summary& summary, const std::vector<CaseDesignLoad>& designs);

}  // namespace floes
