#include "findings/catalogue.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "campaign_file/read_campaign_file.hpp"
#include "campaign_file/read_details.hpp"
#include "findings/control_section.hpp"
#include "findings/design_load_section.hpp"
#include "findings/extremes.hpp"
#include "findings/levels.hpp"
#include "findings/members.hpp"
#include "findings/pairs_section.hpp"
#include "findings/points.hpp"
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

Section cases(Evidence& evidence) {
    return summary_section(evidence.summary, evidence.reference);
}

Section points(Evidence& evidence) {
    return points_section(find_points(evidence.campaign), evidence.summary);
}

Section sensitivity(Evidence& evidence) {
    return sensitivity_section(find_sensitivity(evidence.campaign, evidence.table));
}

Section pairs(Evidence& evidence) {
    const PairOptions options{evidence.reference, evidence.resolve};
    return pairs_section(evidence.summary, compare_pairs(evidence.table, options), options);
}

/// Found once, whichever part asks first.
const std::vector<CaseExtremes>& extremes_of(Evidence& evidence) {
    if (!evidence.extremes) evidence.extremes = find_extremes(evidence.table);
    return *evidence.extremes;
}

Section extremes(Evidence& evidence) {
    return extremes_section(evidence.summary, extremes_of(evidence));
}

/// The exceedance curve of the maxima and the time above the levels that members counted.
Section exceedance(Evidence& evidence) {
    Section curve = exceedance_section(evidence.summary, extremes_of(evidence));
    Section levels = levels_section(evidence.summary, find_levels(evidence.table));
    levels.records.insert(levels.records.begin(), curve.records.begin(), curve.records.end());
    return levels;
}

Section steady(Evidence& evidence) {
    if (!evidence.steady) evidence.steady = find_steady(evidence.file, evidence.table);
    return steady_section(evidence.summary, evidence.table, *evidence.steady);
}

/// As `floes design` has it by default, without what it rests on.
Section design(Evidence& evidence) {
    const DesignLoadRequest request;
    std::vector<Section> sections = design_load_sections(
        evidence.summary, find_design_loads(with_peaks(evidence.file, evidence.table), request), request);
    Section loads = std::move(sections.front());
    for (Section& other : std::span(sections).subspan(1))
        std::ranges::move(other.records, std::back_inserter(loads.records));
    return loads;
}

Section control(Evidence& evidence) {
    return control_section(evidence.summary, find_control(evidence.campaign, evidence.table));
}

Section members(Evidence& evidence) {
    return members_section(evidence.table);
}

constexpr std::array all{
    Finding{"cases", cases, always},
    Finding{"points", points, never},
    Finding{"sensitivity", sensitivity, of_a_design},
    Finding{"pairs", pairs, in_detail},
    Finding{"extremes", extremes, in_detail},
    Finding{"exceedance", exceedance, never},
    Finding{"steady", steady, never},
    Finding{"control", control, never},
    Finding{"design", design, never},
    Finding{.name = "members", .section = members, .unasked = never, .for_csv_alone = true},
};

}  // namespace

std::span<const Finding> findings() {
    return all;
}

Evidence read_evidence(const CampaignFile& file, bool automatic_window, std::string_view reference) {
    Evidence evidence;
    evidence.file = file.path();
    evidence.origin = read_origin(file);
    evidence.campaign = file.campaign();
    evidence.table = read_campaign_file(file);
    if (automatic_window) {
        evidence.steady = find_steady(file, evidence.table);
        evidence.table = with_automatic_window(file, std::move(evidence.table), *evidence.steady);
    }
    evidence.summary = summarise(evidence.table);
    if (!reference.empty()) evidence.reference = case_index(evidence.summary, reference);
    return evidence;
}

}  // namespace floes
