#pragma once
// One colour for each case, the same in every figure. For this room only.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "page/report_data.hpp"

namespace floes {

inline std::string colour(std::size_t of_case) {
    constexpr std::size_t colours = 6;
    return fmt::format("c{}", of_case % colours);
}

inline std::vector<std::string> case_names(const ReportData& data) {
    std::vector<std::string> names;
    for (const CaseSummary& row : data.summary.cases) names.push_back(row.about.name);
    return names;
}

inline std::vector<std::pair<std::string, std::string>> case_legend(const ReportData& data) {
    std::vector<std::pair<std::string, std::string>> legend;
    const std::vector<std::string> names = case_names(data);
    for (std::size_t i = 0; i < names.size(); ++i) legend.emplace_back(colour(i), names[i]);
    return legend;
}

}  // namespace floes
