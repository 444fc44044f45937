#include "findings/evidence.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "findings/design_points.hpp"
#include "findings/steady.hpp"

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
    evidence.summary = summarise(evidence.sample);
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
        const SteadyReport steady = find_steady(file, evidence.table);  // of the window that is left
        evidence.table = with_automatic_window(file, std::move(evidence.table), steady);
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

Oscillator MooredRequest::model() const {
    return {hull.stiffness / (scale * scale), hull.mass / force_factor(), hull.damping_ratio};
}

const std::vector<BreakRow>& breaks_of(Evidence& evidence) {
    return evidence.kept.once([&] { return read_breaks(evidence.file); });
}

const std::vector<PieceRow>& pieces_of(Evidence& evidence) {
    return evidence.kept.once([&] { return read_pieces(evidence.file); });
}

namespace {

/// Those with done members that may be drawn.
std::vector<std::size_t> drawable(const Summary& summary, const Which& which) {
    std::vector<std::size_t> cases;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (summary.cases[k].done > 0 && (!which || which(k))) cases.push_back(k);
    return cases;
}

}  // namespace

std::vector<std::size_t> drawn_cases(const Summary& summary, const Which& which) {
    const auto load = [&](std::size_t k) { return summary.cases[k].of(quantity("mean_load")).estimate; };
    std::vector<std::size_t> cases = drawable(summary, which);
    std::ranges::stable_sort(cases, std::ranges::greater{}, load);
    cases.resize(std::min(cases.size(), most_drawn_cases));
    std::ranges::sort(cases);
    return cases;
}

std::string undrawn_text(const Summary& summary, const Which& which) {
    return drawable(summary, which).size() <= most_drawn_cases
               ? ""
               : fmt::format(" Only the {} cases with the largest mean loads are shown.", most_drawn_cases);
}

std::string replay_command(const Evidence& evidence, int member, std::string_view of) {
    return fmt::format("floes replay {} {} --worst{} -o worst.html", shell_word(evidence.file.filename().string()),
                       member, of.empty() ? "" : fmt::format(" --of {}", of));
}

std::optional<int> most_loaded_member(const Evidence& evidence) {
    std::optional<int> most;
    double largest = 0;
    for (std::size_t member = 0; member < evidence.sample.members(); ++member) {
        const double load = evidence.sample.value(member, quantity("maximum_load"));
        if (evidence.sample.status(member) != RowStatus::done || (most && !(load > largest))) continue;
        most = static_cast<int>(member);
        largest = load;
    }
    return most;
}

}  // namespace floes
