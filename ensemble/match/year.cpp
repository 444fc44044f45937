#include "match/year.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <ranges>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/page_one.hpp"
#include "findings/summary.hpp"

namespace floes {

namespace {

void refuse_rising(const JointTrend& trend, const std::string& who, const YearRequest& request) {
    if (trend.rises() && !request.load.rising)
        throw InputError(fmt::format(
            "{}: {}, so it is not known how high it gets later; measure later (--window auto, or run with a later "
            "analysis.steady_start_s), or give --rising to extrapolate as if it stayed as in the window",
            who, trend_text(trend)));
}

/// The [[case]] of the design that the regime means; "" where it has none. Throws InputError where the campaign has no
/// design, or several cases of which the regime names none.
std::string design_case(const MatchWave& campaign, const Regime& regime) {
    if (!campaign.campaign.design.active())
        throw InputError(fmt::format(
            "{}: the regime {} gives {}, and {} has no design to interpolate; name one of its cases with case = \"…\", "
            "or run a [design] over {}",
            regime.where, regime.name, regime.values.front().path, campaign.file, regime.values.front().path));
    const std::vector<std::string> bases = match_cases({&campaign, 1});
    if (regime.case_name.empty() && bases.size() == 1) return bases.front();
    if (std::ranges::find(bases, regime.case_name) != bases.end()) return regime.case_name;
    if (bases.size() == 1 && bases.front().empty())
        throw InputError(
            fmt::format("{}: the design of {} has no [[case]] named {}; leave case out, or leave out the values of "
                        "axes to name one of its points",
                        regime.where, campaign.file, regime.case_name));
    throw InputError(
        fmt::format("{}: the regime {} has to say which [[case]] of the design it means: case = \"…\", one of {}",
                    regime.where, regime.name, fmt::join(bases, ", ")));
}

/// A design between its points: the emulated mean maximum at any place, and the runs of all points divided by it
/// (DividedRun).
class InterpolatedDesign {
  public:
    /// Throws InputError as match_data() and averaging_time() do, and where the emulator fails its check or is a
    /// constant: the share of a regime would be that of its hours.
    InterpolatedDesign(const MatchWave& campaign, const std::string& base, const DesignLoadRequest& request);

    const DividedRows& divided() const { return divided_; }  ///< by the mean maximum at their points
    const std::vector<int>& members() const { return members_; }
    const Emulator& index() const { return index_.front().mean(); }
    std::size_t fewest_arrangements() const { return fewest_; }  ///< of a point

    /// The mean maximum there, N, with the variance of the emulator and of what all points share. Throws InputError for
    /// an axis without a value, a value of no axis, and one outside of the axis's range.
    Emulated at(const Regime& regime) const;

  private:
    MatchData data_;
    std::vector<EmulatedTarget> index_;  ///< one
    DividedRows divided_;
    std::vector<int> members_;
    std::size_t fewest_ = 0;
};

InterpolatedDesign::InterpolatedDesign(const MatchWave& campaign, const std::string& base,
                                       const DesignLoadRequest& request) {
    const std::span<const MatchWave> waves(&campaign, 1);
    const double time = averaging_time(campaign.table, request);
    const std::array targets{to_predict(fmt::format("mean_maximum_{:g}s", time), base)};
    data_ = match_data(waves, targets);
    index_ = emulate(data_);
    const EmulatedTarget& index = index_.front();
    std::string fault = index.emulated() ? index.mean().fault() : "no point is done";
    if (fault.empty() && index.mean().kind() == EmulatorKind::constant)
        fault = fmt::format("its emulator {}", index.mean().simpler());
    if (!fault.empty())
        throw InputError(
            fmt::format("{}: the mean maximum cannot be interpolated between the points of the design: {}; run more "
                        "points, or name points as cases",
                        campaign.file, fault));
    const CaseRuns runs = runs_of(waves, data_, std::vector<bool>(data_.points.size(), true), index, request);
    divided_ = rows_of(runs.runs, runs.measured);
    std::map<int, std::size_t> counts;  // by case
    for (const DividedRun& run : runs.runs) {
        members_.push_back(static_cast<int>(run.member));
        ++counts[campaign.table.members[run.member].case_index];
    }
    fewest_ = std::ranges::min(counts | std::views::values);
}

Emulated InterpolatedDesign::at(const Regime& regime) const {
    constexpr double rounding = 1e-9;
    std::vector<std::string> keys;
    for (const RangedAxis& axis : data_.axes) keys.push_back(axis.key);
    for (const Entry& value : regime.values)
        if (std::ranges::find(keys, value.path) == keys.end())
            throw InputError(fmt::format("{}: {} is no axis of the design; its axes are {}", value.where, value.path,
                                         fmt::join(keys, ", ")));
    Eigen::VectorXd at(static_cast<Eigen::Index>(keys.size()));
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const auto found = std::ranges::find(regime.values, keys[k], &Entry::path);
        if (found == regime.values.end())
            throw InputError(fmt::format("{}: the regime {} has no {}; give a value of each axis of the design: {}",
                                         regime.where, regime.name, keys[k], fmt::join(keys, ", ")));
        const RangedAxis& axis = data_.axes[k];
        const double value = number_of(found->value).value();
        const bool on_scale = axis.scale == AxisScale::linear || value > 0;
        const double coordinate = on_scale ? axis.coordinate(value) : -std::numeric_limits<double>::infinity();
        if (!(std::abs(coordinate) <= 1 + rounding))
            throw InputError(fmt::format(
                "{}: {} = {:g} is outside of the design, which has it from {:g} to {:g}; between its points loads are "
                "interpolated, beyond them nothing is known: run a design that reaches there",
                found->where, keys[k], value, axis.from, axis.to));
        at[static_cast<Eigen::Index>(k)] = coordinate;
    }
    Emulated index = index_.front().mean().at(at);
    index.variance += index_.front().common_variance(at);
    if (!(index.mean > 0))
        throw InputError(
            fmt::format("{}: the emulated mean maximum of the regime {} is {:.3g} N, which is no load; run more points "
                        "of the design near it",
                        regime.where, regime.name, index.mean));
    return index;
}

/// The tails that regimes have.
struct YearTails {
    std::vector<TailSource> sources;
    std::vector<std::unique_ptr<const PosteriorLoad>> posteriors;  ///< one a source
    std::vector<YearRegimeRow> regimes;
};

/// Makes each source once.
class TailFinder {
  public:
    TailFinder(const MatchWave& campaign, const YearRequest& request)
        : campaign_(campaign),
          request_(request),
          sample_(campaign.table),
          time_(averaging_time(campaign.table, request.load)) {}

    void add(const Regime& regime) {
        YearRegimeRow row{regime, {}};
        row.tail.time = regime.time / std::sqrt(request_.load.scale);
        if (regime.values.empty())
            row.tail.source = source_of_case(regime);
        else
            interpolate(row);
        made.regimes.push_back(std::move(row));
    }

    YearTails made;

  private:
    std::size_t source_of_case(const Regime& regime) {
        std::vector<std::string> names;
        for (const CaseRow& one : campaign_.table.cases) names.push_back(one.name);
        const auto found = std::ranges::find(names, regime.case_name);
        if (found == names.end())
            throw InputError(fmt::format("{}: case = \"{}\" is no case of {}; did you mean {}?", regime.where,
                                         regime.case_name, campaign_.file, nearest(names, regime.case_name)));
        const auto of_case = static_cast<std::size_t>(found - names.begin());
        const auto known = std::ranges::find(made.sources, std::optional(of_case), &TailSource::of_case);
        if (known != made.sources.end()) return static_cast<std::size_t>(known - made.sources.begin());
        refuse_rising(joint_trend(sample_, of_case), fmt::format("{}: case {}", regime.where, regime.case_name),
                      request_);
        const CasePeaks peaks = case_peaks(sample_, of_case, time_);
        add_source({regime.case_name, of_case, peaks.members, peaks.rows.size(), 0, {}}, peaks.rows, peaks.measured,
                   regime);
        return made.sources.size() - 1;
    }

    void interpolate(YearRegimeRow& row) {
        const Regime& regime = row.regime;
        const std::string base = design_case(campaign_, regime);
        auto known =
            std::ranges::find_if(made.sources, [&](const TailSource& one) { return !one.of_case && one.name == base; });
        if (known == made.sources.end()) {
            for (std::size_t k = 0; k < campaign_.table.cases.size(); ++k)
                if (campaign_.campaign.cases[k].base == base)
                    refuse_rising(joint_trend(sample_, k),
                                  fmt::format("{}: point {}", regime.where, campaign_.table.cases[k].name), request_);
            const InterpolatedDesign& design =
                designs_.try_emplace(made.sources.size(), campaign_, base, request_.load).first->second;
            add_source({base,
                        std::nullopt,
                        design.members(),
                        design.fewest_arrangements(),
                        0,
                        {},
                        name_of(design.index().kind()),
                        design.index().simpler()},
                       design.divided().rows, design.divided().measured, regime);
            known = made.sources.end() - 1;
        }
        row.tail.source = static_cast<std::size_t>(known - made.sources.begin());
        const Emulated index = designs_.at(row.tail.source).at(regime);
        row.tail.factor = index.mean;
        row.tail.factor_sd = std::sqrt(index.variance) / index.mean;
    }

    void add_source(TailSource source, const std::vector<PeakRow>& rows, const Measured& measured,
                    const Regime& regime) {
        if (rows.size() < fewest_members)
            throw InputError(
                fmt::format("{}: {} has {} of the {} members that a tail needs; 8 or more are a beginning, 50 say "
                            "something of rare loads",
                            regime.where, source.words(), rows.size(), fewest_members));
        const std::vector<std::span<const double>> peaks = peaks_of(rows);
        source.unlike = unlike_members(peaks, request_.load.share);
        source.time_run = measured.window * static_cast<double>(rows.size());
        auto posterior = std::make_unique<const PosteriorLoad>(
            peaks, source.unlike.out, measured,
            averaged_shares(request_.load.share, campaign_.table.cases.size() > most_averaged_cases));
        if (!posterior->valid())
            throw InputError(
                fmt::format("{}: {} has too few peaks for a tail in its {:.3g} h (a fit needs {}); run more "
                            "arrangements or longer windows",
                            regime.where, source.words(), source.time_run / unit::hour, fewest_peaks));
        made.sources.push_back(std::move(source));
        made.posteriors.push_back(std::move(posterior));
    }

    const MatchWave& campaign_;
    const YearRequest& request_;
    const Sample sample_;
    double time_;
    std::map<std::size_t, InterpolatedDesign> designs_;  ///< by source
};

/// The regimes' places in the order of the campaign's cases and of the values, which their text does not give, so that
/// neither tails nor sums depend on it.
std::vector<std::size_t> order_of(const MatchWave& campaign, const std::vector<Regime>& regimes) {
    const std::vector<CaseRow>& cases = campaign.table.cases;
    const auto place = [&](std::size_t k) {
        const auto of_case = std::ranges::find(cases, regimes[k].case_name, &CaseRow::name) - cases.begin();
        std::vector<std::pair<std::string, double>> values;
        for (const Entry& value : regimes[k].values) values.emplace_back(value.path, number_of(value.value).value());
        std::ranges::sort(values);
        return std::tuple(of_case, regimes[k].case_name, values, regimes[k].time);
    };
    std::vector<std::size_t> order(regimes.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, place);
    return order;
}

/// The items back in the order of the text.
template <class Item>
std::vector<Item> as_given(std::vector<Item> sorted, const std::vector<std::size_t>& order) {
    std::vector<Item> given(sorted.size());
    for (std::size_t k = 0; k < sorted.size(); ++k) given[order[k]] = std::move(sorted[k]);
    return given;
}

constexpr double counts_from = 0.1;  // of the peaks: a regime that has them decides the load

/// Frequencies of the curve: nine in ten years, then two to a power of ten, down to the rarest asked for.
std::vector<double> curve_probabilities(const std::vector<double>& asked) {
    std::vector<double> made{0.9, 0.63, 0.3};
    const double rarest = std::ranges::min(asked);
    for (double p = 0.1; p > rarest * 0.99; p /= std::sqrt(10.0)) made.push_back(p);
    return made;
}

YearLevel level_of(const YearLoad& load, double per_year, const YearTails& tails) {
    YearLevel level{per_year, load.load(per_year), {}, {}, 0};
    if (!std::isfinite(level.load.value)) return level;
    level.shares = load.shares(per_year);
    level.uncertainty = load.uncertainty(per_year);
    for (std::size_t k = 0; k < tails.regimes.size(); ++k)
        if (level.shares[k].value >= counts_from)
            level.beyond_run = std::max(level.beyond_run, level.shares[k].exceeded_once_in /
                                                              tails.sources[tails.regimes[k].tail.source].time_run);
    return level;
}

}  // namespace

std::string TailSource::words() const {
    if (of_case) return "case " + name;
    return name.empty() ? "the design" : fmt::format("the design's case {}", name);
}

std::string per_year_text(double per_year) {
    const double exponent = std::log10(per_year);
    return std::abs(exponent - std::round(exponent)) < 1e-9 ? fmt::format("10^{:.0f}", exponent)
                                                            : fmt::format("{:g}", per_year);
}

Year find_year(const MatchWave& campaign, const std::vector<Regime>& regimes, const YearRequest& request) {
    const std::vector<std::size_t> order = order_of(campaign, regimes);
    TailFinder finder(campaign, request);
    for (const std::size_t k : order) finder.add(regimes[k]);
    YearTails& tails = finder.made;
    std::vector<const PosteriorLoad*> posteriors;
    for (const auto& one : tails.posteriors) posteriors.push_back(one.get());
    std::vector<YearRegime> parts;
    for (const YearRegimeRow& row : tails.regimes) parts.push_back(row.tail);
    const YearLoad load(posteriors, parts);
    Year year;
    for (const double per_year : request.per_year) year.levels.push_back(level_of(load, per_year, tails));
    std::vector<YearLoad> alone;
    for (const YearRegime& part : parts)
        alone.push_back(YearLoad({&posteriors[part.source], 1}, {{0, part.time, part.factor, part.factor_sd}}));
    for (const double per_year : curve_probabilities(request.per_year)) {
        YearCurvePoint& point = year.curve.emplace_back(YearCurvePoint{per_year, load.load(per_year), {}});
        for (const YearLoad& one : alone) point.alone.push_back(one.load(per_year).value);
        point.alone = as_given(std::move(point.alone), order);
    }
    for (YearLevel& level : year.levels)
        if (!level.shares.empty()) level.shares = as_given(std::move(level.shares), order);
    year.sources = std::move(tails.sources);
    year.regimes = as_given(std::move(tails.regimes), order);
    return year;
}

namespace {

/// How far beyond the time run the intervals were tried (docs/year.md); farther, the output says so.
constexpr double tried_beyond = 1e7;

/// In whole percent.
std::string percent_of(double share) {
    if (!std::isfinite(share)) return "–";
    return share > 0 && share < 0.005 ? "<1 %" : fmt::format("{:.0f} %", share / unit::percent);
}

/// ISO 19906's names of the levels.
std::string level_name(double per_year) {
    if (std::abs(per_year / 1e-2 - 1) < 1e-9) return per_year_text(per_year) + " (extreme level)";
    if (std::abs(per_year / 1e-4 - 1) < 1e-9) return per_year_text(per_year) + " (abnormal level)";
    return per_year_text(per_year);
}

std::string hours_text(double seconds) {
    const double hours = seconds / unit::hour;
    return hours < 1e4 ? fmt::format("{:.3g}", hours) : fmt::format("{:.1e}", hours);
}

/// "it asks for 3e+04 h of thin ice, and 2.1 h were run"
std::string hours_asked(const Year& year, const YearLevel& level, const YearRequest& request) {
    const double time = std::sqrt(request.load.scale);
    const auto most = std::ranges::max_element(level.shares, {}, &YearShare::value) - level.shares.begin();
    const YearRegimeRow& row = year.regimes[static_cast<std::size_t>(most)];
    return fmt::format("it asks for {} h of {}, and {} h were run",
                       hours_text(time * level.shares[static_cast<std::size_t>(most)].exceeded_once_in),
                       row.regime.name, hours_text(time * year.sources[row.tail.source].time_run));
}

/// Members that stand out, designs of few points, and loads asked for farther than anybody tried.
std::string doubt_lines(const Year& year, const YearRequest& request) {
    std::string lines;
    for (const TailSource& source : year.sources) {
        if (source.unlike.out.empty()) continue;
        std::vector<int> numbers;
        for (const std::size_t row : source.unlike.out) numbers.push_back(source.members[row]);
        lines += fmt::format(
            "! {}: {} of {} members stand out: replay {}. They are a kind of member whose share is uncertain.\n",
            source.words(), numbers.size(), source.members.size(), fmt::join(numbers, ", "));
    }
    for (const TailSource& source : year.sources)
        if (!source.simpler.empty())
            lines += fmt::format("! {}: between its points the mean maximum {}.\n", source.words(), source.simpler);
    for (const YearLevel& level : year.levels)
        if (level.beyond_run > tried_beyond)
            lines += fmt::format(
                "! The load of {} a year is farther from what was run than these intervals were ever tried: {}.\n",
                per_year_text(level.per_year), hours_asked(year, level, request));
    return lines;
}

/// Whether the interval says something of the load, of sources that all have enough arrangements.
bool is_said(const LoadFigure& load, const Year& year) {
    std::size_t fewest = year.sources.front().members.size();
    for (const TailSource& source : year.sources) fewest = std::min(fewest, source.members.size());
    return says_something(load.value, load.interval, static_cast<int>(fewest));
}

/// With its limits alone where they say nothing of it.
Estimate at_scale(const LoadFigure& load, const Year& year, const YearRequest& request) {
    const double factor = request.load.factor();
    return {is_said(load, year) ? factor * load.value : std::nan(""), factor * load.interval.low,
            factor * load.interval.high};
}

/// The exceedance curve, for programs.
Results curve_rows(const Year& year, const YearRequest& request) {
    Results results{.place = "year/curve", .columns = {{"exceeded_a_year"}, estimates("load", "")}};
    for (const YearCurvePoint& point : year.curve) results.add({point.per_year, at_scale(point.all, year, request)});
    return results;
}

Section loads_section(const Year& year, const YearRequest& request) {
    Results results{
        .place = "year/loads",
        .columns = std::vector<ResultColumn>{{.words = "exceeded in a year with"}, estimates("", "load", "N")} +
                   program_columns("exceeded_a_year averaging scale")};
    results.columns[1].digits = 3;
    results.columns.push_back(estimates("load", ""));
    results.columns.push_back({"hours_for_one_over_hours_run"});
    std::vector<std::string> notes;
    const Units units = year_units(year, request);
    for (const YearLevel& level : year.levels) {
        const bool said = is_said(level.load, year);
        const Estimate told = at_scale(level.load, year, request);
        results.add({level_name(level.per_year), if_known(said, told), level.per_year, request.load.averaging,
                     request.load.scale, told, level.beyond_run});
        if (!std::isfinite(level.load.value))
            notes.push_back(fmt::format("{}: the regimes have so few hours that no load is exceeded so often.",
                                        per_year_text(level.per_year)));
        else if (!said)
            notes.push_back(
                fmt::format("{}: the tail cannot say: its interval is from {} to {}, wider than four times the load. "
                            "{}; run more members of what --next names, or longer windows.",
                            per_year_text(level.per_year), units.number(told.low, "N"), units.text(told.high, "N"),
                            capital(hours_asked(year, level, request))));
    }
    return {.title = fmt::format("Loads of a year: the largest averaged over {:g} s", request.load.averaging),
            .results = {std::move(results), curve_rows(year, request)},
            .after =
                "\nBrackets: 95 %, from draws of each regime's tails (both tails, docs/design_load.md). docs/year.md\n",
            .notes = std::move(notes)};
}

/// A line for each regime, and for programs one for each regime and level.
Section regimes_section(const Year& year, const YearRequest& request) {
    const double hours = std::sqrt(request.load.scale) / unit::hour;
    Results shown{.columns = {{.words = "regime"}, {.words = "h a year", .digits = 6}, {.words = "tail of"}}};
    for (const YearLevel& level : year.levels) {
        shown.columns.push_back(
            {.words = fmt::format("share at {}", per_year_text(level.per_year)), .unit = "share", .decimals = 0});
        shown.columns.push_back({.words = "once in, h"});
    }
    Results all{.place = "year/regimes",
                .columns = program_columns("regime hours_a_year source factor factor_sd exceeded_a_year")};
    all.columns.push_back(estimates("share", ""));
    all.columns.push_back({"hours_for_one"});
    for (std::size_t k = 0; k < year.regimes.size(); ++k) {
        const YearRegimeRow& row = year.regimes[k];
        const TailSource& source = year.sources[row.tail.source];
        const std::string tail =
            source.of_case ? source.words() : fmt::format("{} ± {:.0f} %", source.words(), 196 * row.tail.factor_sd);
        std::vector<Datum> line{row.regime.name, row.regime.time / unit::hour, tail};
        for (const YearLevel& level : year.levels) {
            const bool known = std::isfinite(level.load.value) && k < level.shares.size();
            const YearShare share = known ? level.shares[k] : YearShare{};
            line.push_back(if_known(known, share.value));
            line.push_back(if_known(known, hours_text(hours * unit::hour * share.exceeded_once_in)));
        }
        shown.add(std::move(line));
    }
    for (const YearLevel& level : year.levels)
        for (std::size_t k = 0; k < level.shares.size(); ++k) {
            const YearRegimeRow& row = year.regimes[k];
            const YearShare& of = level.shares[k];
            all.add({row.regime.name, row.regime.time / unit::hour, year.sources[row.tail.source].words(),
                     row.tail.factor, row.tail.factor_sd, level.per_year, within(of.value, of.interval),
                     hours * of.exceeded_once_in});
        }
    return {.results = {std::move(shown), std::move(all)},
            .after =
                "\nShare: of the expected number of peaks above the load, by regime. Once in: the hours of the regime "
                "in which it exceeds the load once on average.\n"};
}

Section sources_section(const Year& year, const YearRequest& request) {
    const double hours = std::sqrt(request.load.scale) / unit::hour;
    Results shown{.columns = {{.words = "what it rests on"}, {.words = "members"}, {.words = "run, h"}}};
    for (const YearLevel& level : year.levels)
        shown.columns.push_back({.words = fmt::format("of the uncertainty at {}", per_year_text(level.per_year)),
                                 .unit = "share",
                                 .decimals = 0});
    for (std::size_t k = 0; k < year.sources.size(); ++k) {
        const TailSource& source = year.sources[k];
        std::vector<Datum> line{source.words(), source.members.size(),
                                hours_text(hours * unit::hour * source.time_run)};
        for (const YearLevel& level : year.levels)
            line.push_back(level.uncertainty.empty() ? Datum(Undefined{}) : Datum(level.uncertainty[k]));
        shown.add(std::move(line));
    }
    Results all{.place = "year/sources",
                .columns = program_columns(
                    "source members hours_run stand_out interpolation exceeded_a_year share_of_uncertainty")};
    for (const YearLevel& level : year.levels)
        for (std::size_t k = 0; k < level.uncertainty.size(); ++k) {
            const TailSource& source = year.sources[k];
            all.add({source.words(), source.members.size(), hours * source.time_run, source.unlike.out.size(),
                     source.interpolation, level.per_year, level.uncertainty[k]});
        }
    const auto members = [](const TailSource& one) { return one.members.size(); };
    const std::size_t fewest = members(*std::ranges::min_element(year.sources, {}, members));
    return {
        .results = {std::move(shown), std::move(all)},
        .after = fmt::format(
            "\nOf the uncertainty: the part of the variance of the load's logarithm that would go if this tail were "
            "known. A kind of member that is none of the {} may be {} of all; its loads are not in the figures.\n",
            fewest, percent_of(unseen_share(fewest)))};
}

}  // namespace

Units year_units(const Year& year, const YearRequest& request) {
    double largest = 0;
    for (const YearLevel& level : year.levels)
        if (level.load.value > largest) largest = level.load.value;
    return Units(largest * request.load.factor());
}

std::vector<Section> year_sections(const Evidence& evidence, const Year& year, const YearRequest& request) {
    double hours = 0;
    for (const YearRegimeRow& row : year.regimes) hours += row.regime.time / unit::hour;
    Section basis = sources_section(year, request);
    if (std::optional<Figure> figure = year_figure(year, request)) basis.figures = {std::move(*figure)};
    const std::string scale =
        request.load.scale == 1
            ? ""
            : fmt::format("Full scale by Froude, 1 : {:g}: hours, averaging time and loads are those at full scale.\n",
                          request.load.scale);
    const bool leap = hours > year_hours * (1 + rounding_of_hours);
    return {{.before = fmt::format("{}Campaign {}: {} regimes with {:g} h a year{}.\n{}{}\n",
                                   doubt_lines(year, request), evidence.summary.title, year.regimes.size(), hours,
                                   leap ? ", a leap year, whose hours are taken as they stand" : "", scale,
                                   fmt::join(condition_lines(evidence.summary), "\n"))},
            loads_section(year, request),
            regimes_section(year, request),
            std::move(basis)};
}

bool says_some_load(const Year& year) {
    return std::ranges::any_of(year.levels, [&](const YearLevel& level) { return is_said(level.load, year); });
}

std::optional<Figure> year_figure(const Year& year, const YearRequest& request) {
    constexpr std::size_t most_told_apart = 6;
    const double factor = request.load.factor();
    std::vector<double> values;
    Figure::Points low, high, middle;
    for (const YearCurvePoint& point : year.curve) {
        if (!is_said(point.all, year)) continue;
        low.emplace_back(factor * point.all.interval.low, point.per_year);
        high.emplace_back(factor * point.all.interval.high, point.per_year);
        middle.emplace_back(factor * point.all.value, point.per_year);
        values.push_back(middle.back().first);
        values.push_back(std::min(high.back().first, 3 * middle.back().first));
    }
    if (middle.empty()) return {};
    const double rarest = year.curve.back().per_year;
    Figure figure{.description = "Probability that the largest load of a year exceeds a load",
                  .x = axis_around(fmt::format("largest load of a year, averaged over {:g} s", request.load.averaging),
                                   values, true, "N"),
                  .y = {"probability of exceedance in a year", rarest * 0.7, 1, true},
                  .size = {720, 380}};
    // The band lies between curves along the loads, so it is an outline, cut off where the axis ends.
    Figure::Points outline = low;
    outline.insert(outline.end(), high.rbegin(), high.rend());
    for (auto& [load, probability] : outline) load = std::clamp(load, figure.x.low, figure.x.high);
    figure.area(std::move(outline), "ink veil");
    const bool colours = year.regimes.size() <= most_told_apart;
    for (std::size_t regime = 0; regime < year.regimes.size(); ++regime) {
        Figure::Points line;
        for (const YearCurvePoint& point : year.curve)
            if (is_said(point.all, year) && std::isfinite(point.alone[regime]) &&
                factor * point.alone[regime] <= figure.x.high)
                line.emplace_back(factor * point.alone[regime], point.per_year);
        figure.line(std::move(line), colours ? colour(regime) : "thin");
        if (colours) figure.legend.emplace_back(colour(regime), year.regimes[regime].regime.name);
    }
    const std::size_t middle_count = middle.size();
    figure.line(std::move(middle), "thick");
    figure.legend.emplace_back("ink", "all regimes");
    for (const YearLevel& level : year.levels) figure.level(level.per_year, "dashed");
    figure.caption = fmt::format(
        "Probability that the largest load of a year exceeds a load: of all regimes (thick, with its 95 % interval), "
        "and of each as if there were no other{}. Dashed: the probabilities asked for.{}",
        colours ? "" : " (thin)",
        middle_count < year.curve.size() ? " Loads whose interval says nothing of them are left out." : "");
    return figure;
}

Section year_next(const Evidence& evidence, const Year& year, const std::string& program, const std::string& file) {
    const YearLevel& rarest = *std::ranges::min_element(year.levels, {}, &YearLevel::per_year);
    if (rarest.uncertainty.empty())
        return {.before = "Next: nothing, because no regime has the load so often; check hours_per_year.\n"};
    const auto widest =
        static_cast<std::size_t>(std::ranges::max_element(rarest.uncertainty) - rarest.uncertainty.begin());
    const TailSource& source = year.sources[widest];
    const std::string& name = evidence.campaign.name;
    const int arrangements = 2 * std::max(evidence.campaign.arrangements, static_cast<int>(source.arrangements));
    return {.before = fmt::format(
                "Next: {} wants more members: it has {} of the uncertainty of the load of {} a year.\n  {} --set "
                "campaign.arrangements={} --resume\nThis doubles the arrangements of all cases; what is done is not "
                "computed again. Give every --set of the first run as well.\n",
                source.words(), percent_of(rarest.uncertainty[widest]), per_year_text(rarest.per_year),
                file.empty() ? "the command of each part, with"
                             : fmt::format("{} run {} -o {}", program, configuration_word(name), file),
                arrangements)};
}

}  // namespace floes
