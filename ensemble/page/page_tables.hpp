#pragma once
// The tables of the report as HTML. For this room only.

#include <string>

#include "page/page.hpp"

namespace floes {

std::string table3(const ReportData& data);  ///< this campaign, the paper, the experiment
std::string pairs_table_html(const ReportData& data);
std::string points_table_html(const DesignPoints& points);
std::string sensitivity_table_html(const Sensitivity& found);
std::string return_levels_table(const ReportData& data);

}  // namespace floes
