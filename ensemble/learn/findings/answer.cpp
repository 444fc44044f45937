#include "findings/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "core/wording.hpp"
#include "findings/conditions.hpp"

namespace floes {
namespace {

constexpr std::size_t most_changes = 3;

/// "29.6 N (28.8 to 30.3)"; 95 % is said once, before.
std::string load(double value, double low, double high) {
    const int decimals = std::abs(value) < 100 ? 1 : 0;
    if (!std::isfinite(low)) return fmt::format("{:.{}f} N", value, decimals);
    return fmt::format("{1:.{0}f} N ({2:.{0}f} to {3:.{0}f})", decimals, value, low, high);
}

std::string load(const DesignLoadFigure& figure) {
    return load(figure.value, figure.interval.low, figure.interval.high);
}

/// nullptr where there is none.
const CaseDesignLoad* design_of(const DesignLoads& designs, std::size_t index) {
    const auto found = std::ranges::find(designs.of_cases, index, &CaseDesignLoad::case_index);
    return found == designs.of_cases.end() || !found->load.valid() ? nullptr : &*found;
}

std::string design_words(const DesignLoadRequest& asked, const DesignLoad& found) {
    const DesignLoadEstimate& made = found.estimates.front();
    return fmt::format(" Largest load averaged over {:g} s in {:g} h: expected {}, exceeded with {:.0f} %: {}.",
                       asked.averaging, asked.exposure / unit::hour, load(made.expected),
                       (1 - asked.quantiles.front()) / unit::percent, load(made.quantiles.front()));
}

const char* placing_words(ArrangementMethod method) {
    switch (method) {
        case ArrangementMethod::monte_carlo:
            return "in equilibrium";
        case ArrangementMethod::lattice:
            return "on a jittered lattice";
        case ArrangementMethod::file:
            return "as given in a file";
        case ArrangementMethod::scattered:
            break;
    }
    return "scattered at random";
}

std::string field_words(const Scenario& scenario) {
    return fmt::format("{} of {:g} m x {:g} m x {:g} m at {:g} %, {}; structure towed at {:g} m/s.",
                       counted(scenario.field.floes, "floe"), scenario.floe.length, scenario.floe.breadth,
                       scenario.floe.thickness, scenario.field.concentration / unit::percent,
                       placing_words(scenario.arrangement.method), scenario.structure.speed);
}

std::vector<std::string> load_sentences(const Summary& summary, const DesignLoads& designs) {
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& row = summary.cases[k];
        if (row.done == 0) continue;
        const Estimate& mean = row.of(quantity("mean_load"));
        const Estimate& broken = row.of(quantity("failure_ratio"));
        std::string told = fmt::format("{}: mean load {}.", row.about.name, load(mean.estimate, mean.low, mean.high));
        if (const CaseDesignLoad* design = design_of(designs, k)) told += design_words(designs.asked, design->load);
        told += fmt::format(" Broken floes {:.1f} %.", broken.estimate / unit::percent);
        sentences.push_back(std::move(told));
    }
    return sentences;
}

std::vector<std::string> basis_sentences(const Evidence& evidence, const DesignLoads& designs) {
    const Scenario& first = evidence.campaign.cases.front().scenario;
    std::vector<std::string> sentences{"Brackets are 95 % confidence intervals over arrangements.", field_words(first)};
    for (std::string& line : condition_lines(evidence.summary)) sentences.push_back(std::move(line));
    int done = 0;
    int unsteady = 0;
    for (const CaseSummary& row : evidence.summary.cases) {
        done += row.done;
        unsteady += row.not_steady;
    }
    sentences.push_back(fmt::format("{}, one for each case and arrangement; in {} of them the load still had a trend.",
                                    counted(done, "simulation"), unsteady));
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

std::vector<std::string> change_sentences(const Sensitivity& found) {
    struct Change {
        std::string told;
        double size;
    };
    std::vector<Change> changes;
    for (const SensitivityRow& row : found.rows) {
        if (row.quantity.key.view() != "mean_load" || !row.fit) continue;
        for (std::size_t axis = 0; axis < found.axes.size(); ++axis) {
            const Slope& slope = row.fit->slopes[axis];
            const SensitivityAxis& about = found.axes[axis];
            changes.push_back({fmt::format("{}{} from {:g} to {:g} changes the mean load by {:+.1f} N ({:+.1f} to "
                                           "{:+.1f}).",
                                           row.base.empty() ? "" : row.base + ": ", about.key, about.from, about.to,
                                           2 * slope.estimate, 2 * slope.low, 2 * slope.high),
                               std::abs(slope.estimate)});
        }
    }
    std::ranges::stable_sort(changes, std::ranges::greater{}, &Change::size);
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < std::min(changes.size(), most_changes); ++k) sentences.push_back(changes[k].told);
    if (sentences.empty())
        sentences.push_back("No key was varied in a design, so this campaign does not say what would change the load.");
    return sentences;
}

}  // namespace

CampaignAnswer find_answer(Evidence& evidence) {
    const DesignLoads designs = in_detail(evidence.campaign) ? designs_of(evidence) : DesignLoads{};
    return {load_sentences(evidence.summary, designs), basis_sentences(evidence, designs),
            change_sentences(sensitivity_of(evidence))};
}

}  // namespace floes
