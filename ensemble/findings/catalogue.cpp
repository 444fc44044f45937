#include "findings/catalogue.hpp"

#include <algorithm>
#include <array>
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
constexpr auto never = [](const Campaign&) { return false; };
constexpr auto of_a_design = [](const Campaign& campaign) { return campaign.design.active(); };
constexpr auto without_design = [](const Campaign& campaign) { return !campaign.design.active(); };
constexpr auto with_base_case = [](const Campaign& campaign) { return base_case(campaign).has_value(); };

/// Cases that somebody wrote down to compare them with each other; the points of a design are told by their axes.
constexpr auto to_be_compared = [](const Campaign& campaign) {
    return campaign.cases.size() > 1 && !campaign.design.active() && !with_base_case(campaign);
};

constexpr auto with_levels = [](const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases,
                               [](const Case& one) { return !one.scenario.analysis.exceedance_levels.empty(); });
};

constexpr auto with_parts = [](const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases,
                               [](const Case& one) { return one.scenario.structure.shape.parts().size() > 1; });
};

constexpr auto with_moorings = [](const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases, [](const Case& one) { return one.scenario.moorings.give_way(); });
};

constexpr auto with_lines = [](const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases, [](const Case& one) {
        return one.scenario.moorings.give_way() && one.scenario.moorings.line_count() > 0;
    });
};

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

const SteadyReport& steady_of(Evidence& evidence) {
    return evidence.kept.once([&] { return find_steady(evidence.file, evidence.sample); });
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
    if (!found.of_cases.empty()) sections = design_load_sections(evidence.summary, found.of_cases, found.asked);
    std::ranges::move(simulated_designs(evidence), std::back_inserter(sections));
    return sections;
}

constexpr std::array all{
    Finding{"cases", one<cases>, always},
    Finding{overview_part, one<[](Evidence& e) { return overview_section(e, sensitivity_of(e)); }>, never},
    Finding{"answer", one<answer>, never},
    Finding{"points", one<points_section>, of_a_design, "What decides the load?", of_a_design},
    Finding{"sensitivity", sensitivity, of_a_design, "What decides the load?", of_a_design},
    Finding{"", one<[](Evidence& e) { return Section{.before = unasked_text(e.summary) + "\n"}; }>, of_a_design,
            "What decides the load?", of_a_design},
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
    Finding{"extremes", one<[](Evidence& e) { return extremes_section(e.summary, extremes_of(e)); }>, in_detail,
            "Extremes", in_detail},
    Finding{"", one<levels>, never, "Extremes", with_levels},
    Finding{"exceedance", exceedance, never},
    Finding{"fatigue", fatigue_sections, never},
    Finding{"lines", lines, with_lines},
    Finding{"moored", moored_sections, with_moorings, "On moorings", in_detail},
    Finding{"steady", one<[](Evidence& e) { return steady_section(e.summary, e.sample, steady_of(e)); }>, never},
    Finding{"control", one<control_section>, never},
    Finding{"", one<convergence_section>, never, "Uncertainty of the mean", always},
    Finding{"", one<failures_section>, never, "Broken floes", always},
    Finding{"pieces", one<piece_sizes_section>, never, "Broken floes", always},
    Finding{"", one<joint_failures_section>, never, "Where floes fail", always},
    Finding{"", one<largest_load_section>, never, "The arrangement with the largest load", always},
    Finding{"", one<closed_formulas_section>, never, "Elastic modulus and closed formulas", always},
    Finding{.name = "members",
            .sections = one<[](Evidence& e) { return members_section(e.sample); }>,
            .unasked = never,
            .for_csv_alone = true},
    Finding{.name = "long",
            .sections = one<[](Evidence& e) { return long_section(e.sample); }>,
            .unasked = never,
            .for_csv_alone = true},
};

}  // namespace

std::span<const Finding> findings() {
    return all;
}

}  // namespace floes
