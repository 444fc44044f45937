#include "report/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/json.hpp"
#include "report/pairs_text.hpp"

namespace floes {

namespace {

std::string joined(const std::vector<std::string>& parts) {
    return fmt::format("{}", fmt::join(parts, "\n"));
}

}  // namespace

std::string findings_table(const Findings& findings, int width) {
    std::vector<std::string> parts;
    if (findings.show_cases) parts.push_back(summary_table(findings.summary, width, findings.reference));
    if (findings.pairs) parts.push_back(pairs_table(findings.summary, *findings.pairs, findings.pair_options, width));
    return joined(parts);
}

std::string findings_json(const Findings& findings) {
    Json json = summary_as_json(findings.summary, findings.reference);
    if (findings.pairs) json["pairs"] = pairs_as_json(findings.summary, *findings.pairs, findings.pair_options);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string findings_csv(const Findings& findings) {
    std::vector<std::string> parts;
    if (findings.show_cases) parts.push_back(summary_csv(findings.summary, findings.reference));
    if (findings.pairs) parts.push_back(pairs_csv(findings.summary, *findings.pairs));
    return joined(parts);
}

}  // namespace floes
