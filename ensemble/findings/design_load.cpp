#include "findings/design_load.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "findings/conditions.hpp"
#include "findings/steady.hpp"
#include "statistics/distributions.hpp"

namespace floes {

constinit const DesignOf design_of_k_x{"k_x", "Design mooring force", "k x", "force", "N"};

void CasePeaks::add(int member, int arrangement, PeakRow row, double mean) {
    rows.push_back(std::move(row));
    arrangements.push_back(arrangement);
    members.push_back(member);
    measured.mean += mean;
}

void CasePeaks::average() {
    measured.mean /= std::max(1.0, static_cast<double>(rows.size()));
}

Measured measured_in(const Analysis& analysis, double separation) {
    return {analysis.window, analysis.window / analysis.segments, separation, 0};
}

PeakRow peak_row(const Sample& sample, std::string_view arrays, std::size_t member, std::size_t place) {
    const auto peaks = sample.along(fmt::format("{}/peaks", arrays), member, place);
    const auto maxima = sample.along(fmt::format("{}/segment_maximum", arrays), member, place);
    return {{peaks.begin(), peaks.end()}, {maxima.begin(), maxima.end()}};
}

CasePeaks case_peaks(const Sample& sample, std::size_t of_case, double time) {
    const Analysis& analysis = sample.cases[of_case].analysis;
    CasePeaks made;
    made.measured = measured_in(analysis, analysis.peak_separation);
    for (const std::size_t member : sample.done(of_case))
        if (const auto place = sample.place_of_time(member, time))
            made.add(static_cast<int>(member), sample.arrangement_of(member),
                     peak_row(sample, "averaged", member, *place), sample.value(member, quantity("mean_load")));
    made.average();
    return made;
}

double averaging_time(const CampaignCases& cases, const DesignLoadRequest& request) {
    for (const double time : cases.averaging_times)
        if (std::abs(time - request.model_averaging()) < 0.005 * time) return time;
    std::vector<std::string> there;
    for (const double time : cases.averaging_times)
        there.push_back(fmt::format("{:.3g}", time * std::sqrt(request.scale)));
    throw InputError(
        fmt::format("The members did not average the load over {:g} s{}; take one of {} s, or run them with another "
                    "analysis.averaging_s.",
                    request.averaging, request.scale == 1 ? "" : " at full scale", fmt::join(there, ", ")));
}

double usual_averaging(const CampaignCases& cases) {
    const std::vector<double>& times = cases.averaging_times;
    const double usual = DesignLoadRequest{}.averaging;
    return times.empty() || std::ranges::find(times, usual) != times.end() ? usual : times.back();
}

double disagreement(const DesignLoad& load) {
    double least = load.estimates.front().quantiles.front().value;
    double most = least;
    for (const DesignLoadEstimate& made : load.estimates) {
        const double value = made.quantiles.front().value;
        if (!std::isfinite(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    return (most - least) / load.estimates.front().quantiles.front().value;
}

namespace {

/// "17", "17 and 31", "3, 17 and 31".
std::string listed(const std::vector<int>& numbers) {
    if (numbers.size() == 1) return fmt::format("{}", numbers.front());
    return fmt::format("{} and {}", fmt::join(numbers.begin(), numbers.end() - 1, ", "), numbers.back());
}

}  // namespace

std::string standing_out_text(const CaseDesignLoad& one) {
    constexpr std::size_t enough = 5;  // of a kind, to say how much it varies
    const UnlikeMembers& unlike = one.load.unlike;
    const std::size_t count = unlike.out.size();
    if (count == 0) return "";
    std::vector<int> numbers;
    for (const std::size_t row : unlike.out) numbers.push_back(one.members[row]);
    const bool single = count == 1;
    const char* carry = single ? "carries" : "carry";
    const std::string does = unlike.carried == 0   ? fmt::format("{} far above the others", single ? "lies" : "lie")
                             : unlike.carried == 1 ? fmt::format("{} the highest peak", carry)
                                                   : fmt::format("{} the {} highest peaks", carry, unlike.carried);
    std::string text = fmt::format(
        "{} of {} members {}: replay {}. Both tails have {} as a kind of member whose share is uncertain; methods that "
        "take all members as alike are left out.",
        count, one.members.size(), does, listed(numbers), single ? "it" : "them");
    if (count < enough)
        text += fmt::format(" About {} arrangements would have {} of this kind.",
                            (enough * one.members.size() + count - 1) / count, enough);
    return text;
}

namespace {

/// Of the peaks, for which the first quantile is shown.
constexpr double threshold_shares[]{0.5, 0.35, 0.25, 0.15, 0.1};

}  // namespace

DesignLoads find_design_loads(const Sample& sample, const DesignLoadRequest& request) {
    const double time = averaging_time(sample, request);
    std::vector<CasePeaks> peaks;
    for (std::size_t index = 0; index < sample.cases.size(); ++index) peaks.push_back(case_peaks(sample, index, time));
    DesignLoads designs = find_design_loads(sample, request, peaks);
    for (CaseDesignLoad& one : designs.of_cases)
        if (one.arrangements.empty() && !sample.done(one.case_index).empty())
            one.lacks = {"its members did not average the load over that time (analysis.averaging_s)",
                         "not averaged over that time"};
    return designs;
}

DesignLoads find_design_loads(const Sample& sample, const DesignLoadRequest& request,
                              const std::vector<CasePeaks>& peaks) {
    const Exposure exposure{request.model_exposure(), request.quantiles, request.share,
                            sample.cases.size() > most_averaged_cases};
    DesignLoads designs{request};
    for (std::size_t index = 0; index < sample.cases.size(); ++index) {
        CaseDesignLoad& one = designs.of_cases.emplace_back();
        one.case_index = index;
        const CasePeaks& found = peaks.at(index);
        one.trend = found.trends.empty() ? joint_trend(sample, index) : joint_trend(found.trends, request.of.noun);
        one.lacks = found.lacks;
        one.separation = found.measured.separation;
        one.arrangements = found.arrangements;
        one.members = found.members;
        for (const PeakRow& row : found.rows) one.peaks.insert(one.peaks.end(), row.peaks.begin(), row.peaks.end());
        std::ranges::sort(one.peaks, std::ranges::greater{});
        if (one.trend.rises() && !request.rising && !one.lacks) {
            one.refused = true;
            one.load.arrangements = found.rows.size();
            one.over_shares.assign(std::size(threshold_shares), std::nan(""));
            continue;
        }
        one.load = design_load(found.rows, found.measured, exposure);
        for (const auto& quantiles : over_thresholds(found.rows, found.measured, exposure,
                                                     {std::begin(threshold_shares), std::end(threshold_shares)}))
            one.over_shares.push_back(quantiles.front());
    }
    return designs;
}

bool DesignLoads::known() const {
    return std::ranges::any_of(of_cases, [](const CaseDesignLoad& one) { return one.load.valid(); });
}

namespace {

/// The interval of resampled differences about the estimate, wider by Student's t of the arrangements over that of very
/// many: resamples of few scatter too little.
LoadFigure widened(double estimate, std::vector<double> resampled, double arrangements) {
    if (resampled.empty()) return {estimate, {std::nan(""), std::nan("")}};
    std::ranges::sort(resampled);
    const double middle = quantile_of_sorted(resampled, 0.5);
    const Limits limits = percentile_interval(std::move(resampled));
    const double wider =
        student_t(arrangements - 1, 0.025) / student_t(1e6, 0.025) * std::sqrt(arrangements / (arrangements - 1));
    return {estimate, {estimate + wider * (limits.low - middle), estimate + wider * (limits.high - middle)}};
}

Estimate shown_figure(const LoadFigure& figure, double factor, bool said = true) {
    return factor * within(figure.value, figure.interval, said);
}

}  // namespace

std::optional<DesignDifference> difference_of(const CaseDesignLoad& first, const CaseDesignLoad& second,
                                              const DesignLoadRequest& request) {
    const DesignLoad& one = first.load;
    const DesignLoad& other = second.load;
    if (!one.valid() || !other.valid() || !first.of_one_kind() || !second.of_one_kind()) return {};
    const bool paired = first.arrangements == second.arrangements;
    const bool shares = std::ranges::find_first_of(first.arrangements, second.arrangements) != first.arrangements.end();
    if (shares && !paired) return {};
    // Draws of one number resample arrangements alike; half of them apart they have nothing in common.
    const std::size_t count = std::min(one.draws.size(), other.draws.size());
    const std::size_t shift = paired ? 0 : count / 2;
    std::vector<double> differences;
    for (std::size_t k = 0; k < count; ++k)
        differences.push_back(other.draws[k].front() - one.draws[(k + shift) % count].front());
    std::erase_if(differences, [](double difference) { return !std::isfinite(difference); });
    const auto value = [](const DesignLoad& of) { return of.estimates.front().quantiles.front().value; };
    const std::size_t fewest = std::min(first.arrangements.size(), second.arrangements.size());
    const LoadFigure found = widened(value(other) - value(one), std::move(differences), static_cast<double>(fewest));
    return DesignDifference{shown_figure(found, request.factor() * request.of.shown_factor(),
                                         static_cast<int>(fewest) >= fewest_for_interval),
                            paired};
}

namespace {

/// Of what people are shown.
Estimate in_si(const Estimate& shown, const DesignOf& of) {
    const double factor = of.shown_factor();
    return {shown.value / factor, shown.low / factor, shown.high / factor, shown.said};
}

Section pairs_section(const Summary& summary, const DesignLoads& designs) {
    const DesignLoadRequest& request = designs.asked;
    Results results{.place = "design/pairs", .columns = {{.words = "pair"}, {"first"}, {"second"}}, .in_csv = false};
    results.columns.push_back(estimates("", "difference", std::string(request.of.shown_unit())));
    results.columns.push_back(estimates("difference", "", std::string(request.of.unit)));
    const std::vector<CaseDesignLoad>& cases = designs.of_cases;
    for (std::size_t a = 0; a < cases.size(); ++a)
        for (std::size_t b = a + 1; b < cases.size(); ++b) {
            const std::optional<DesignDifference> found = difference_of(cases[a], cases[b], request);
            if (!found || !found->paired) continue;
            const std::size_t first = cases[a].case_index;
            const std::size_t second = cases[b].case_index;
            results.add({fmt::format("{} - {}", summary.label_of(second), summary.label_of(first)),
                         summary.name_of(first), summary.name_of(second), found->difference,
                         in_si(found->difference, request.of)});
        }
    if (results.empty()) return {};
    return {.results = {std::move(results)},
            .after = fmt::format("\nDifferences of the {} exceeded with {:.3g} %, by both tails, over the same "
                                 "arrangements, with members taken as alike.\n",
                                 request.of.noun, (1 - request.quantiles.front()) / unit::percent)};
}

bool is_averaged(const DesignLoadRequest& request) {
    return request.of.word == "load";
}

/// Of the column for programs: forces are loads.
std::string value_key(const DesignLoadRequest& request) {
    return request.of.unit == "N" ? "load" : std::string(request.of.word);
}

/// A row for each case, method and figure, for programs; of a case without a load those of both tails, undefined, with
/// the reason.
Results load_rows(const Summary& summary, const DesignLoads& designs) {
    const DesignLoadRequest& request = designs.asked;
    Results results{.place = "design/loads",
                    .columns = program_columns("case method averaging exposure_h scale figure probability of unit")};
    results.columns.push_back(estimates(value_key(request), "", std::string(request.of.unit)));
    results.columns.push_back(program_columns("reason").front());
    const Datum averaging = is_averaged(request) ? Datum(request.averaging) : Undefined{};
    const LoadFigure undefined{std::nan(""), {std::nan(""), std::nan("")}};
    const DesignLoadEstimate none{LargestBy::both_tails, undefined, {request.quantiles.size(), undefined}};
    for (const CaseDesignLoad& design : designs.of_cases) {
        const bool has = design.load.valid();
        const Datum reason = has ? Datum(Undefined{}) : none_text(design, summary.cases[design.case_index].about);
        for (const DesignLoadEstimate& made : has ? design.load.estimates : std::vector{none}) {
            const auto add = [&](const char* figure, double probability, const LoadFigure& load) {
                results.add({summary.named(design.case_index), name_of(made.method), averaging,
                             request.exposure / unit::hour, request.scale, figure, probability, request.of.word,
                             request.of.unit, shown_figure(load, request.factor()), reason});
            };
            add("expected", std::nan(""), made.expected);
            for (std::size_t k = 0; k < made.quantiles.size(); ++k)
                add("quantile", request.quantiles[k], made.quantiles[k]);
        }
    }
    return results;
}

/// What the loads rest on, at the scale of the campaign. What was not looked at, or could not be fitted, is not 0.
Results basis_rows(const Summary& summary, const DesignLoads& designs) {
    Results results{
        .place = "design/basis",
        .columns = program_columns(
            "case arrangements refused_as_rising trend_seen trend change_over_window change_over_window_low "
            "change_over_window_high time_run exposure peak_separation peaks threshold pareto_scale pareto_shape "
            "weibull_origin weibull_scale weibull_shape weibull_weight stand_out peaks_carried unseen_share scatter "
            "alike_probability dispersion dispersion_p resamples resamples_without_fit"),
        .in_csv = false};
    for (const CaseDesignLoad& design : designs.of_cases) {
        const DesignLoad& load = design.load;
        const Interval& change = design.trend.load;
        const auto seen = [&](Datum value) { return design.refused ? Datum(Undefined{}) : value; };
        const auto fitted = [&](Datum value) { return load.valid() ? value : Datum(Undefined{}); };
        results.add(row_of(summary.named(design.case_index), load.arrangements, design.refused, design.trend.seen(),
                           name_of(design.trend.steadiness), change.estimate, change.low, change.high,
                           seen(load.time_run), designs.asked.model_exposure(), design.separation, seen(load.peaks),
                           seen(load.threshold), fitted(load.pareto.scale), fitted(load.pareto.shape),
                           fitted(load.weibull.origin), fitted(load.weibull.scale), fitted(load.weibull.shape),
                           fitted(load.weibull_weight), seen(load.unlike.out.size()), seen(load.unlike.carried),
                           unseen_share(load.arrangements), fitted(load.scatter), fitted(load.alike),
                           seen(load.unlike.dispersion), seen(load.unlike.dispersion_p), fitted(load.draws.size()),
                           fitted(load.dropped)));
    }
    return results;
}

/// The first quantile over the share of the peaks that the tails are fitted to.
Results threshold_rows(const Summary& summary, const DesignLoads& designs) {
    Results results{.place = "design/over_thresholds",
                    .columns = program_columns("case share " + value_key(designs.asked)),
                    .in_csv = false};
    for (const CaseDesignLoad& design : designs.of_cases)
        for (std::size_t k = 0; k < std::size(threshold_shares); ++k)
            results.add({summary.named(design.case_index), threshold_shares[k], design.over_shares[k]});
    return results;
}

/// Peaks above each of them, with the rate that each tail gives, at the scale of the campaign.
Results rate_rows(const Summary& summary, const DesignLoads& designs) {
    Results results{
        .place = "design/rates",
        .columns = program_columns("case " + value_key(designs.asked) + " seen_per_s pareto_per_s weibull_per_s"),
        .in_csv = false};
    const auto tail = [](const Tail& fitted, double load) {
        return fitted.valid() && load >= fitted.threshold ? Datum(rate_above(fitted, load)) : Datum(Undefined{});
    };
    for (const CaseDesignLoad& design : designs.of_cases)
        for (std::size_t k = 0; k < design.peaks.size() && !design.refused; ++k)
            results.add({summary.named(design.case_index), design.peaks[k],
                         static_cast<double>(k + 1) / design.load.time_run, tail(design.load.pareto, design.peaks[k]),
                         tail(design.load.weibull, design.peaks[k])});
    return results;
}

/// The methods that hold for such members.
std::span<const DesignLoadEstimate> shown(const CaseDesignLoad& one) {
    const std::span<const DesignLoadEstimate> all = one.load.estimates;
    return one.of_one_kind() ? all : all.first(std::min<std::size_t>(1, all.size()));
}

/// Sentences about loads that rise and members that stand out, before any figure.
std::string doubt_lines(const Summary& summary, const DesignLoads& designs) {
    std::string lines;
    for (const CaseDesignLoad& one : designs.of_cases)
        if (one.trend.rises() && !one.refused)
            lines += fmt::format("! {}: {}: a longer exposure may see higher loads than these.\n",
                                 summary.label_of(one.case_index), trend_text(one.trend));
    for (const CaseDesignLoad& one : designs.of_cases)
        if (const std::string text = standing_out_text(one); !text.empty())
            lines += fmt::format("! {}: {}\n", summary.label_of(one.case_index), text);
    return lines;
}

}  // namespace

std::string none_text(const CaseDesignLoad& one, const CaseRow& about) {
    if (one.lacks) return one.lacks.why + ".";
    if (one.refused)
        return fmt::format(
            "{}, so it is not known how high it gets later. Measure later ({}run with a later "
            "analysis.steady_start_s); --rising extrapolates as if it stayed as in the window.{}",
            trend_text(one.trend), about.can_be_measured_later() ? "--window auto, or " : "", end_text(about));
    const DesignLoad& load = one.load;
    if (load.arrangements < fewest_members)
        return fmt::format("{} of the {} arrangements that a design load needs; 8 or more are a beginning.",
                           load.arrangements, fewest_members);
    if (load.peaks >= fewest_peaks)
        return fmt::format("its {} peaks give no tail, or reach down to its mean; take fewer (--peaks).", load.peaks);
    if (load.peaks == 0) return "it never rises above its mean; does ice load the structure in the window?";
    return fmt::format("too few peaks ({} of {}) to fit; about {} arrangements would do.", load.peaks, fewest_peaks,
                       static_cast<int>(load.arrangements) + more_arrangements(one));
}

int more_arrangements(const CaseDesignLoad& one) {
    constexpr std::size_t beginning = 8;
    const std::size_t runs = one.load.arrangements;
    if (one.refused || one.lacks) return 0;
    if (one.load.valid()) return static_cast<int>(3 * runs);
    if (runs < fewest_members) return static_cast<int>(beginning - runs);
    if (one.load.peaks == 0 || one.load.peaks >= fewest_peaks) return 0;
    const double needed = std::ceil(static_cast<double>(fewest_peaks * runs) / static_cast<double>(one.load.peaks));
    return static_cast<int>(needed) - static_cast<int>(runs);
}

namespace {

std::string percent(double share) {
    return fmt::format("{:.3g} %", share / unit::percent);
}

std::string scale_words(const DesignLoadRequest& request) {
    if (request.scale == 1) return "";
    return fmt::format(
        "\nFull scale by Froude, 1 : {0:g}: lengths x {0:g}, times x {1:.3g}, loads x {2:.3g}. The strength of the ice "
        "and its modulus are then {0:g} times those of the campaign.\n",
        request.scale, std::sqrt(request.scale), std::pow(request.scale, 3));
}

std::string design_title(const DesignLoadRequest& request) {
    return fmt::format("{}: the largest {}{} in {:g} h", request.of.title, request.of.largest,
                       is_averaged(request) ? fmt::format(" averaged over {:g} s", request.averaging) : "",
                       request.exposure / unit::hour);
}

/// Beside the figure that it is about; empty where the methods agree.
std::string doubt_text(const CaseDesignLoad& one) {
    if (!one.of_one_kind()) return "";
    const double apart = disagreement(one.load);
    return apart > much_disagreement ? fmt::format(" (methods differ by {:.0f} %)", apart / unit::percent) : "";
}

}  // namespace

Section design_values_section(const Summary& summary, const DesignLoads& designs) {
    const DesignLoadRequest& request = designs.asked;
    const std::string shown_unit(request.of.shown_unit());
    Results table{.columns = {{.words = "case"}, estimates("", "expected", shown_unit)}};
    for (const double p : request.quantiles)
        table.columns.push_back(estimates("", fmt::format("exceeded with {}", percent(1 - p)), shown_unit));
    for (ResultColumn& column : table.columns) column.digits = 3;
    std::vector<std::string> notes;  // on cases without a value, then on steady ones
    std::vector<std::string> steadiness;
    for (const CaseDesignLoad& one : designs.of_cases) {
        const std::string& name = summary.label_of(one.case_index);
        const CaseRow& about = summary.cases[one.case_index].about;
        if (!one.load.valid()) {
            notes.push_back(fmt::format("{}: {}", name, none_text(one, about)));
            continue;
        }
        if (std::string steady = steady_text(name, one.trend, about); !steady.empty())
            steadiness.push_back(std::move(steady));
        for (const DesignLoadEstimate& made : shown(one)) {
            const bool first = made.method == LargestBy::both_tails;
            std::vector<Datum> line{first ? fmt::format("{}, {}{}", name, name_of(made.method), doubt_text(one))
                                          : fmt::format("  {}", name_of(made.method))};
            const auto add = [&](const LoadFigure& figure) {
                const int runs = static_cast<int>(one.load.arrangements);
                const double factor = request.factor() * request.of.shown_factor();
                line.push_back(
                    first ? Datum(shown_figure(figure, factor, says_something(figure.value, figure.interval, runs)))
                          : Datum(factor * figure.value));
            };
            add(made.expected);
            for (const LoadFigure& figure : made.quantiles) add(figure);
            table.add(std::move(line));
        }
    }
    const std::vector<Results> records{load_rows(summary, designs), basis_rows(summary, designs),
                                       threshold_rows(summary, designs), rate_rows(summary, designs)};
    if (notes.size() == designs.of_cases.size())
        return {
            .title = design_title(request), .before = fmt::format("{}\n", fmt::join(notes, "\n")), .results = records};
    std::vector<Results> results{std::move(table)};
    results.insert(results.end(), records.begin(), records.end());
    notes.insert(notes.end(), steadiness.begin(), steadiness.end());
    return {.title = design_title(request),
            .results = std::move(results),
            .after =
                "\nBrackets: 95 %. Both tails: Pareto and Weibull tail of members that may differ, above several "
                "thresholds; its interval includes which of these it is. The others take members as alike and have "
                "no interval that holds; Gumbel and GEV: of the segment maxima. docs/design_load.md\n" +
                scale_words(request),
            .notes = std::move(notes)};
}

namespace {

/// Over the window, of what is judged.
Estimate relative_change(const JointTrend& trend) {
    const Interval& change = trend.judged();
    const double whole = trend.whole();
    return {change.estimate / whole, change.low / whole, change.high / whole, std::isfinite(change.low)};
}

/// For people, a line for each figure.
Results basis_table(const Summary& summary, const DesignLoads& designs) {
    const DesignLoadRequest& request = designs.asked;
    using Design = const CaseDesignLoad&;
    Results table{.view = Results::View::side_by_side};
    const auto add = [&](ResultColumn about, const auto& value) {
        table.add_column(std::move(about), designs.of_cases,
                         [&](Design one) { return one.load.valid() ? Datum(value(one)) : Undefined{}; });
    };
    // A single tail through two kinds of member is that of neither.
    const auto of_one_kind = [](const auto& value) {
        return [value](const CaseDesignLoad& one) { return one.of_one_kind() ? Datum(value(one)) : Undefined{}; };
    };
    const double times = std::sqrt(request.scale);
    const double factor = request.factor() * request.of.shown_factor();
    const std::string shown_unit(request.of.shown_unit());
    table.add_column({.words = "what it rests on"}, designs.of_cases,
                     [&](Design one) { return summary.label_of(one.case_index); });
    add({.words = "arrangements"}, [](Design one) { return one.load.arrangements; });
    add({.words = "time run, h", .digits = 3}, [&](Design one) { return one.load.time_run * times / unit::hour; });
    add({.words = "exposure / time run", .digits = 2},
        [&](Design one) { return request.model_exposure() / one.load.time_run; });
    add({.words = "members that stand out"}, [](Design one) { return one.load.unlike.out.size(); });
    add({.words = "a kind of member may be unseen, up to", .unit = "share", .decimals = 0},
        [](Design one) { return unseen_share(one.load.arrangements); });
    add({.words = "the others' scales differ by (SD)", .unit = "share", .decimals = 0},
        [](Design one) { return one.load.scatter; });
    add({.words = "peaks above the threshold a member, variance / mean", .decimals = 2},
        [](Design one) { return one.load.unlike.dispersion; });
    add({.words = "  p, if members are alike", .digits = 3}, [](Design one) { return one.load.unlike.dispersion_p; });
    table.add_column({.words = fmt::format("the {} through the window", request.of.noun)}, designs.of_cases,
                     [](Design one) { return judged_words(one.trend); });
    table.add_column(estimates("", "  changes by", "share", 0), designs.of_cases,
                     [](Design one) { return relative_change(one.trend); });
    add({.words = "peaks at least apart, s", .digits = 3}, [&](Design one) { return one.separation * times; });
    add({.words = "threshold", .unit = shown_unit, .digits = 3},
        [&](Design one) { return factor * one.load.threshold; });
    add({.words = "peaks above"}, [](Design one) { return one.load.peaks; });
    add({.words = "ξ of the Pareto tail", .decimals = 2},
        of_one_kind([](Design one) { return one.load.pareto.shape; }));
    add({.words = "c of the Weibull tail", .decimals = 2},
        of_one_kind([](Design one) { return one.load.weibull.shape; }));
    add({.words = "weight of the Weibull tail", .decimals = 2}, [](Design one) { return one.load.weibull_weight; });
    for (std::size_t k = 0; k < std::size(threshold_shares); ++k)
        add({.words = fmt::format("with the highest {} of the peaks", percent(threshold_shares[k])),
             .unit = shown_unit,
             .digits = 3},
            of_one_kind([&, k](Design one) { return factor * one.over_shares[k]; }));
    add({.words = "methods differ by", .unit = "share", .decimals = 0},
        of_one_kind([](Design one) { return disagreement(one.load); }));
    add({.words = "resamples without a fit"},
        [](Design one) { return fmt::format("{} of {}", one.load.dropped, one.load.draws.size()); });
    add({.words = "more arrangements for half the interval"}, [](Design one) { return 3 * one.load.arrangements; });
    return table;
}

Section basis_section(const Summary& summary, const DesignLoads& designs) {
    const DesignLoadRequest& request = designs.asked;
    if (!designs.known()) return {};
    return {
        .results = {basis_table(summary, designs)},
        .after = fmt::format(
            "\nEach tail is fitted to the highest {1} of the peaks; both tails average over more and fewer. A kind of "
            "member as rare as \"unseen, up to\" is missing from one sample of this size in twenty, and then from "
            "these figures. ξ below 0: the {0} is bounded; above 0: its tail is heavy. c: 1 exponential, 2 Gaussian. "
            "The {0} with other shares of the peaks, and the methods' difference, are of the {0} exceeded with {2}.\n",
            request.of.noun, percent(request.share), percent(1 - request.quantiles.front()))};
}

}  // namespace

Units design_units(const DesignLoads& designs, const Units& otherwise) {
    const DesignLoadRequest& request = designs.asked;
    double largest = 0;
    for (const CaseDesignLoad& design : designs.of_cases)
        for (const DesignLoadEstimate& made : shown(design))
            for (const LoadFigure& figure : made.quantiles)
                if (figure.value > largest) largest = figure.value;
    return request.of.unit == "N" && largest > 0 ? Units(largest * request.factor()) : otherwise;
}

std::vector<Section> design_load_sections(const Summary& summary, const DesignLoads& designs) {
    const std::string conditions = fmt::format("{}", fmt::join(condition_lines(summary), "\n"));
    return {{.before = fmt::format("{}Campaign {}.\n{}\n", doubt_lines(summary, designs), summary.title, conditions)},
            design_values_section(summary, designs),
            basis_section(summary, designs),
            pairs_section(summary, designs)};
}

const DesignLoads& designs_of(Evidence& evidence) {
    return evidence.kept.once([&] {
        DesignLoadRequest asked = evidence.design_request.value_or(DesignLoadRequest{});
        if (evidence.sample.averaging_times.empty()) return DesignLoads{asked};
        if (!evidence.design_request) asked.averaging = usual_averaging(evidence.sample);
        return find_design_loads(evidence.sample, asked);
    });
}

}  // namespace floes
