#pragma once
// The figures of the report, each as SVG. For this room only.

#include <string>

#include "page/report_data.hpp"
#include "quantities/quantity.hpp"

namespace floes {

std::string histories_figure(const ReportData& data);    ///< Fig. 6
std::string modulus_figure(const ReportData& data);      ///< Fig. 2
std::string hybrid_figure(const ReportData& data);       ///< Fig. 8
std::string joint_figure(const Scenario& scenario);      ///< Fig. 1
std::string section_figure(const Scenario& scenario);    ///< Fig. 4
std::string arrangement_figure(const ReportData& data);  ///< of the member with the largest load
std::string strips_figure(const ReportData& data, const Quantity& quantity);
std::string pairs_figure(const ReportData& data, const Quantity& quantity);
std::string exceedance_figure(const ReportData& data);
std::string levels_figure(const ReportData& data);
std::string convergence_figure(const ReportData& data);
std::string failures_figure(const ReportData& data);

}  // namespace floes
