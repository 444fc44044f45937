#include "findings/answer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/shell_word.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/cases.hpp"
#include "findings/conditions.hpp"
#include "findings/model_width.hpp"
#include "findings/moored_cases.hpp"
#include "findings/pairs.hpp"
#include "findings/points.hpp"
#include "findings/sensitivity.hpp"
#include "findings/summary.hpp"
#include "findings/warnings.hpp"

namespace floes {

namespace {

constexpr std::size_t most_changes = 3;        // of an answer
constexpr std::size_t most_changes_shown = 6;  // on the screen
constexpr std::size_t most_cases = 7;          // the first and those compared with it
constexpr std::string_view apart_words =
    "Cases begin from other floes: differences are of means (Welch), not by arrangement.";

/// "29.6 N (28.8 to 30.3)"; 95 % is said once, before. Limits that say nothing are left out.
std::string load(const Estimate& mean, const Units& units) {
    const std::string text = units.text(mean.value, "N");
    if (!mean.said) return text;
    return text + fmt::format(" ({} to {})", units.number(mean.low, "N"), units.number(mean.high, "N"));
}

std::string load(const DesignLoadFigure& figure, int runs, const Units& units) {
    const Limits& limits = figure.interval;
    return load({figure.value, limits.low, limits.high, says_something(figure.value, limits, runs)}, units);
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

std::string design_words(const DesignLoadRequest& asked, const DesignLoad& found, const Units& units) {
    const DesignLoadEstimate& made = found.estimates.front();
    return fmt::format(" Largest load averaged over {:g} s in {:g} h: expected {}, exceeded with {:.0f} %: {}{}.",
                       asked.averaging, asked.exposure / unit::hour, load(made.expected, found.arrangements, units),
                       (1 - asked.quantiles.front()) / unit::percent,
                       load(made.quantiles.front(), found.arrangements, units), doubt_words(asked, found));
}

/// "n = 2" or "3 of 8 not steady", beside the mean that it is about.
std::string mean_doubts(const CaseSummary& row) {
    std::vector<std::string> doubts;
    if (row.done < fewest_for_interval) doubts.push_back(fmt::format("n = {}", row.done));
    if (row.not_steady > 0) doubts.push_back(fmt::format("{} of {} not steady", row.not_steady, row.done));
    return doubts.empty() ? "" : fmt::format(" [{}]", fmt::join(doubts, ", "));
}

/// A design's points in two sentences; the table of them has the rest.
std::vector<std::string> design_sentences(const Summary& summary, const Units& units) {
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (summary.cases[k].done > 0) done.push_back(k);
    if (done.empty()) return {};
    const auto mean = [&](std::size_t k) { return summary.cases[k].of(quantity("mean_load")).estimate; };
    const auto [least, most] = std::ranges::minmax_element(done, {}, mean);
    std::vector<std::string> sentences;
    for (const auto& [words, k] : {std::pair{"Least", *least}, {"Largest", *most}}) {
        const CaseSummary& row = summary.cases[k];
        sentences.push_back(
            fmt::format("{} mean load of the {}: {} at {}{}.", words, counted(std::ssize(done), "point"),
                        load(estimate_of(row, quantity("mean_load")), units), summary.label_of(k), mean_doubts(row)));
    }
    return sentences;
}

/// " Design mooring force in 3 h: exceeded with 10 %: 4.03 MN (3.32 to 7.61).", or why it is not known.
std::string mooring_words(const Evidence& evidence, const SimulatedDesign& design, std::size_t index) {
    const DesignOf& of = design.request.of;
    if (!design.refused.empty()) return " " + design.refused;
    const auto found = std::ranges::find(design.of_cases, index, &CaseDesignLoad::case_index);
    if (found == design.of_cases.end()) return "";
    if (!found->load.valid())
        return fmt::format(" {}: {}", of.title, none_text(*found, evidence.summary.cases[index].about));
    const DesignLoadFigure& figure = found->load.estimates.front().quantiles.front();
    const double factor = design.request.factor();
    std::string told = evidence.units.text(factor * figure.value, of.unit);
    if (says_something(figure.value, figure.interval, found->load.arrangements))
        told += fmt::format(" ({} to {})", evidence.units.number(factor * figure.interval.low, of.unit),
                            evidence.units.number(factor * figure.interval.high, of.unit));
    return fmt::format(" {} in {:g} h, exceeded with {:.0f} %: {}{}.", of.title, design.request.exposure / unit::hour,
                       (1 - design.request.quantiles.front()) / unit::percent, told,
                       doubt_words(design.request, found->load));
}

/// For every case, or for one alone.
std::vector<std::string> load_sentences(const Evidence& evidence, const DesignLoads& designs,
                                        std::span<const SimulatedDesign> simulated, std::optional<std::size_t> alone) {
    const Summary& summary = evidence.summary;
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& row = summary.cases[k];
        if (row.done == 0 || (alone && k != *alone)) continue;
        const CaseEstimate& broken = row.of(quantity("failure_ratio"));
        std::string told = fmt::format("{}: mean load {}{}.", summary.label_of(k),
                                       load(estimate_of(row, quantity("mean_load")), evidence.units), mean_doubts(row));
        if (const CaseDesignLoad* design = design_of(designs, k))
            told += design_words(designs.asked, design->load, evidence.units);
        for (const SimulatedDesign& design : simulated)
            if (design.request.of.word == "mooring_force" || design.request.of.word == "offset")
                told += mooring_words(evidence, design, k);
        told += fmt::format(" Broken floes {:.1f} %.", broken.estimate / unit::percent);
        sentences.push_back(std::move(told));
    }
    return sentences;
}

std::vector<std::string> basis_sentences(const Evidence& evidence, const DesignLoads& designs) {
    std::vector<std::string> sentences{"Brackets are 95 % confidence intervals over arrangements."};
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

/// "E60 instead of E30 changes the mean load by +0.1 N (-0.3 to +0.5)." Over the arrangements that both have, and of
/// cases that begin from other floes the difference of the means; of the variations of a base case those that change it
/// most, and what all do together.
std::vector<std::string> case_sentences(const Evidence& evidence) {
    struct Change {
        std::size_t second;
        Estimate difference;
        int arrangements;
        bool apart;
    };
    std::vector<std::string> sentences;
    const std::size_t reference = evidence.reference.value_or(0);
    const bool variations = base_case(evidence.campaign).has_value();
    const std::size_t most = variations ? evidence.table.cases.size() : most_cases;
    std::vector<Change> found;
    for (const PairRow& row : compare_with(evidence, reference, quantity("mean_load"), most))
        found.push_back({row.second, row.difference(), row.found.arrangements, false});
    for (const ApartRow& row : compare_apart(evidence, reference, quantity("mean_load"), most))
        found.push_back({row.second, row.difference(), row.fewest, true});
    std::ranges::stable_sort(found, {}, &Change::second);
    if (variations) {
        std::ranges::stable_sort(found, std::ranges::greater{},
                                 [](const Change& row) { return std::abs(row.difference.value); });
        found.resize(std::min(found.size(), most_changes));
        if (std::string told = width_sentence(find_model_width(evidence), evidence.units); !told.empty())
            sentences.push_back(std::move(told));
    }
    for (const Change& row : found)
        sentences.push_back(
            fmt::format("{} instead of {} changes the mean load by {}{}{}.", evidence.summary.label_of(row.second),
                        evidence.summary.label_of(reference), change_text(row.difference, evidence.units),
                        row.apart ? ", the difference of means" : "",
                        row.arrangements < fewest_for_interval ? fmt::format(" [n = {}]", row.arrangements) : ""));
    if (std::ranges::any_of(found, &Change::apart)) sentences.push_back(std::string{apart_words});
    return sentences;
}

/// "Thickness from 0.02 to 0.04 m changes the mean load by +5.4 N (2.1 to 8.7).", the strongest first.
std::vector<std::string> change_sentences(const Sensitivity& found, const Units& units, std::size_t most) {
    struct Change {
        std::string told;
        double size;
    };
    std::vector<Change> changes;
    for (const SensitivityRow& row : found.rows) {
        if (row.quantity.key.view() != "mean_load" || !row.fit) continue;
        for (std::size_t axis = 0; axis < found.axes.size(); ++axis) {
            changes.push_back({change_sentence(found, row, axis, units), std::abs(row.fit->slopes[axis].estimate)});
        }
    }
    std::ranges::stable_sort(changes, std::ranges::greater{}, &Change::size);
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < std::min(changes.size(), most); ++k) sentences.push_back(changes[k].told);
    return sentences;
}

std::vector<std::string> changes(Evidence& evidence) {
    std::vector<std::string> sentences = evidence.campaign.design.active()
                                             ? change_sentences(sensitivity_of(evidence), evidence.units, most_changes)
                                             : case_sentences(evidence);
    if (sentences.empty())
        sentences.push_back(evidence.summary.cases.size() < 2
                                ? "Nothing was varied, so this campaign does not say what would change the load."
                                : "Too few simulations are done to say what changes the load.");
    return sentences;
}

}  // namespace

CampaignAnswer find_answer(Evidence& evidence) {
    const DesignLoads designs = evidence.campaign.design.active() ? DesignLoads{} : designs_of(evidence);
    return {warnings_of(evidence.table, evidence.summary),
            evidence.campaign.design.active()
                ? design_sentences(evidence.summary, evidence.units)
                : load_sentences(evidence, designs, simulated_of(evidence), base_case(evidence.campaign)),
            basis_sentences(evidence, designs), changes(evidence)};
}

namespace {

std::string heading(const Evidence& evidence) {
    const Summary& summary = evidence.summary;
    int members = 0;
    bool equal = true;
    for (const CaseSummary& row : summary.cases) {
        members += row.members;
        equal = equal && row.members == summary.cases.front().members;
    }
    std::string text = fmt::format("Campaign {}: {}", summary.title, counted(members, "member"));
    if (!equal) return text + fmt::format(" in {}.\n", counted(std::ssize(summary.cases), "case"));
    return text + fmt::format(", {} x {}.\n", counted(std::ssize(summary.cases), "case"),
                              counted(summary.cases.front().members, "arrangement"));
}

/// Behind the columns that a row begins with: how many arrangements are done, and the loads.
void add_columns(const std::vector<LoadColumn>& loads, Results& table) {
    table.columns.push_back({.words = "n"});
    for (const LoadColumn& load : loads) table.columns.push_back(load.column());
}

void add_loads(const std::vector<LoadColumn>& loads, const CaseSummary& row, std::vector<Datum>& line) {
    line.emplace_back(row.done == row.members ? Datum(row.done)
                                              : Datum(fmt::format("{} of {}", row.done, row.members)));
    for (const LoadColumn& load : loads) line.emplace_back(estimate_of(row, load.quantity));
}

/// One row a case, with the difference to the reference where there is another case; `apart`: cases that begin from
/// other floes than it.
Results case_rows(const Evidence& evidence, const std::vector<LoadColumn>& loads, const std::vector<ApartRow>& apart) {
    const Summary& summary = evidence.summary;
    const std::size_t reference = evidence.reference.value_or(0);
    const bool compared = summary.cases.size() > 1 && (!evidence.campaign.design.active() || evidence.reference);
    std::vector<PairRow> pairs;
    Results table{.columns = {{.words = "case"}}};
    add_columns(loads, table);
    if (compared) {
        pairs = compare_with(evidence, reference, loads.front().quantity, most_overview_rows);
        ResultColumn difference = loads.front().column();
        difference.words = fmt::format("mean - {}", summary.label_of(reference));
        difference.form = ResultColumn::Form::difference;
        table.columns.push_back(std::move(difference));
    }
    for (std::size_t k = 0; k < std::min(summary.cases.size(), most_overview_rows); ++k) {
        std::vector<Datum> line{summary.label_of(k)};
        add_loads(loads, summary.cases[k], line);
        if (compared) {
            const auto pair = std::ranges::find(pairs, k, &PairRow::second);
            const auto means = std::ranges::find(apart, k, &ApartRow::second);
            if (k == reference) {
                line.emplace_back(Absent{});
            } else if (pair != pairs.end()) {
                line.emplace_back(pair->difference());
            } else {
                line.push_back(means != apart.end() ? Datum(means->difference()) : Undefined{});
            }
        }
        table.add(std::move(line));
    }
    return table;
}

/// A row for each point, its values in columns.
Results point_rows(const DesignPoints& points, const Summary& summary, const std::vector<LoadColumn>& loads) {
    const bool bases =
        std::ranges::any_of(points.rows, [&](const PointRow& row) { return row.base != points.rows.front().base; });
    Results table;
    if (bases) table.columns.push_back({.words = "case"});
    for (const KeyWords& words : axis_words(points)) table.columns.push_back({.words = words.heading()});
    add_columns(loads, table);
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        std::vector<Datum> line;
        if (bases) line.emplace_back(points.rows[k].base);
        for (const auto& value : points.rows[k].values) line.emplace_back(value_text(value));
        add_loads(loads, summary.cases[k], line);
        table.add(std::move(line));
    }
    return table;
}

/// Points with the least and the largest mean load, and in the notes where they lie.
void add_extreme_points(const Summary& summary, const std::vector<LoadColumn>& loads, Section& section) {
    const auto load = [](const CaseSummary& row) { return row.of(quantity("mean_load")).estimate; };
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (std::isfinite(load(summary.cases[k]))) done.push_back(k);
    if (done.empty()) return;
    const auto [least, most] =
        std::ranges::minmax_element(done, {}, [&](std::size_t k) { return load(summary.cases[k]); });
    Results table{.columns = {{.words = "point"}}};
    add_columns(loads, table);
    for (const auto& [words, k] : {std::pair{"least mean", *least}, {"largest mean", *most}}) {
        std::vector<Datum> line{words};
        add_loads(loads, summary.cases[k], line);
        table.add(std::move(line));
        section.notes.push_back(fmt::format("The {} is at {}.", words, summary.label_of(k)));
    }
    section.results.push_back(std::move(table));
}

}  // namespace

Section overview_section(const Evidence& evidence, const Sensitivity& sensitivity) {
    const Summary& summary = evidence.summary;
    const std::vector<LoadColumn> loads = load_columns(summary);
    Section section{.before = heading(evidence) + warning_lines(warnings_of(evidence.table, summary)) + "\n"};
    const bool design = evidence.campaign.design.active();
    const bool many = summary.cases.size() > most_overview_rows;
    std::string compared;  // how, if not arrangement by arrangement
    if (design) {
        if (many) {
            add_extreme_points(summary, loads, section);
        } else {
            section.results.push_back(point_rows(find_points(evidence.campaign), summary, loads));
        }
        for (std::string& sentence : change_sentences(sensitivity, evidence.units, most_changes_shown))
            section.notes.push_back(std::move(sentence));
    } else if (const std::optional<ModelWidth> width = find_model_width(evidence)) {
        section.results.push_back(variations_table(summary, *width, most_overview_rows));
        section.notes.push_back(width_sentence(width, evidence.units));
        if (const std::size_t all = width->variations.size(); all > most_overview_rows)
            section.notes.push_back(fmt::format("{} smaller changes: --parts model.", all - most_overview_rows));
        section.after = "\n" + load_columns_text(summary) + "\n";
        return section;
    } else {
        const std::vector<ApartRow> apart =
            compare_apart(evidence, evidence.reference.value_or(0), loads.front().quantity, most_overview_rows);
        section.results.push_back(case_rows(evidence, loads, apart));
        if (!apart.empty()) compared = " " + std::string{apart_words};
    }
    section.after = "\n" + load_columns_text(summary) + compared + "\n";
    if (many && !design)
        section.notes.push_back(fmt::format("{} more cases: --full.", summary.cases.size() - most_overview_rows));
    return section;
}

Section next_commands(const Evidence& evidence, const std::string& program) {
    const std::string file = shell_word(evidence.file.string());
    const std::optional<int> worst = most_loaded_member(evidence);
    std::vector<std::pair<std::string, std::string>> commands;
    commands.emplace_back(fmt::format("{} report {}", program, file), "everything on one page");
    if (worst)
        commands.emplace_back(fmt::format("{} replay {} --worst -o worst.html", program, file),
                              "the largest load, in a browser");
    if (std::ranges::any_of(evidence.campaign.cases, [](const Case& one) {
            return one.scenario.moorings.give_way() && one.scenario.analysis.keep_history;
        }))
        commands.emplace_back(fmt::format("{} design {} --of mooring_force", program, file),
                              "the design force of the moorings; --of offset");
    commands.emplace_back(fmt::format("{} summarize {} --full", program, file), "every figure");
    std::size_t widest = 0;
    for (const auto& [command, what] : commands) widest = std::max(widest, command.size());
    std::string text = fmt::format("In {}. Next:\n", evidence.file.string());
    for (const auto& [command, what] : commands) text += fmt::format("  {:{}}  {}\n", command, widest, what);
    return {.before = text};
}

}  // namespace floes
