#pragma once
// The part of the report that shows the members with the largest loads.

#include <string>
#include <vector>

#include "page/report_data.hpp"

namespace floes {

/// The members of which a report shows pictures: of each case the one with the largest load or, unless `all`, only the
/// one with the largest load of the campaign. In the order of the cases.
std::vector<int> pictured_members(const ReportData& data, bool all);

/// What plays the worst moment of a member in a browser.
std::string replay_command(const ReportData& data, int member);

/// Pictures and commands; nothing without moments.
std::string moments_section(const ReportData& data);

}  // namespace floes
