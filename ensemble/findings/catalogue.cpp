#include "findings/catalogue.hpp"

#include <algorithm>
#include <iterator>

#include "findings/answer.hpp"
#include "findings/cases.hpp"
#include "findings/design_load.hpp"
#include "findings/extremes.hpp"
#include "findings/moored.hpp"
#include "findings/overview.hpp"
#include "findings/page_one.hpp"
#include "findings/pairs.hpp"
#include "findings/points.hpp"
#include "findings/steady.hpp"

namespace floes {
namespace {

constexpr auto always = [](const Campaign&) { return true; };
constexpr auto of_a_design = [](const Campaign& campaign) { return campaign.design.active(); };
constexpr auto without_design = [](const Campaign& campaign) { return !campaign.design.active(); };
constexpr auto with_base_case = [](const Campaign& campaign) { return base_case(campaign).has_value(); };

/// Points of a design are told by their axes.
constexpr auto of_written_cases = [](const Campaign& campaign) {
    return campaign.cases.size() > 1 && !campaign.design.active();
};

/// Cases that somebody wrote down to compare them with each other.
constexpr auto to_be_compared = [](const Campaign& campaign) {
    return of_written_cases(campaign) && !with_base_case(campaign);
};

bool any(const Campaign& campaign, bool (*has)(const Scenario&)) {
    return std::ranges::any_of(campaign.cases, has, &Case::scenario);
}

bool with_levels(const Campaign& campaign) {
    return any(campaign, [](const Scenario& one) { return !one.analysis.exceedance_levels.empty(); });
}

bool with_parts(const Campaign& campaign) {
    return any(campaign, [](const Scenario& one) { return one.structure.shape.parts().size() > 1; });
}

bool with_moorings(const Campaign& campaign) {
    return any(campaign, [](const Scenario& one) { return one.moorings.give_way(); });
}

bool with_lines(const Campaign& campaign) {
    return any(campaign, [](const Scenario& one) { return one.moorings.give_way() && one.moorings.line_count() > 0; });
}

/// A finding of one section, which `section` makes of the evidence.
template <auto section>
std::vector<Section> one(Evidence& evidence) {
    return {section(evidence)};
}

Section cases(Evidence& evidence) {
    Section section = summary_section(evidence.summary, evidence.reference);
    section.before = warning_lines(warnings_of(evidence.sample, evidence.summary)) + section.before;
    return section;
}

const std::vector<CaseExtremes>& extremes_of(Evidence& evidence) {
    return evidence.kept.once([&] { return find_extremes(evidence.sample); });
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

Section levels(Evidence& evidence) {
    return levels_section(evidence.summary, find_levels(evidence.sample));
}

/// The exceedance curve of the maxima and the time above the levels that members counted.
std::vector<Section> exceedance(Evidence& evidence) {
    return {exceedance_section(evidence.summary, extremes_of(evidence)), levels(evidence)};
}

/// The first page of the report.
Section answer(Evidence& evidence) {
    PageOne page = find_page_one(evidence);
    page.table.after = "\n" + page.table.after + "\n";
    if (!page.sentence.empty()) page.table.notes.push_back(std::move(page.sentence));
    for (const auto& [what, command] : page.next) page.table.notes.push_back(what + ":\n  " + command);
    return std::move(page.table);
}

std::vector<Section> lines(Evidence& evidence) {
    if (std::optional<Section> found = mooring_lines_section(evidence)) return {std::move(*found)};
    return {{.missing = "Mooring lines: there are none in structures that give way.\n"}};
}

/// As `floes design` has it by default.
std::vector<Section> design(Evidence& evidence) {
    const DesignLoads& found = designs_of(evidence);
    std::vector<Section> sections{
        {.missing = "Design load: unknown, because the members did not average their load (analysis.averaging_s).\n"}};
    if (!found.of_cases.empty()) sections = design_load_sections(evidence.summary, found);
    std::ranges::move(simulated_designs(evidence), std::back_inserter(sections));
    return sections;
}

constexpr Finding all[]{
    {.name = "cases",
     .sections = one<cases>,
     .holds = "a line for each case: means over arrangements with their 95 % intervals: _low and _high by Student's t, "
              "_prediction_ of one further run",
     .unasked = always,
     .unasked_in_workbook = always},
    {overview_part, one<overview_section>},
    {.name = "answer",
     .sections = one<answer>,
     .holds = "the first page of the report: a line for each case, with differences to the base case"},
    {.name = "points",
     .sections = one<points_section>,
     .page_title = "What decides the load?",
     .on_page = of_a_design,
     .holds = "the points of the design with their results",
     .unasked = of_a_design,
     .unasked_in_workbook = of_a_design},
    {"sensitivity", sensitivity, "What decides the load?", of_a_design, "which keys decide the load", of_a_design},
    {"", one<[](Evidence& e) { return Section{.before = unasked_text(e.summary) + "\n"}; }>, "What decides the load?",
     of_a_design, "", of_a_design},
    {"", one<averaged_section>, loads_title, always},
    {"", one<table3_section>, loads_title, always},
    {"", one<what_was_run>, "What was run", always},
    {.name = "pairs",
     .sections = one<pairs>,
     .page_title = "Do the cases differ?",
     .on_page = to_be_compared,
     .holds = "differences of two cases within the same arrangements, with their 95 % intervals and tests",
     .unasked = without_design,
     .unasked_in_json = in_detail,
     .unasked_in_workbook = of_written_cases},
    {"model", one<model_section>, "What does the model leave open?", with_base_case,
     "what the model leaves open, from the cases of floes vary", with_base_case},
    {"", one<histories_section>, "Load over time", always},
    {"", one<load_map_section>, "Where the load acts", always},
    {"hull", parts_sections, "Parts of the hull", with_parts,
     "loads on the parts of the hull, and moments on it about its axis at the waterline", with_parts},
    {"energy", one<energy_section>, "Where the work goes", always,
     "where the work of the tow goes, over the distance towed"},
    {"design", design, "Design load", in_detail, "the largest load in an exposure"},
    {"extremes", one<[](Evidence& e) { return extremes_section(e.summary, extremes_of(e)); }>, "Extremes", in_detail,
     "fits of the maxima, and return levels", in_detail},
    {"", one<levels>, "Extremes", with_levels},
    {.name = "exceedance", .sections = exceedance, .holds = "how often maxima exceed a load"},
    {.name = "fatigue",
     .sections = fatigue_sections,
     .holds = "rainflow cycles, equivalent ranges, and time above levels"},
    {.name = "lines",
     .sections = lines,
     .holds = "the largest tension of each mooring line, over its break load",
     .unasked = with_lines},
    {.name = "moored",
     .sections = moored_sections,
     .page_title = "On moorings",
     .on_page = in_detail,
     .holds = "a hull on moorings: offset, mooring force and amplification, and these over its natural period",
     .unasked = with_moorings,
     .unasked_in_workbook = with_moorings},
    {.name = "steady", .sections = one<steady_section>, .holds = "when the load became steady"},
    {.name = "control",
     .sections = one<control_section>,
     .holds = "means corrected for the order of the floes and the coverage ahead"},
    {"", one<convergence_section>, "Uncertainty of the mean", always},
    {"", one<failures_section>, "Broken floes", always},
    {"pieces", one<piece_sizes_section>, "Broken floes", always, "sizes of the ice at the start and at the end"},
    {"", one<joint_failures_section>, "Where floes fail", always},
    {"", one<largest_load_section>, "The arrangement with the largest load", always},
    {"", one<closed_formulas_section>, "Elastic modulus and closed formulas", always},
    {.name = "members",
     .sections = one<members_section>,
     .holds = "a line for each simulation",
     .unasked_in_workbook = always,
     .for_csv_alone = true},
    {.name = "long",
     .sections = one<long_section>,
     .holds = "a line for each value of each simulation",
     .for_csv_alone = true},
};

}  // namespace

std::span<const Finding> findings() {
    return all;
}

}  // namespace floes
