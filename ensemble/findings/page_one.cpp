#include "findings/page_one.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign_file/read.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/cases.hpp"
#include "findings/design_load.hpp"
#include "findings/design_points.hpp"
#include "findings/moored.hpp"
#include "findings/pairs.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

/// One figure of all cases, with what each lacks for it.
struct CaseFigure {
    ResultColumn about;
    std::string noun;                      ///< before a value in a sentence: "a mooring force of"
    std::vector<Datum> values;             ///< by case: an estimate, or why there is none
    std::vector<Datum> differences;        ///< to the base case; absent for itself
    std::vector<int> more;                 ///< arrangements that would give it, or half its interval; 0: none asked for
    std::string later = {};                ///< options that measure it later, where it rises in some case
    std::vector<std::string> doubts = {};  ///< of the cases that have it, in a sentence each
    bool apart = false;                    ///< some difference is of cases that have nothing in common

    CaseFigure(ResultColumn column, std::string before_a_value, std::size_t cases)
        : about(std::move(column)),
          noun(std::move(before_a_value)),
          values(cases, Undefined{}),
          differences(cases, Undefined{}),
          more(cases, 0) {}

    bool of_design() const { return about.key.starts_with("design_"); }
    const Estimate* estimate(std::size_t of_case) const { return std::get_if<Estimate>(&values[of_case].get()); }
    const Estimate* difference(std::size_t of_case) const { return std::get_if<Estimate>(&differences[of_case].get()); }
};

/// ", about 2.1 h of a core" for so many further members; empty where their wall time is not known.
std::string cost_words(const Evidence& evidence, double members) {
    const std::vector<double> times = read_wall_times(evidence.file);
    std::vector<double> of_done;
    for (std::size_t k = 0; k < std::min(times.size(), evidence.sample.members()); ++k)
        if (evidence.sample.status(k) == RowStatus::done && std::isfinite(times[k])) of_done.push_back(times[k]);
    const double of_member = mean_of(of_done);
    return of_member > 0 ? fmt::format(", about {} of a core", duration_text(members * of_member)) : "";
}

CaseFigure mean_figure(const Evidence& evidence, const Quantity& of, const std::string& words) {
    const Summary& summary = evidence.summary;
    const std::size_t cases = summary.cases.size();
    CaseFigure made(estimates(std::string{of.key.view()}, words, unit_of(of)), words, cases);
    if (of.percent) made.about.decimals = 1;
    for (std::size_t k = 0; k < cases; ++k) {
        const CaseSummary& row = summary.cases[k];
        if (row.done == 0) {
            made.values[k] = Undefined{"no result yet"};
            continue;
        }
        made.values[k] = estimate_of(row, of);
        if (row.done < fewest_for_interval) made.more[k] = 8 - row.done;
    }
    if (!evidence.compared()) return made;
    const std::size_t base = evidence.base();
    made.differences[base] = Absent{};
    for (const PairRow& row : compare_with(evidence, base, of, cases)) made.differences[row.second] = row.difference();
    for (const ApartRow& row : compare_apart(evidence, base, of, cases)) {
        made.differences[row.second] = row.difference();
        made.apart = true;
    }
    return made;
}

/// What a reader has to know with the figure: "methods differ by 70 %, extrapolated to 40 times the time run".
std::string doubt_words(const DesignLoadRequest& asked, const DesignLoad& found) {
    constexpr double far = 10;  // times the time that was run
    std::vector<std::string> doubts;
    if (const double apart = disagreement(found); found.unlike.out.empty() && apart > much_disagreement)
        doubts.push_back(fmt::format("methods differ by {:.0f} %", apart / unit::percent));
    if (const double times = asked.model_exposure() / found.time_run; times > far)
        doubts.push_back(fmt::format("extrapolated to {:.2g} times the time run", times));
    return fmt::format("{}", fmt::join(doubts, ", "));
}

/// The options of floes design that ask the same.
std::string options_of(const DesignLoadRequest& asked) {
    const DesignLoadRequest usual;
    std::string text = fmt::format("--of {}", asked.of.word);
    if (asked.of.word == usual.of.word && asked.averaging != usual.averaging)
        text += fmt::format(" --averaging-s {:g}", asked.averaging);
    if (asked.exposure != usual.exposure) text += fmt::format(" --exposure-h {:g}", asked.exposure / unit::hour);
    if (asked.quantiles != usual.quantiles) text += fmt::format(" --quantile {:g}", fmt::join(asked.quantiles, ","));
    return text;
}

/// What people call a design value.
struct FigureWords {
    std::string_view of;  ///< DesignOf::word
    std::string_view heading;
    std::string_view noun;
};

constexpr FigureWords words_of_load{"load", "design load", "a load of"};
constexpr FigureWords moored_words[]{
    {"mooring_force", "design mooring force", "a mooring force of"},
    {"offset", "design offset", "an offset of"},
    {"line_tension", "line tension / break load", "a line tension over its break load of"},
    {"yaw", "design turn of heading", "a turn of heading of"}};

/// A design value of all cases that have one.
CaseFigure design_figure(const Evidence& evidence, const DesignLoads& designs, const FigureWords& words) {
    const DesignLoadRequest& request = designs.asked;
    const std::size_t cases = evidence.summary.cases.size();
    ResultColumn column = estimates("design_" + std::string{request.of.word}, std::string{words.heading},
                                    std::string{request.of.shown_unit()});
    column.digits = 3;
    CaseFigure made(std::move(column), std::string{words.noun}, cases);
    const double factor = request.factor() * request.of.shown_factor();
    const auto of_case = [&](std::size_t index) {
        return std::ranges::find(designs.of_cases, index, &CaseDesignLoad::case_index);
    };
    for (const CaseDesignLoad& one : designs.of_cases) {
        Datum& value = made.values[one.case_index];
        int& more = made.more[one.case_index];
        if (one.refused) {
            value = Undefined{fmt::format("rises, {}", change_words(one.trend))};
            if (evidence.sample.cases[one.case_index].can_be_measured_later()) made.later = options_of(request);
        } else if (!one.load.valid()) {
            more = more_arrangements(one);
            value = Undefined{one.lacks  ? one.lacks.in_brief
                              : more > 0 ? fmt::format("needs {} more", more)
                                         : "no tail fits its peaks"};
        } else {
            const LoadFigure& found = one.load.estimates.front().quantiles.front();
            const bool said = says_something(found.value, found.interval, static_cast<int>(one.load.arrangements));
            value = factor * within(found.value, found.interval, said);
            if (!said) more = more_arrangements(one);
            if (const std::string doubts = doubt_words(request, one.load); !doubts.empty())
                made.doubts.push_back(fmt::format("Doubtful: {} of {}: {}.", words.heading,
                                                  evidence.summary.label_of(one.case_index), doubts));
        }
    }
    const std::size_t base = evidence.base();
    if (!evidence.compared() || of_case(base) == designs.of_cases.end()) return made;
    made.differences[base] = Absent{};
    for (const CaseDesignLoad& one : designs.of_cases)
        if (one.case_index != base)
            if (const auto found = difference_of(*of_case(base), one, request)) {
                made.differences[one.case_index] = found->difference;
                made.apart = made.apart || !found->paired;
            }
    return made;
}

std::vector<CaseFigure> figures_of(Evidence& evidence) {
    std::vector<CaseFigure> all;
    for (const FigureWords& words : moored_words)
        for (const DesignLoads& design : simulated_of(evidence)) {
            if (design.asked.of.word != words.of) continue;
            CaseFigure& made = all.emplace_back(design_figure(evidence, design, words));
            if (words.of == "line_tension") made.about.limit = 1 / evidence.safety_factor;
            if (!design.refused.empty())
                std::ranges::fill(made.values, Undefined{evidence.summary.counts().done == 0
                                                             ? "no result yet"
                                                             : design.refused.substr(design.refused.find(": ") + 2)});
        }
    const bool moored = !all.empty();
    all.push_back(mean_figure(evidence, quantity("mean_load"), "mean load"));
    if (moored) return all;
    if (!evidence.campaign.design.active())
        if (const DesignLoads& designs = designs_of(evidence); !designs.of_cases.empty())
            all.insert(all.begin(), design_figure(evidence, designs, words_of_load));
    const std::vector<LoadColumn> columns = load_columns(evidence.summary);
    for (std::size_t k = 1; k < columns.size(); ++k)
        all.push_back(mean_figure(evidence, columns[k].quantity, columns[k].words));
    return all;
}

using CaseRows = std::vector<std::pair<std::string, std::size_t>>;

/// The cases that have a row, with what is said before their names: of a design its extreme points, of variations
/// those that change the mean load most, else the first ones.
CaseRows rows_of(const Evidence& evidence, const CaseFigure& mean) {
    const Summary& summary = evidence.summary;
    if (evidence.campaign.design.active() && summary.cases.size() > most_overview_rows) return extreme_points(summary);
    std::vector<std::size_t> cases(summary.cases.size());
    std::iota(cases.begin(), cases.end(), std::size_t{0});
    if (base_case(evidence.campaign)) {
        const auto change = [&](std::size_t k) {
            const Estimate* found = mean.difference(k);
            return k == evidence.base() ? HUGE_VAL : found == nullptr ? -1.0 : std::abs(found->value);
        };
        std::ranges::stable_sort(cases, std::ranges::greater{}, change);
    }
    CaseRows rows;
    for (std::size_t k = 0; k < std::min(cases.size(), most_overview_rows); ++k) rows.emplace_back("", cases[k]);
    return rows;
}

Results table_of(const Evidence& evidence, const std::vector<CaseFigure>& figures, const CaseRows& rows) {
    const Summary& summary = evidence.summary;
    Results table{
        .place = "answer", .columns = {{"case", "case"}, {"arrangements", "n"}}, .view = Results::View::drawn};
    const auto any = [&](const CaseFigure& one) {
        return std::ranges::any_of(rows, [&](const auto& row) { return one.difference(row.second) != nullptr; });
    };
    const std::string minus = fmt::format("− {}", summary.label_of(evidence.base()));
    for (const CaseFigure& one : figures) {
        table.columns.push_back(one.about);
        if (!evidence.compared()) continue;
        ResultColumn difference = one.about;
        difference.key += "_difference";
        difference.words = any(one) ? minus : "";
        difference.form = ResultColumn::Form::difference;
        difference.digits = 0;
        difference.decimals = one.about.unit == "share" ? 1 : -1;
        difference.limit = std::nan("");
        table.columns.push_back(std::move(difference));
    }
    for (const auto& [words, k] : rows) {
        const CaseSummary& row = summary.cases[k];
        const std::string label = words.empty() ? summary.label_of(k) : words + ": " + summary.label_of(k);
        std::vector<Datum> line{Named{summary.name_of(k), label}, row.done};
        for (const CaseFigure& one : figures) {
            line.push_back(one.values[k]);
            if (evidence.compared()) line.push_back(one.differences[k]);
        }
        table.add(std::move(line));
    }
    return table;
}

std::string after_text(const Evidence& evidence, const std::vector<CaseFigure>& figures) {
    const DesignLoadRequest asked = evidence.design_request.value_or(DesignLoadRequest{});
    const bool designs = std::ranges::any_of(figures, [](const CaseFigure& one) { return one.of_design(); });
    std::string text = "Brackets: 95 % intervals over arrangements (n).";
    if (designs)
        text += fmt::format(" Design values: exceeded with {:.3g} % in {:.3g} h.",
                            (1 - asked.quantiles.front()) / unit::percent, asked.exposure / unit::hour);
    const auto lines = std::ranges::find(figures, "design_line_tension",
                                         [](const CaseFigure& one) { return std::string_view(one.about.key); });
    if (lines != figures.end())
        text +=
            fmt::format(" Lines: of the one nearest to its break load; a safety factor of {:g} allows {:.2f} (dashed).",
                        evidence.safety_factor, 1 / evidence.safety_factor);
    if (evidence.compared())
        text += std::ranges::any_of(figures, &CaseFigure::apart)
                    ? " Differences: by pairs over the same arrangements; of cases that begin from other floes, of "
                      "their means and design values."
                    : " Differences: by pairs over the same arrangements.";
    return text;
}

/// "a mooring force of 6.2 MN (5.1 to 8.4)"
std::string quoted(const CaseFigure& one, const Estimate& found, const Units& units) {
    const std::string& unit = one.about.unit;
    std::string text = one.noun + " " + units.text(found.value, unit);
    if (!found.said || !std::isfinite(found.low)) return text;
    return text + fmt::format(" ({} to {})", units.number(found.low, unit), units.number(found.high, unit));
}

/// The case with the largest value of the first figure that all cases with results have, and that figure: of one that
/// some lack nobody knows which case it is.
std::pair<const CaseFigure*, std::size_t> governing(const std::vector<CaseFigure>& figures, const CaseRows& rows) {
    for (const CaseFigure& one : figures) {
        std::optional<std::size_t> most;
        const auto has = [&](std::size_t k) {
            return one.estimate(k) != nullptr && std::isfinite(one.estimate(k)->value);
        };
        const auto lacks = [&](const auto& row) {
            return figures.back().estimate(row.second) != nullptr && !has(row.second);
        };
        if (std::ranges::any_of(rows, lacks)) continue;
        for (const auto& [words, k] : rows)
            if (has(k) && (!most || one.estimate(k)->value > one.estimate(*most)->value)) most = k;
        if (most) return {&one, *most};
    }
    return {nullptr, 0};
}

/// "coarse: in 3 h a mooring force of 6.2 MN (5.1 to 8.4) and an offset of 2.4 m (2.1 to 2.9) are each exceeded with
/// 10 %; mean load 2.5 MN (2.3 to 2.7)." On the governing case.
std::string sentence_of(const Evidence& evidence, const std::vector<CaseFigure>& figures, const CaseRows& rows) {
    const auto [leading, governs] = governing(figures, rows);
    if (leading == nullptr) return "";
    std::vector<std::string> design, mean;
    for (const CaseFigure& one : figures)
        if (const Estimate* found = one.estimate(governs); found != nullptr && std::isfinite(found->value))
            (one.of_design() ? design : mean).push_back(quoted(one, *found, evidence.units));
    std::vector<std::string> parts;
    const DesignLoadRequest asked = evidence.design_request.value_or(DesignLoadRequest{});
    if (!design.empty())
        parts.push_back(fmt::format("in {:.3g} h {} {} exceeded with {:.3g} %", asked.exposure / unit::hour,
                                    fmt::join(design, ", "), design.size() == 1 ? "is" : "are each",
                                    (1 - asked.quantiles.front()) / unit::percent));
    parts.push_back(fmt::format("{}", fmt::join(mean, ", ")));
    if (design.empty() && std::ranges::any_of(figures, &CaseFigure::of_design))
        parts.emplace_back("no design value yet");
    const CaseSummary& row = evidence.summary.cases[governs];
    const std::string label = evidence.summary.label_of(governs);  // a name stays as it is, words begin a sentence
    return fmt::format("{}: {} ({}).", evidence.campaign.design.active() ? capital(label) : label,
                       fmt::join(parts, "; "), counted(row.done, "arrangement"));
}

using Next = std::vector<std::pair<std::string, std::string>>;

/// Campaigns that are in no file yet are told to run by who shows them.
Next next_of(const Evidence& evidence, const std::vector<CaseFigure>& figures, const CaseRows& rows) {
    Next next;
    if (evidence.file.empty()) return next;
    const std::string file = shell_word(evidence.file.string());
    int wanted = 0;
    for (const CaseFigure& one : figures)
        for (const auto& [words, k] : rows)
            if (one.more[k] > 0) wanted = std::max(wanted, evidence.summary.cases[k].done + one.more[k]);
    if (const int there = evidence.campaign.arrangements; wanted > there)
        next.emplace_back(fmt::format("{} arrangements{}", wanted,
                                      cost_words(evidence, static_cast<double>(wanted - there) *
                                                               static_cast<double>(evidence.summary.cases.size()))),
                          fmt::format("floes run {} -o {} --set campaign.arrangements={} --resume",
                                      configuration_word(evidence.summary.title), file, wanted));
    for (const CaseFigure& one : figures)
        if (!one.later.empty())
            next.emplace_back(fmt::format("{}, measured from where it is steady", one.about.words),
                              fmt::format("floes design {} {} --window auto", file, one.later));
    return next;
}

}  // namespace

std::string configuration_word(const std::string& title) {
    std::error_code none;
    const std::string name = title + ".toml";
    return std::filesystem::exists(name, none) ? shell_word(name) : "CONFIG.toml";
}

PageOne find_page_one(Evidence& evidence) {
    const std::vector<CaseFigure> figures = figures_of(evidence);
    const auto mean = std::ranges::find_if(figures, [](const CaseFigure& one) { return !one.of_design(); });
    const CaseRows rows = rows_of(evidence, *mean);
    Section table{.results = {table_of(evidence, figures, rows)}, .after = after_text(evidence, figures)};
    if (const std::size_t all = evidence.summary.cases.size(); all > rows.size())
        table.after += fmt::format(" {} further cases: floes summarize --full.", all - rows.size());
    for (const CaseFigure& one : figures) table.notes.insert(table.notes.end(), one.doubts.begin(), one.doubts.end());
    return {std::move(table), mooring_lines_section(evidence), sentence_of(evidence, figures, rows),
            next_of(evidence, figures, rows)};
}

}  // namespace floes
