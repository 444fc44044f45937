#include "findings/catalogue.hpp"

#include <algorithm>
#include <array>

#include "findings/control_section.hpp"
#include "findings/design_load_section.hpp"
#include "findings/levels.hpp"
#include "findings/members.hpp"
#include "findings/pairs_section.hpp"
#include "findings/points.hpp"
#include "findings/report_sections.hpp"
#include "findings/sensitivity_section.hpp"
#include "findings/summary_section.hpp"

namespace floes {
namespace {

bool always(const Campaign&) {
    return true;
}

bool never(const Campaign&) {
    return false;
}

bool of_a_design(const Campaign& campaign) {
    return campaign.design.active();
}

bool of_few_cases(const Campaign& campaign) {
    return campaign.cases.size() > 1 && in_detail(campaign);
}

bool with_levels(const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases,
                               [](const Case& one) { return !one.scenario.analysis.exceedance_levels.empty(); });
}

bool of_many_cases(const Campaign& campaign) {
    return !in_detail(campaign);
}

/// A finding of one section.
template <Section (*section)(Evidence&)>
std::vector<Section> one(Evidence& evidence) {
    return {section(evidence)};
}

Section cases(Evidence& evidence) {
    return summary_section(evidence.summary, evidence.reference);
}

Section points(Evidence& evidence) {
    return points_section(find_points(evidence.campaign), evidence.summary);
}

Section sensitivity(Evidence& evidence) {
    return sensitivity_section(sensitivity_of(evidence));
}

Section pairs(Evidence& evidence) {
    const PairOptions options{evidence.reference, evidence.resolve};
    return pairs_section(evidence.summary, compare_pairs(evidence.table, options), options);
}

Section pairs_left_out(Evidence& evidence) {
    return {.before = unasked_text(evidence.summary) + "\n"};
}

Section extremes(Evidence& evidence) {
    return extremes_section(evidence.summary, extremes_of(evidence));
}

Section levels(Evidence& evidence) {
    return levels_section(evidence.summary, find_levels(evidence.table));
}

/// The exceedance curve of the maxima and the time above the levels that members counted.
std::vector<Section> exceedance(Evidence& evidence) {
    return {exceedance_section(evidence.summary, extremes_of(evidence)), levels(evidence)};
}

Section steady(Evidence& evidence) {
    if (!evidence.steady) evidence.steady = find_steady(evidence.file, evidence.table);
    return steady_section(evidence.summary, evidence.table, *evidence.steady);
}

/// As `floes design` has it by default.
std::vector<Section> design(Evidence& evidence) {
    const DesignLoads& found = designs_of(evidence);
    if (!found.of_cases.empty()) return design_load_sections(evidence.summary, found.of_cases, found.asked);
    return {
        {.missing = "Design load: unknown, because the members did not average their load (analysis.averaging_s).\n"}};
}

Section control(Evidence& evidence) {
    return control_section(evidence.summary, find_control(evidence.campaign, evidence.table));
}

Section members(Evidence& evidence) {
    return members_section(evidence.table);
}

Section one_value_a_line(Evidence& evidence) {
    return long_section(evidence.table);
}

constexpr std::array all{
    Finding{"cases", one<cases>, always},
    Finding{"", one<averaged_section>, never, "Loads", always},
    Finding{"", one<table3_section>, never, "Loads", always},
    Finding{"", one<what_was_run>, never, "What was run", always},
    Finding{"sensitivity", one<sensitivity>, of_a_design, "What decides the load?", of_a_design},
    Finding{"points", one<points>, never, "What decides the load?", of_a_design},
    Finding{"pairs", one<pairs>, in_detail, "Do the cases differ?", of_few_cases},
    Finding{"", one<pairs_left_out>, of_many_cases, "Do the cases differ?", of_many_cases},
    Finding{"", one<histories_section>, never, "Load over time", always},
    Finding{"", one<load_map_section>, never, "Where the load acts", always},
    Finding{"design", design, never, "Design load", in_detail},
    Finding{"extremes", one<extremes>, in_detail, "Extremes", in_detail},
    Finding{"", one<levels>, never, "Extremes", with_levels},
    Finding{"exceedance", exceedance, never},
    Finding{"steady", one<steady>, never},
    Finding{"control", one<control>, never},
    Finding{"", one<convergence_section>, never, "Uncertainty of the mean", always},
    Finding{"", one<failures_section>, never, "Broken floes", always},
    Finding{"", one<joint_failures_section>, never, "Where floes fail", always},
    Finding{"", one<largest_load_section>, never, "The arrangement with the largest load", always},
    Finding{"", one<closed_formulas_section>, never, "Elastic modulus and closed formulas", always},
    Finding{.name = "members", .sections = one<members>, .unasked = never, .for_csv_alone = true},
    Finding{.name = "long", .sections = one<one_value_a_line>, .unasked = never, .for_csv_alone = true},
};

}  // namespace

std::span<const Finding> findings() {
    return all;
}

}  // namespace floes
