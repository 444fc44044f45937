#pragma once
// The loads of a year for programs. For this room only.

#include <vector>

#include "tables/data_rows.hpp"
#include "year/year.hpp"

namespace floes {

std::vector<DataRows> year_records(const Year& year, const YearRequest& request);

}  // namespace floes
