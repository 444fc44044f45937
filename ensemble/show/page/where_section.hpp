#pragma once
// Where on the structure the load acts, when along the tow, and where floes fail. For this room only.

#include <string>
#include <vector>

#include "page/report_data.hpp"

namespace floes {

/// Of each mapped case, unrolled: angle by height.
std::vector<std::string> load_map_figures(const ReportData& data);
std::string load_rose_figure(const ReportData& data);       ///< load by angle, in plan
std::string load_profile_figure(const ReportData& data);    ///< load by height
std::string load_along_tow_figure(const ReportData& data);  ///< over the distance towed
/// Of each mapped case, a floe with each joint coloured by how often it failed.
std::vector<std::string> joint_failure_figures(const ReportData& data);
/// How many, in which mode; of each such case with failures.
std::vector<std::string> joint_failure_sentences(const ReportData& data);

std::string where_the_load_acts(const ReportData& data);
std::string where_floes_fail(const ReportData& data);

}  // namespace floes
