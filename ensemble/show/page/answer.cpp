#include "page/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "core/wording.hpp"
#include "findings/conditions.hpp"
#include "page/html_parts.hpp"

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

const CaseDesignLoad* design_of(const ReportData& data, std::size_t index) {
    const auto found = std::ranges::find(data.designs, index, &CaseDesignLoad::case_index);
    return found == data.designs.end() || !found->load.valid() ? nullptr : &*found;
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

}  // namespace

std::vector<std::string> answer_sentences(const ReportData& data) {
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < data.summary.cases.size(); ++k) {
        const CaseSummary& row = data.summary.cases[k];
        if (row.done == 0) continue;
        const Estimate& mean = row.of(quantity("mean_load"));
        const Estimate& broken = row.of(quantity("failure_ratio"));
        std::string told = fmt::format("{}: mean load {}.", row.about.name, load(mean.estimate, mean.low, mean.high));
        if (const CaseDesignLoad* design = design_of(data, k)) told += design_words(data.asked, design->load);
        told += fmt::format(" Broken floes {:.1f} %.", broken.estimate / unit::percent);
        sentences.push_back(std::move(told));
    }
    return sentences;
}

std::vector<std::string> basis_sentences(const ReportData& data) {
    const Scenario& first = data.campaign.cases.front().scenario;
    std::vector<std::string> sentences{"Brackets are 95 % confidence intervals over arrangements.", field_words(first)};
    for (std::string& line : condition_lines(data.summary)) sentences.push_back(std::move(line));
    int done = 0;
    int unsteady = 0;
    for (const CaseSummary& row : data.summary.cases) {
        done += row.done;
        unsteady += row.not_steady;
    }
    sentences.push_back(fmt::format("{}, one for each case and arrangement; in {} of them the load still had a trend.",
                                    counted(done, "simulation"), unsteady));
    if (data.designs.empty()) return sentences;
    double times = 0;
    for (const CaseDesignLoad& one : data.designs)
        if (one.load.valid()) times = std::max(times, data.asked.model_exposure() / one.load.time_run);
    if (times > 0)
        sentences.push_back(fmt::format(
            "The largest load is extrapolated to {:.2g} times the time that was run, by two tails of declustered peaks "
            "weighted by their likelihoods; floes design has every method.",
            times));
    return sentences;
}

std::vector<std::string> change_sentences(const ReportData& data) {
    struct Change {
        std::string told;
        double size;
    };
    std::vector<Change> changes;
    if (data.sensitivity) {
        const Sensitivity& found = *data.sensitivity;
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
    }
    std::ranges::stable_sort(changes, std::ranges::greater{}, &Change::size);
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < std::min(changes.size(), most_changes); ++k) sentences.push_back(changes[k].told);
    if (sentences.empty())
        sentences.push_back("No key was varied in a design, so this campaign does not say what would change the load.");
    return sentences;
}

std::string answer_section(const std::string& title, const ReportData& data) {
    std::string body;
    for (const std::string& one : answer_sentences(data))
        body += fmt::format("<p class=\"answer\">{}</p>\n", html_escaped(one));
    if (body.empty()) body = paragraph("No member is done yet.");
    return section(title, body + "<h3>What it rests on</h3>\n" + listed(basis_sentences(data)) +
                              "<h3>What would change it</h3>\n" + listed(change_sentences(data)));
}

}  // namespace floes
