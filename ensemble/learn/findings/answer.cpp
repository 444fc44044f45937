#include "findings/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "core/wording.hpp"
#include "findings/common_ground.hpp"
#include "findings/conditions.hpp"
#include "findings/load_columns.hpp"
#include "findings/model_width.hpp"
#include "findings/pairs.hpp"
#include "findings/printable.hpp"
#include "findings/sensitivity_section.hpp"
#include "findings/warnings.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

constexpr std::size_t most_changes = 3;
constexpr std::size_t most_cases = 7;  // the first and those compared with it

/// "29.6 N (28.8 to 30.3)"; 95 % is said once, before. Limits that say nothing are left out.
std::string load(double value, const Limits& limits, int runs) {
    const LoadUnit unit = load_unit(std::abs(value));
    const int decimals = few_decimals(unit.factor * std::abs(value));
    const std::string text = fmt::format("{} {}", fixed(unit.factor * value, decimals), unit.name);
    if (!says_something(value, limits, runs)) return text;
    return text +
           fmt::format(" ({1:.{0}f} to {2:.{0}f})", decimals, unit.factor * limits.low, unit.factor * limits.high);
}

std::string load(const DesignLoadFigure& figure, int runs) {
    return load(figure.value, figure.interval, runs);
}

/// nullptr where there is none.
const CaseDesignLoad* design_of(const DesignLoads& designs, std::size_t index) {
    const auto found = std::ranges::find(designs.of_cases, index, &CaseDesignLoad::case_index);
    return found == designs.of_cases.end() || !found->load.valid() ? nullptr : &*found;
}

/// What a reader has to know with the figure, not after it: " (methods differ by 70 %, extrapolated 40 times)".
std::string doubt_words(const DesignLoadRequest& asked, const DesignLoad& found) {
    constexpr double far = 10;  // times the time that was run
    std::vector<std::string> doubts;
    if (const double apart = disagreement(found); apart > much_disagreement)
        doubts.push_back(fmt::format("methods differ by {:.0f} %", apart / unit::percent));
    if (const double times = asked.model_exposure() / found.time_run; times > far)
        doubts.push_back(fmt::format("extrapolated to {:.2g} times the time run", times));
    return doubts.empty() ? "" : fmt::format("; doubtful: {}", fmt::join(doubts, ", "));
}

std::string design_words(const DesignLoadRequest& asked, const DesignLoad& found) {
    const DesignLoadEstimate& made = found.estimates.front();
    return fmt::format(" Largest load averaged over {:g} s in {:g} h: expected {}, exceeded with {:.0f} %: {}{}.",
                       asked.averaging, asked.exposure / unit::hour, load(made.expected, found.arrangements),
                       (1 - asked.quantiles.front()) / unit::percent, load(made.quantiles.front(), found.arrangements),
                       doubt_words(asked, found));
}

/// "n = 2" or "3 of 8 not steady", beside the mean that it is about.
std::string mean_doubts(const CaseSummary& row) {
    std::vector<std::string> doubts;
    if (row.done < fewest_for_interval) doubts.push_back(fmt::format("n = {}", row.done));
    if (row.not_steady > 0) doubts.push_back(fmt::format("{} of {} not steady", row.not_steady, row.done));
    return doubts.empty() ? "" : fmt::format(" [{}]", fmt::join(doubts, ", "));
}

/// A design's points in two sentences; the table of them has the rest.
std::vector<std::string> design_sentences(const Summary& summary) {
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (summary.cases[k].done > 0) done.push_back(k);
    if (done.empty()) return {};
    const auto mean = [&](std::size_t k) { return summary.cases[k].of(quantity("mean_load")).estimate; };
    const auto [least, most] = std::ranges::minmax_element(done, {}, mean);
    std::vector<std::string> sentences;
    for (const auto& [words, k] : {std::pair{"Least", *least}, {"Largest", *most}}) {
        const CaseSummary& row = summary.cases[k];
        const Estimate& found = row.of(quantity("mean_load"));
        sentences.push_back(fmt::format(
            "{} mean load of the {}: {} at {}{}.", words, counted(std::ssize(done), "point"),
            load(found.estimate, {found.low, found.high}, row.done), summary.label_of(k), mean_doubts(row)));
    }
    return sentences;
}

/// Of every case, or of one alone.
std::vector<std::string> load_sentences(const Summary& summary, const DesignLoads& designs,
                                        std::optional<std::size_t> alone) {
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& row = summary.cases[k];
        if (row.done == 0 || (alone && k != *alone)) continue;
        const Estimate& mean = row.of(quantity("mean_load"));
        const Estimate& broken = row.of(quantity("failure_ratio"));
        std::string told = fmt::format("{}: mean load {}{}.", summary.label_of(k),
                                       load(mean.estimate, {mean.low, mean.high}, row.done), mean_doubts(row));
        if (const CaseDesignLoad* design = design_of(designs, k)) told += design_words(designs.asked, design->load);
        told += fmt::format(" Broken floes {:.1f} %.", broken.estimate / unit::percent);
        sentences.push_back(std::move(told));
    }
    return sentences;
}

std::vector<std::string> basis_sentences(const Evidence& evidence, const DesignLoads& designs) {
    std::vector<std::string> sentences{"Brackets are 95 % confidence intervals over arrangements.",
                                       field_words(evidence.campaign)};
    Summary stated = evidence.summary;
    if (const std::optional<std::size_t> base = base_case(evidence.campaign)) {
        stated.cases = {stated.cases[*base]};
        stated.labels.clear();
    } else {
        for (std::string& line : variation_lines(evidence.campaign, evidence.summary))
            sentences.push_back(std::move(line));
    }
    for (std::string& line : condition_lines(stated)) sentences.push_back(std::move(line));
    int done = 0;
    int unsteady = 0;
    for (const CaseSummary& row : evidence.summary.cases) {
        done += row.done;
        unsteady += row.not_steady;
    }
    sentences.push_back(fmt::format("{}, one for each case and arrangement; in {} of them the load still had a trend.",
                                    counted(done, "simulation"), unsteady == 0 ? "none" : fmt::format("{}", unsteady)));
    double times = 0;
    for (const CaseDesignLoad& one : designs.of_cases)
        if (one.load.valid()) times = std::max(times, designs.asked.model_exposure() / one.load.time_run);
    if (times > 0)
        sentences.push_back(fmt::format(
            "The largest load is extrapolated to {:.2g} times the time that was run, by two tails of declustered peaks "
            "weighted by their likelihoods; floes design has every method.",
            times));
    return sentences;
}

/// "E60 instead of E30 changes the mean load by +0.1 N (-0.3 to +0.5)." Over the arrangements that both have; of the
/// variations of a base case those that change it most, and what all do together.
std::vector<std::string> case_sentences(const Evidence& evidence) {
    std::vector<std::string> sentences;
    const std::size_t reference = evidence.reference.value_or(0);
    const bool variations = base_case(evidence.campaign).has_value();
    std::vector<PairRow> rows = compare_with(evidence.table, reference, quantity("mean_load"),
                                             variations ? evidence.table.cases.size() : most_cases);
    if (variations) {
        std::ranges::stable_sort(rows, std::ranges::greater{},
                                 [](const PairRow& row) { return std::abs(row.found.difference); });
        rows.resize(std::min(rows.size(), most_changes));
        if (std::string told = width_sentence(find_model_width(evidence)); !told.empty())
            sentences.push_back(std::move(told));
    }
    for (const PairRow& row : rows) {
        const LoadUnit unit = load_unit(std::abs(row.first_mean));
        const int decimals = few_decimals(unit.factor * std::abs(row.first_mean));
        const Limits& limits = row.found.interval;
        const bool said = row.found.arrangements >= fewest_for_interval && std::isfinite(limits.low);
        sentences.push_back(fmt::format("{} instead of {} changes the mean load by {:+.{}f} {}{}.",
                                        evidence.summary.label_of(row.second), evidence.summary.label_of(row.first),
                                        unit.factor * row.found.difference, decimals, unit.name,
                                        said ? fmt::format(" ({:+.{}f} to {:+.{}f})", unit.factor * limits.low,
                                                           decimals, unit.factor * limits.high, decimals)
                                             : fmt::format(" [n = {}]", row.found.arrangements)));
    }
    return sentences;
}

std::vector<std::string> change_sentences(const Sensitivity& found) {
    struct Change {
        std::string told;
        double size;
    };
    std::vector<Change> changes;
    for (const SensitivityRow& row : found.rows) {
        if (row.quantity.key.view() != "mean_load" || !row.fit) continue;
        for (std::size_t axis = 0; axis < found.axes.size(); ++axis) {
            changes.push_back({change_sentence(found, row, axis), std::abs(row.fit->slopes[axis].estimate)});
        }
    }
    std::ranges::stable_sort(changes, std::ranges::greater{}, &Change::size);
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < std::min(changes.size(), most_changes); ++k) sentences.push_back(changes[k].told);
    return sentences;
}

std::vector<std::string> changes(Evidence& evidence) {
    std::vector<std::string> sentences =
        evidence.campaign.design.active() ? change_sentences(sensitivity_of(evidence)) : case_sentences(evidence);
    if (sentences.empty())
        sentences.push_back("Nothing was varied, so this campaign does not say what would change the load.");
    return sentences;
}

}  // namespace

CampaignAnswer find_answer(Evidence& evidence) {
    const DesignLoads designs = evidence.campaign.design.active() ? DesignLoads{} : designs_of(evidence);
    return {warnings_of(evidence.table, evidence.summary),
            evidence.campaign.design.active() ? design_sentences(evidence.summary)
                                              : load_sentences(evidence.summary, designs, base_case(evidence.campaign)),
            basis_sentences(evidence, designs), changes(evidence)};
}

}  // namespace floes
