#include "findings/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign_file/read.hpp"
#include "core/text.hpp"
#include "findings/points.hpp"

namespace floes {
namespace {

constexpr std::size_t most_drawn_cases = 6;

/// The largest mean maximum of a case decides the units of the campaign.
Units units_of(const Summary& summary) {
    double largest = 0;
    for (const CaseSummary& row : summary.cases)
        if (const double load = row.of(quantity("mean_maximum")).estimate; load > largest) largest = load;
    return Units(largest);
}

/// What follows from the campaign and its table.
void complete(Evidence& evidence) {
    evidence.sample = Sample(evidence.table);
    evidence.summary = summarise(evidence.table);
    evidence.summary.labels = point_labels(find_points(evidence.campaign));
    evidence.units = units_of(evidence.summary);
    evidence.reference = base_case(evidence.campaign);
}

}  // namespace

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
    complete(evidence);
    if (!reference.empty()) evidence.reference = case_index(evidence.summary, reference);
    return evidence;
}

Evidence evidence_of(Campaign campaign, CampaignTable table) {
    Evidence evidence;
    evidence.campaign = std::move(campaign);
    evidence.table = std::move(table);
    complete(evidence);
    return evidence;
}

const std::vector<CaseExtremes>& extremes_of(Evidence& evidence) {
    if (!evidence.extremes) evidence.extremes = find_extremes(evidence.table);
    return *evidence.extremes;
}

const Sensitivity& sensitivity_of(Evidence& evidence) {
    if (!evidence.sensitivity) evidence.sensitivity = find_sensitivity(evidence);
    return *evidence.sensitivity;
}

const DesignLoads& designs_of(Evidence& evidence) {
    if (evidence.designs) return *evidence.designs;
    DesignLoads& designs = evidence.designs.emplace(evidence.design_request.value_or(DesignLoadRequest{}));
    const std::vector<double>& times = evidence.table.averaging_times;
    if (times.empty()) return designs;
    if (!evidence.design_request && std::ranges::find(times, designs.asked.averaging) == times.end())
        designs.asked.averaging = times.back();
    designs.of_cases = find_design_loads(evidence.table, designs.asked);
    return designs;
}

const std::vector<BreakRow>& breaks_of(Evidence& evidence) {
    if (!evidence.breaks) evidence.breaks = read_breaks(evidence.file);
    return *evidence.breaks;
}

const std::vector<PieceRow>& pieces_of(Evidence& evidence) {
    if (!evidence.pieces) evidence.pieces = read_pieces(evidence.file);
    return *evidence.pieces;
}

std::vector<std::size_t> drawn_cases(const Summary& summary) {
    const auto load = [&](std::size_t k) { return summary.cases[k].of(quantity("mean_load")).estimate; };
    std::vector<std::size_t> cases;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (summary.cases[k].done > 0) cases.push_back(k);
    std::ranges::stable_sort(cases, std::ranges::greater{}, load);
    cases.resize(std::min(cases.size(), most_drawn_cases));
    std::ranges::sort(cases);
    return cases;
}

std::string undrawn_text(const Summary& summary) {
    const auto done = std::ranges::count_if(summary.cases, [](const CaseSummary& row) { return row.done > 0; });
    return done <= std::ssize(drawn_cases(summary))
               ? ""
               : fmt::format(" Only the {} cases with the largest mean loads are shown.", most_drawn_cases);
}

std::string replay_command(const Evidence& evidence, int member, std::string_view of) {
    return fmt::format("floes replay {} {} --worst{} -o worst.html", shell_word(evidence.file.filename().string()),
                       member, of.empty() ? "" : fmt::format(" --of {}", of));
}

std::optional<int> most_loaded_member(const Evidence& evidence) {
    const std::vector<MemberRow>& members = evidence.table.members;
    std::optional<int> most;
    for (std::size_t k = 0; k < members.size(); ++k)
        if (members[k].done() &&
            (!most || members[k].load.maximum > members[static_cast<std::size_t>(*most)].load.maximum))
            most = static_cast<int>(k);
    return most;
}

}  // namespace floes
