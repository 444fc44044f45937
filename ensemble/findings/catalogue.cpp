#include "findings/catalogue.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "findings/answer.hpp"
#include "findings/cases.hpp"
#include "findings/catalogue.hpp"
#include "findings/control.hpp"
#include "findings/design_load.hpp"
#include "findings/energy.hpp"
#include "findings/extremes.hpp"
#include "findings/failures.hpp"
#include "findings/fatigue.hpp"
#include "findings/members.hpp"
#include "findings/model_width.hpp"
#include "findings/moored_cases.hpp"
#include "findings/pairs.hpp"
#include "findings/parts.hpp"
#include "findings/points.hpp"
#include "findings/sensitivity.hpp"
#include "findings/warnings.hpp"

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

bool with_base_case(const Campaign& campaign) {
    return base_case(campaign).has_value();
}

/// Cases that somebody wrote down to compare them with each other; the points of a design are told by their axes.
bool to_be_compared(const Campaign& campaign) {
    return campaign.cases.size() > 1 && !campaign.design.active() && !with_base_case(campaign);
}

bool with_levels(const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases,
                               [](const Case& one) { return !one.scenario.analysis.exceedance_levels.empty(); });
}

bool with_parts(const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases,
                               [](const Case& one) { return one.scenario.structure.shape.parts().size() > 1; });
}

bool with_moorings(const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases, [](const Case& one) { return one.scenario.moorings.give_way(); });
}

bool without_design(const Campaign& campaign) {
    return !campaign.design.active();
}

/// A finding of one section.
template <Section (*section)(Evidence&)>
std::vector<Section> one(Evidence& evidence) {
    return {section(evidence)};
}

Section cases(Evidence& evidence) {
    Section section = summary_section(evidence.summary, evidence.reference);
    section.before = warning_lines(warnings_of(evidence.table, evidence.summary)) + section.before;
    return section;
}

Section overview(Evidence& evidence) {
    return overview_section(evidence, sensitivity_of(evidence));
}

Section points(Evidence& evidence) {
    return points_section(evidence);
}

const SteadyReport& steady_of(Evidence& evidence) {
    if (!evidence.steady) evidence.steady = find_steady(evidence.file, evidence.table);
    return *evidence.steady;
}

/// What the axes do, and what is left of the scatter.
std::vector<Section> sensitivity(Evidence& evidence) {
    const SteadyReport steady = evidence.file.empty() ? SteadyReport{} : steady_of(evidence);
    return {sensitivity_section(sensitivity_of(evidence)), scatter_section(find_scatter(evidence, steady))};
}

Section pairs(Evidence& evidence) {
    const bool others = !base_case(evidence.campaign) || evidence.reference != base_case(evidence.campaign);
    const PairOptions options{.reference = evidence.reference, .others = others, .resolve = evidence.resolve};
    return pairs_section(evidence.summary, compare_pairs(evidence, options), options);
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
    return steady_section(evidence.summary, evidence.table, steady_of(evidence));
}

/// As `floes design` has it by default.
std::vector<Section> design(Evidence& evidence) {
    const DesignLoads& found = designs_of(evidence);
    std::vector<Section> sections{
        {.missing = "Design load: unknown, because the members did not average their load (analysis.averaging_s).\n"}};
    if (!found.of_cases.empty()) sections = design_load_sections(evidence.summary, found.of_cases, found.asked);
    std::ranges::move(simulated_designs(evidence), std::back_inserter(sections));
    return sections;
}

Section members(Evidence& evidence) {
    return members_section(evidence.table);
}

Section one_value_a_line(Evidence& evidence) {
    return long_section(evidence.table);
}

constexpr std::array all{
    Finding{"cases", one<cases>, always},
    Finding{overview_part, one<overview>, never},
    Finding{"points", one<points>, of_a_design, "What decides the load?", of_a_design},
    Finding{"sensitivity", sensitivity, of_a_design, "What decides the load?", of_a_design},
    Finding{"", one<pairs_left_out>, of_a_design, "What decides the load?", of_a_design},
    Finding{"", one<averaged_section>, never, loads_title, always},
    Finding{"", one<table3_section>, never, loads_title, always},
    Finding{"", one<what_was_run>, never, "What was run", always},
    Finding{.name = "pairs",
            .sections = one<pairs>,
            .unasked = without_design,
            .page_title = "Do the cases differ?",
            .on_page = to_be_compared,
            .unasked_in_json = in_detail},
    Finding{"model", one<model_section>, with_base_case, "What does the model leave open?", with_base_case},
    Finding{"", one<histories_section>, never, "Load over time", always},
    Finding{"", one<load_map_section>, never, "Where the load acts", always},
    Finding{"hull", parts_sections, with_parts, "Parts of the hull", with_parts},
    Finding{"energy", one<energy_section>, never, "Where the work goes", always},
    Finding{"design", design, never, "Design load", in_detail},
    Finding{"extremes", one<extremes>, in_detail, "Extremes", in_detail},
    Finding{"", one<levels>, never, "Extremes", with_levels},
    Finding{"exceedance", exceedance, never},
    Finding{"fatigue", fatigue_sections, never},
    Finding{"moored", moored_sections, with_moorings, "On moorings", in_detail},
    Finding{"steady", one<steady>, never},
    Finding{"control", one<control_section>, never},
    Finding{"", one<convergence_section>, never, "Uncertainty of the mean", always},
    Finding{"", one<failures_section>, never, "Broken floes", always},
    Finding{"pieces", one<piece_sizes_section>, never, "Broken floes", always},
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
