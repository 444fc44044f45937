#pragma once
// Design loads of cases over the same arrangements, compared.

#include <vector>

#include "findings/design_load.hpp"
#include "tables/number_text.hpp"
#include "tables/section.hpp"

namespace floes {

/// A figure times `factor` with its interval, or a dash unless that is `said`.
Cell range_cell(const DesignLoadFigure& figure, double factor, bool said);

/// The difference of the first quantile between any two cases over the same arrangements whose members are of one kind;
/// nothing where there are none. `unit`: of the table.
Section design_pairs_section(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                             const DesignLoadRequest& request, const LoadUnit& unit);

}  // namespace floes
