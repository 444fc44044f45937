#include "findings/cases.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "arrangement/arrangement.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/design_points.hpp"
#include "findings/sections.hpp"
#include "inference/explained_variance.hpp"
#include "inference/interval.hpp"
#include "scenario/keys.hpp"

namespace floes {

Estimate estimate_of(const CaseSummary& row, const Quantity& quantity) {
    return estimate(row.of(quantity), row.done, kind_of(quantity));
}

ResultColumn LoadColumn::column() const {
    return {.words = words,
            .unit = unit_of(quantity),
            .holds = ResultColumn::Holds::estimates,
            .form = ResultColumn::Form::plus_minus};
}

std::vector<LoadColumn> load_columns(const Summary& summary) {
    const Quantity& largest = headline_maximum(summary.quantities);
    return {
        {quantity("mean_load"), "mean load"},
        {largest, largest.averaging == 0 ? "largest of a step" : fmt::format("largest over {:g} s", largest.averaging)},
        {quantity("failure_ratio"), "broken floes"}};
}

namespace {

/// Whether a case has a figure without an interval.
bool any_dash(const Summary& summary) {
    for (const LoadColumn& column : load_columns(summary))
        for (const CaseSummary& row : summary.cases) {
            const Estimate mean = estimate_of(row, column.quantity);
            if (std::isfinite(mean.value) && !mean.said && mean.low != mean.high) return true;
        }
    return false;
}

/// What no interval has: kinds of run that none of the fewest arrangements of a case shows.
std::string unseen_text(const Summary& summary) {
    constexpr double times = 5;  // the load
    int fewest = 0;
    for (const CaseSummary& row : summary.cases)
        if (row.done >= fewest_for_interval && (fewest == 0 || row.done < fewest)) fewest = row.done;
    if (fewest == 0) return "";
    return fmt::format(
        "A rare kind of run, such as a jam, may be missing from {} runs if it is less than {:.2g} % of all, and no "
        "interval counts it: each percent of runs at {:g} times the load would add {:g} % to the mean.\n",
        fewest, unseen_share(static_cast<std::size_t>(fewest)) / unit::percent, times, times - 1);
}

}  // namespace

std::string load_columns_text(const Summary& summary) {
    const Quantity& largest = headline_maximum(summary.quantities);
    int segments = 0;
    bool same = true;
    for (const CaseSummary& row : summary.cases) {
        same = same && (segments == 0 || segments == row.about.analysis.segments);
        segments = row.about.analysis.segments;
    }
    const std::string parts = same && segments == 1 ? "the window"
                              : same ? fmt::format("each of the window's {}", counted(segments, "segment"))
                                     : std::string{"each of the window's segments"};
    return fmt::format(
        "±: 95 % interval of the mean over arrangements (t), of sampling alone (floes vary: of the model){}. Largest: "
        "of {}, {}; their mean.",
        any_dash(summary) ? fmt::format("; –: of fewer than {}, or too wide", fewest_for_interval) : std::string{},
        parts,
        largest.averaging == 0 ? std::string{"in a single step, which depends on the time step"}
                               : fmt::format("averaged over {:g} s", largest.averaging));
}

std::vector<std::pair<std::string, std::size_t>> extreme_points(const Summary& summary) {
    const auto mean = [&](std::size_t k) { return summary.cases[k].of(quantity("mean_load")).estimate; };
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (std::isfinite(mean(k))) done.push_back(k);
    if (done.empty()) return {};
    const auto [least, most] = std::ranges::minmax_element(done, {}, mean);
    return {{"least mean", *least}, {"largest mean", *most}};
}

namespace {

/// The source of a key says whether its default is a value that the paper states.
bool stated(const Key& key) {
    const auto begins = [&](const char* words) { return key.source.starts_with(words); };
    return begins("Table 1") || begins("Table 3") || begins("the paper, ");
}

bool of_the_case(const Key& key) {
    return key.path == "ice.elastic_modulus_MPa" || key.path == "joint.cfm";
}

std::vector<Datum> paper_line(const PaperRow& paper) {
    return row_of(fmt::format("the paper at {:g} MPa", paper.elastic_modulus_mpa), 1, paper.mean, paper.sd,
                  paper.mean_maximum, paper.sd_maximum, paper.failure_ratio);
}

std::vector<Datum> experiment_line() {
    const Experiment measured;
    return row_of(fmt::format("experiment at {:g} MPa", measured.elastic_modulus_mpa), Absent{}, measured.mean,
                  Absent{}, fmt::format("{:.1f} (largest)", measured.maximum), Absent{}, measured.failure_ratio);
}

}  // namespace

bool is_the_papers(const Scenario& scenario) {
    Scenario own = scenario;
    Scenario papers;
    const Keys keys = describe(own);
    const Keys defaults = describe(papers);
    return std::ranges::all_of(keys, [&](const Key& key) {
        return !stated(key) || of_the_case(key) || exact_text(key) == exact_text(*find_key(defaults, key.path));
    });
}

namespace {

/// The paper's run of this case; nullptr if there is none.
const PaperRow* paper_row(const Case& one) {
    if (!is_the_papers(one.scenario)) return nullptr;
    const double modulus = one.scenario.ice.elastic_modulus / unit::megapascal;
    const auto found = std::ranges::find_if(
        paper_table3, [&](const PaperRow& row) { return std::abs(row.elastic_modulus_mpa - modulus) < 0.5; });
    return found == paper_table3.end() ? nullptr : &*found;
}

/// The prediction interval of one further run.
Bracket one_further_run(const CaseSummary& row, const Quantity& quantity) {
    const CaseEstimate& known = row.of(quantity);
    const Limits limits{known.prediction_low, known.prediction_high};
    return {limits, says_something(known.estimate, limits, row.done, kind_of(quantity))};
}

}  // namespace

Results table3(const Campaign& campaign, const Summary& summary) {
    // The paper's maxima are of single steps, and so are those beside them.
    const bool papers = std::ranges::any_of(campaign.cases, [](const Case& one) { return paper_row(one) != nullptr; });
    const Quantity& largest = papers ? quantity("mean_maximum") : headline_maximum(summary.quantities);
    const Quantity scatter =
        largest.averaging > 0 ? averaged_over(quantity("sd_maximum"), largest.averaging) : quantity("sd_maximum");
    const std::array<Quantity, 5> shown{quantity("mean_load"), quantity("sd_load"), largest, scatter,
                                        quantity("failure_ratio")};
    Results table{.columns = {{.words = "case"}, {.words = "n"}}};
    for (const Quantity& quantity : shown) {
        table.columns.push_back(column_of(quantity));
        table.columns.back().key.clear();
    }
    bool experiment = false;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& row = summary.cases[k];
        std::vector<Datum> means{summary.label_of(k), row.done};
        std::vector<Datum> runs{"  one further run", Absent{}};
        for (const Quantity& quantity : shown) {
            means.emplace_back(estimate_of(row, quantity));
            runs.emplace_back(one_further_run(row, quantity));
        }
        table.add(std::move(means));
        if (row.done >= fewest_for_interval) table.add(std::move(runs));
        const PaperRow* paper = paper_row(campaign.cases.at(k));
        if (paper == nullptr) continue;
        const bool again =
            k + 1 < campaign.cases.size() && paper_row(campaign.cases[k + 1]) == paper;  // in a design, show it once
        if (!again) table.add(paper_line(*paper));
        experiment = experiment || paper->elastic_modulus_mpa == Experiment{}.elastic_modulus_mpa;
    }
    if (experiment) table.add(experiment_line());
    return table;
}

namespace {

constexpr std::size_t most_reasons = 10;  // shown; `floes status` has all of them

std::string heading(const Summary& summary, const MemberCounts& totals) {
    std::string text = fmt::format("Campaign {}: {} in {}", summary.title, counted(totals.members, "member"),
                                   counted(std::ssize(summary.cases), "case"));
    if (totals.failed_members > 0) text += fmt::format(", {} failed", totals.failed_members);
    text += totals.missing_members > 0 ? fmt::format(". INCOMPLETE: {} without a result yet.\n", totals.missing_members)
                                       : ".\n";
    for (const std::string& condition : condition_lines(summary)) text += condition + "\n";
    return text;
}

std::string notes(const Summary& summary, const MemberCounts& totals) {
    std::string text = fmt::format(
        "\nOne arrangement is one value. Brackets, all 95 %: confidence interval of the mean over all arrangements by "
        "Student's t, or by a mixture where members stand out; below it the prediction interval of one further run; –: "
        "one that would say nothing, of fewer than {} arrangements or too wide. Load through the window: rises, falls "
        "or is steady where the 95 % interval of its change says so; steady: below {:g} % of the mean. Failure ratio: "
        "broken floes / floes. Joints failed: mean per run.\n",
        fewest_for_interval, steady_change / unit::percent);
    if (headline_maximum(summary.quantities).averaging == 0)
        text +=
            "Maxima are of single steps, since the members have none of averaged loads: a blow gives its impulse "
            "within a step or two, so they depend on the time step. Quote averaged maxima, with their averaging "
            "time.\n";
    text += unseen_text(summary);
    if (totals.missing_members > 0 && totals.done > 0) {
        text += "Short runs finish first: until the campaign is complete, the figures are biased towards them.\n";
    }
    for (std::size_t index = 0; index < std::min(summary.failed.size(), most_reasons); ++index) {
        text += fmt::format("Member {} failed: {}\n", summary.failed[index].member, summary.failed[index].reason);
    }
    if (summary.failed.size() > most_reasons) {
        text += fmt::format("… and {} more failed.\n", summary.failed.size() - most_reasons);
    }
    return text;
}

/// Whether it counts what happened in no member, such as joints that fail in a mode without a criterion. The first of
/// several counts, whose label is not indented, is always shown.
bool never_happened(const Summary& summary, const Quantity& quantity) {
    return quantity.count && quantity.label.view().starts_with(' ') &&
           std::ranges::none_of(summary.cases, [&](const CaseSummary& row) { return row.of(quantity).estimate > 0; });
}

/// For people only where the interval says something of some case.
void add_further_run(const Summary& summary, const Quantity& quantity, Results& table) {
    const auto further = [&](const CaseSummary& row) { return one_further_run(row, quantity); };
    const bool said = quantity.shown >= Shown::in_table3 && !quantity.for_programs &&
                      std::ranges::any_of(summary.cases, &Bracket::said, further);
    table.add_column({.key = std::string{quantity.key.view()} + "_prediction",
                      .words = said ? "  one further run" : "",
                      .unit = unit_of(quantity),
                      .holds = ResultColumn::Holds::brackets,
                      .decimals = column_of(quantity).decimals},
                     summary.cases, further);
}

void add_counts(const Summary& summary, Results& table) {
    using Row = const CaseSummary&;
    const auto add = [&](ResultColumn about, const auto& value) {
        table.add_column(std::move(about), summary.cases, value);
    };
    const bool any_cfm = std::ranges::any_of(summary.cases, [](Row row) { return !std::isnan(row.about.cfm); });
    add({"name", "case"},
        [&](Row row) { return summary.named(static_cast<std::size_t>(&row - summary.cases.data())); });
    add({.key = "cfm", .words = any_cfm ? "Σ" : "", .digits = 4}, [](Row row) { return row.about.cfm; });
    add({.key = "elastic_modulus_MPa", .words = "E, MPa", .digits = 4},
        [](Row row) { return row.about.elastic_modulus / unit::megapascal; });
    add({"members", "arrangements"}, [](Row row) { return row.members; });
    add({"done", "  done"}, [](Row row) { return row.done; });
    add({"failed_members", "  failed"}, [](Row row) { return row.failed_members; });
    add({"missing_members"}, [](Row row) { return row.missing_members; });
    add({"not_steady"}, [](Row row) { return row.not_steady; });
    add({.key = "trend"}, [](Row row) { return name_of(row.trend.steadiness); });
    add({.words = "load through the window"}, [](Row row) { return judged_words(row.trend); });
    const auto as_estimate = [](const Interval& change) {
        return Estimate{change.estimate, change.low, change.high, std::isfinite(change.low)};
    };
    add(estimates("", "  changes by", "N"), [&](Row row) { return as_estimate(row.trend.judged()); });
    add(estimates("change_over_window", "", "N"), [&](Row row) { return as_estimate(row.trend.load); });
}

void add_quantity(const Summary& summary, const Quantity& quantity, Reference reference, Results& table) {
    using Row = const CaseSummary&;
    const std::string key{quantity.key.view()};
    ResultColumn about = column_of(quantity);
    if (never_happened(summary, quantity)) about.words.clear();
    table.add_column(std::move(about), summary.cases, [&](Row row) { return estimate_of(row, quantity); });
    add_further_run(summary, quantity, table);
    if (kind_of(quantity).load)
        table.add_column({key + "_standing_out"}, summary.cases,
                         [&](Row row) { return row.of(quantity).standing_out; });
    if (!reference) return;
    const std::string words = fmt::format("  against {}, %", summary.name_of(*reference));
    table.add_column({.key = key + "_difference_percent",
                      .words = quantity.shown >= Shown::in_pairs && !quantity.for_programs ? words : "",
                      .decimals = 1},
                     summary.cases, [&](Row row) {
                         const auto index = static_cast<std::size_t>(&row - summary.cases.data());
                         return difference_percent(summary, index, *reference, quantity);
                     });
}

Results case_table(const Summary& summary, Reference reference) {
    Results table{.place = "cases", .view = Results::View::side_by_side};
    add_counts(summary, table);
    for (const Quantity& quantity : shown_in(summary.quantities, Shown::in_summary))
        add_quantity(summary, quantity, reference, table);
    for (const Quantity& quantity : summary.quantities) {
        if (!quantity.count) continue;
        const std::string key{quantity.key.view()};
        table.add_column({key + "_total"}, summary.cases, [&](const CaseSummary& row) {
            const auto total = row.totals.find(key);
            return total == row.totals.end() ? Datum(Undefined{}) : Datum(total->second);
        });
    }
    for (const Condition& condition : conditions())
        table.add_column({condition.key}, summary.cases,
                         [&](const CaseSummary& row) { return condition.value(row.about); });
    return table;
}

/// The hull of each case as its configuration has it.
Results profiles(const Summary& summary) {
    Results rows{.place = "profiles", .columns = program_columns("case height radius"), .in_csv = false};
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        for (const auto& point : summary.cases[k].about.shape.profile())
            rows.add({summary.named(k), point.at(0), point.at(1)});
    return rows;
}

Results about(const Summary& summary, Reference reference) {
    return object("", {{"campaign", summary.title},
                       {"complete", summary.complete()},
                       {"reference", reference ? Datum(summary.name_of(*reference)) : Absent{}}});
}

}  // namespace

Section summary_section(const Summary& summary, Reference reference) {
    const MemberCounts totals = summary.counts();
    return {.before = heading(summary, totals) + "\n",
            .results = {about(summary, reference), case_table(summary, reference), profiles(summary)},
            .after = notes(summary, totals)};
}

namespace {

/// Every arrangement as a dot, a strip for each case, the first at the top; below them the mean and its intervals.
Figure strips(const Evidence& evidence, const Quantity& quantity, std::string caption) {
    const auto& cases = evidence.summary.cases;
    const double count = static_cast<double>(cases.size());
    std::vector<std::vector<double>> runs;
    std::vector<double> all;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        names.insert(names.begin(), evidence.summary.label_of(i));
        const std::vector<double>& values =
            runs.emplace_back(evidence.sample.values(evidence.sample.done(i), quantity));
        all.insert(all.end(), values.begin(), values.end());
        const Estimate mean = estimate_of(cases[i], quantity);
        const Bracket run = one_further_run(cases[i], quantity);
        if (mean.said) all.insert(all.end(), {mean.low, mean.high});
        if (run.said) all.insert(all.end(), {run.limits.low, run.limits.high});
    }
    Figure figure{.description = fmt::format("{} of every arrangement, with the mean of each case", quantity.label),
                  .x = axis_around(std::string(quantity.label.view()), all, true, unit_of(quantity)),
                  .y = {"", 0, count, false, std::move(names)},
                  .size = {720, 70 + 34 * count},
                  .caption = std::move(caption)};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double middle = static_cast<double>(cases.size() - i) - 0.5;
        const double below = middle - 0.28;
        const Estimate mean = estimate_of(cases[i], quantity);
        const Bracket run = one_further_run(cases[i], quantity);
        if (run.said) figure.line({{run.limits.low, below}, {run.limits.high, below}}, "dashed");
        if (mean.said) figure.line({{mean.low, below}, {mean.high, below}}, "thick");
        figure.dot(mean.value, below, "ink", 4.5);
        int turn = 0;  // spreads dots over the strip's height, always in the same way
        for (const double value : runs[i])
            figure.dot(value, middle - 0.04 + 0.08 * (turn++ * 2 % 5), colour(i) + " faint");
    }
    return figure;
}

}  // namespace

Results averaged_loads(const Summary& summary) {
    Results results{.columns = {{.words = "case"},
                                {.words = "over, s", .digits = 4},
                                estimates("", "SD", "N"),
                                estimates("", "mean maximum", "N"),
                                {.words = "one further run", .unit = "N", .holds = ResultColumn::Holds::brackets},
                                estimates("", "SD maximum", "N")}};
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& row = summary.cases[k];
        for (const Quantity& maximum : summary.quantities) {
            if (maximum.averaging == 0 || maximum.averaged != quantity("mean_maximum").averaged) continue;
            const auto of = [&](const Quantity& every_step) {
                return estimate_of(row, averaged_over(every_step, maximum.averaging));
            };
            results.add({summary.label_of(k), maximum.averaging, of(quantity("sd_load")), estimate_of(row, maximum),
                         one_further_run(row, maximum), of(quantity("sd_maximum"))});
        }
    }
    return results;
}

Section averaged_section(Evidence& evidence) {
    Section section{.results = {averaged_loads(evidence.summary)}};
    if (section.results.front().empty()) return {};
    section.after =
        "Surge load averaged over the time given: mean over arrangements of the segment maxima, with its 95 % "
        "confidence and prediction intervals.";
    return section;
}

Section table3_section(Evidence& evidence) {
    const bool papers =
        std::ranges::any_of(evidence.campaign.cases, [](const Case& one) { return paper_row(one) != nullptr; });
    Section section{
        .results = {table3(evidence.campaign, evidence.summary)},
        .after = fmt::format(
            "Mean over arrangements with its 95 % confidence interval; below it the 95 % prediction interval of one "
            "further arrangement; –: one that would say nothing.{}",
            papers ? " The paper's figures are one run each, and the experiment's maximum is one value. Maxima are of "
                     "single steps here, as the paper's: they depend on the time step."
                   : "")};
    if (in_detail(evidence.campaign))  // a design of many points has figures of its own
        section.figures = {
            strips(evidence, quantity("mean_load"),
                   "Each dot is one arrangement. Below the dots: mean, its 95 % confidence interval (thick), and the "
                   "95 % prediction interval of one further run (dashed)."),
            strips(evidence, headline_maximum(evidence.summary.quantities),
                   "The same for the mean of the segments' maxima."),
            strips(evidence, quantity("failure_ratio"), "The same for the share of broken floes.")};
    return section;
}

Section members_section(const Evidence& evidence) {
    const Sample& sample = evidence.sample;
    Results results{.columns = program_columns("member case arrangement status"), .in_json = false};
    auto shown = shown_in(evidence.summary.quantities, Shown::in_summary);
    for (const Quantity& quantity : shown) results.columns.push_back({std::string{quantity.key.view()}});
    const auto maxima_of = [&](std::size_t member) { return sample.along("members/segment_maximum", member); };
    std::size_t segments = 0;  // largest number in any case
    for (const CaseRow& one : sample.cases)
        segments = std::max(segments, static_cast<std::size_t>(one.analysis.segments));
    for (std::size_t k = 0; k < sample.members(); ++k) segments = std::max(segments, maxima_of(k).size());
    for (std::size_t k = 0; k < segments; ++k) results.columns.push_back({fmt::format("segment_{}_maximum", k + 1)});
    results.columns.push_back({"trend_p"});
    for (std::size_t member = 0; member < sample.members(); ++member) {
        const RowStatus status = sample.status(member);
        std::vector<Datum> line{member, sample.cases.at(sample.case_of(member)).name, sample.number_of(member),
                                status == RowStatus::done     ? "done"
                                : status == RowStatus::failed ? "failed"
                                                              : "missing"};
        for (const Quantity& quantity : shown) line.emplace_back(sample.value(member, quantity));
        const std::span<const double> maxima = maxima_of(member);
        for (std::size_t k = 0; k < segments; ++k)
            line.push_back(k < maxima.size() ? Datum(maxima[k]) : Datum(Absent{}));
        line.emplace_back(sample.value(member, quantity("trend_p")));
        results.add(std::move(line));
    }
    return {.results = {std::move(results)}};
}

Section long_section(const Evidence& evidence) {
    const Sample& sample = evidence.sample;
    Results results{.columns = program_columns("case arrangement quantity unit value"), .in_json = false};
    for (std::size_t member = 0; member < sample.members(); ++member)
        for (const Quantity& quantity : evidence.summary.quantities)
            if (const double value = sample.value(member, quantity); std::isfinite(value))
                results.add({sample.cases.at(sample.case_of(member)).name, sample.number_of(member),
                             quantity.key.view(), quantity.unit, value});
    return {.results = {std::move(results)}};
}

namespace {

/// Arrangements that are drawn, not run, for the means of the covariates.
constexpr int control_draws = 200;

Covariates drawn(const Scenario& scenario, std::uint64_t seed, int first) {
    Covariates rows;
    for (int k = 0; k < control_draws; ++k) {
        const Arrangement made = make_arrangement(scenario, seed, static_cast<std::uint32_t>(first + k));
        rows.push_back({made.local_order, made.coverage_ahead});
    }
    return rows;
}

/// Whether the order of the ice ahead of the structure varies by what arrangements are drawn.
bool is_drawn_ahead(const Scenario& scenario) {
    return !scenario.arrangement.given() && !scenario.path.any();
}

}  // namespace

Results find_control(const Evidence& evidence) {
    Results results{.place = "control",
                    .columns = {{"case", "control variates"},
                                {"quantity"},
                                estimates("mean", "mean", ""),
                                {.key = "r_squared_left_out", .words = "R² left out", .decimals = 2},
                                {"used"},
                                estimates("corrected", ""),
                                estimates("", "corrected", ""),
                                {.key = "arrangements_saved", .words = "arrangements saved", .decimals = 0}}};
    const Campaign& campaign = evidence.campaign;
    std::map<std::tuple<std::uint64_t, bool, double>, Covariates> populations;  // by floes, and the path through them
    for (const Quantity& quantity : shown_in(evidence.summary.quantities, Shown::in_headlines)) {
        bool first = true;
        for (std::size_t k = 0; k < evidence.sample.cases.size(); ++k) {
            const Scenario& scenario = campaign.cases.at(k).scenario;
            if (!is_drawn_ahead(scenario)) continue;
            const auto [place, added] = populations.try_emplace(
                {geometry_key(scenario), scenario.field.endless(), scenario.structure.shape.waterline_radius()});
            if (added) place->second = drawn(scenario, campaign.seed, campaign.arrangements);
            if (std::exchange(first, false))
                results.add_heading(std::string{quantity.label.view()}, Results::For::everybody, unit_of(quantity));
            Members members = evidence.sample.done(k);
            std::erase_if(members, [&](std::size_t one) {  // as of a case that does not average over that time
                return !std::isfinite(evidence.sample.value(one, quantity));
            });
            Covariates known;
            for (const std::size_t member : members)
                known.push_back({evidence.sample.value(member, *find_quantity("local_order")),
                                 evidence.sample.value(member, *find_quantity("coverage_ahead"))});
            const ControlledMean found =
                controlled_mean(evidence.sample.values(members, quantity), known, place->second);
            const Estimate corrected = estimate(found.corrected);
            results.add({evidence.summary.named(k), quantity.key.view(), estimate(found.plain), found.left_out,
                         found.used, corrected, found.used ? Datum(corrected) : Datum("off"), found.saved});
        }
    }
    return results;
}

namespace {

/// A sentence on the cases of which the order of the ice ahead is not known; empty where it is of all.
std::string uncontrolled_text(const Evidence& evidence) {
    std::vector<std::size_t> cases;
    for (std::size_t k = 0; k < evidence.campaign.cases.size(); ++k)
        if (!is_drawn_ahead(evidence.campaign.cases[k].scenario)) cases.push_back(k);
    return cases.empty() ? ""
                         : fmt::format(" On a path, or with floes given, there is none: {}.",
                                       label_list(evidence.summary, cases));
}

}  // namespace

Section control_section(Evidence& evidence) {
    return {.results = {find_control(evidence)},
            .after = fmt::format(
                "\nBrackets: 95 % interval, by Student's t. Means corrected for the local order and the coverage ahead "
                "of the arrangements that were run, against {} that were only drawn. R² left out: share of the "
                "variance that these predict of arrangements which the fit has not seen; at 0 or below, where the "
                "interval is no shorter, and with fewer than {} arrangements, the correction is off.{}\n",
                control_draws, fewest_controlled, uncontrolled_text(evidence))};
}

namespace {

struct Curve {
    std::size_t of_case = 0;
    Figure::Points mean = {}, low = {}, high = {};
};

}  // namespace

Section convergence_section(Evidence& evidence) {
    constexpr std::size_t fewest_drawn = 3;  // the interval of two arrangements is too wide to draw
    Figure figure{.description = "Mean load over the number of arrangements, with its interval",
                  .x = {"arrangements", 0, 2},
                  .legend = case_legend(evidence.summary),
                  .caption = "Mean load of the first n arrangements with its 95 % interval."};
    std::vector<double> drawn;
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < evidence.sample.cases.size(); ++i) {
        Curve& curve = curves.emplace_back(Curve{i});
        const std::vector<double> loads = evidence.sample.values(evidence.sample.done(i), quantity("mean_load"));
        const std::size_t all = loads.size();
        // Of many arrangements every fiftieth part more.
        for (std::size_t count = fewest_drawn; count <= all;
             count = count == all ? all + 1 : std::min(all, count + std::max<std::size_t>(count / 50, 1))) {
            const double n = static_cast<double>(count);
            const Interval interval = mean_interval(std::span(loads).first(count));
            curve.mean.emplace_back(n, interval.estimate);
            curve.low.emplace_back(n, interval.low);
            curve.high.emplace_back(n, interval.high);
            drawn.push_back(interval.estimate);
            if (says_something(interval.estimate, {interval.low, interval.high}, static_cast<int>(count)))
                drawn.insert(drawn.end(), {interval.low, interval.high});
            figure.x.high = std::max(figure.x.high, n);
        }
    }
    if (drawn.empty()) return {};
    figure.x.high *= 1.02;
    figure.y = axis_around("mean load", drawn, true, "N");
    for (Curve& curve : curves) {
        // The interval of the first few may be far wider than anything else: it ends at the figure's edge.
        for (Figure::Points* limit : {&curve.low, &curve.high})
            for (auto& [n, load] : *limit) load = std::clamp(load, figure.y.low, figure.y.high);
        figure.band(std::move(curve.low), curve.high, colour(curve.of_case) + " veil");
        figure.line(std::move(curve.mean), colour(curve.of_case));
    }
    return {.figures = {std::move(figure)}};
}

}  // namespace floes
