#include "findings/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "findings/extremes_text.hpp"
#include "findings/json.hpp"
#include "findings/levels_text.hpp"
#include "findings/members_text.hpp"
#include "findings/pairs_text.hpp"
#include "findings/sensitivity_text.hpp"
#include "findings/steady_text.hpp"

namespace floes {

namespace {

std::string joined(const std::vector<std::string>& parts) {
    return fmt::format("{}", fmt::join(parts, "\n"));
}

}  // namespace

std::string findings_table(const Findings& findings, int width) {
    std::vector<std::string> parts;
    if (findings.show_cases) parts.push_back(summary_table(findings.summary, width, findings.reference));
    if (findings.points) parts.push_back(points_table(*findings.points, width));
    if (findings.sensitivity) parts.push_back(sensitivity_table(*findings.sensitivity, width));
    if (findings.pairs) parts.push_back(pairs_table(findings.summary, *findings.pairs, findings.pair_options, width));
    if (findings.extremes && findings.show_extremes)
        parts.push_back(extremes_table(findings.summary, *findings.extremes, width));
    if (findings.levels) parts.push_back(levels_table(findings.summary, *findings.levels, width));
    if (findings.steady) parts.push_back(steady_table(findings.summary, *findings.steady, width));
    return joined(parts);
}

std::string findings_json(const Findings& findings) {
    Json json = summary_as_json(findings.summary, findings.reference);
    if (findings.points) json["design"] = points_as_json(*findings.points);
    if (findings.sensitivity) json["sensitivity"] = sensitivity_as_json(*findings.sensitivity);
    if (findings.pairs) json["pairs"] = pairs_as_json(findings.summary, *findings.pairs, findings.pair_options);
    if (findings.extremes)
        json["extremes"] = extremes_as_json(findings.summary, *findings.extremes, findings.exceedance);
    if (findings.levels) json["load_levels"] = levels_as_json(findings.summary, *findings.levels);
    if (findings.steady) json["steady"] = steady_as_json(findings.summary, *findings.steady);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string findings_csv(const Findings& findings) {
    std::vector<std::string> parts;
    if (findings.show_cases) parts.push_back(summary_csv(findings.summary, findings.reference));
    if (findings.points) parts.push_back(points_csv(*findings.points, findings.summary));
    if (findings.sensitivity) parts.push_back(sensitivity_csv(*findings.sensitivity));
    if (findings.pairs) parts.push_back(pairs_csv(findings.summary, *findings.pairs));
    if (findings.extremes && findings.show_extremes)
        parts.push_back(extremes_csv(findings.summary, *findings.extremes));
    if (findings.exceedance) parts.push_back(exceedance_csv(findings.summary, *findings.extremes));
    if (findings.levels && !findings.levels->empty()) parts.push_back(levels_csv(findings.summary, *findings.levels));
    if (findings.steady) parts.push_back(steady_csv(findings.summary, findings.table, *findings.steady));
    if (findings.members) parts.push_back(members_csv(findings.table));
    return joined(parts);
}

}  // namespace floes
