#include "match/year.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/design_load.hpp"
#include "keys/edit_distance.hpp"
#include "match/predict.hpp"

namespace floes {

namespace {

/// At least one, so that a nearest one exists.
std::string nearest(const std::vector<std::string>& names, const std::string& name) {
    return *std::ranges::min_element(names, {}, [&](const std::string& one) { return edit_distance(one, name); });
}

void refuse_rising(const JointTrend& trend, const std::string& who, const YearRequest& request) {
    if (trend.rises() && !request.load.rising)
        throw InputError(fmt::format(
            "{}: {}, so it is not known how high it gets later; measure later (--window auto, or run with a later "
            "analysis.steady_start_s), or give --rising to extrapolate as if it stayed as in the window",
            who, trend_text(trend)));
}

/// Makes each source once.
class TailFinder {
  public:
    TailFinder(const MatchWave& campaign, const YearRequest& request)
        : campaign_(campaign),
          request_(request),
          time_(averaging_time(campaign.table, request.load)),
          trends_(joint_trends(campaign.table)) {}

    YearRegimeRow row(const Regime& regime) {
        YearRegimeRow row{regime, {}};
        row.tail.time = regime.time / std::sqrt(request_.load.scale);
        if (regime.values.empty())
            row.tail.source = source_of_case(regime);
        else
            interpolate(row);
        return row;
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
        refuse_rising(trends_[of_case], fmt::format("{}: case {}", regime.where, regime.case_name), request_);
        const CasePeaks peaks = case_peaks(campaign_.table, of_case, time_);
        add({regime.case_name, of_case, peaks.members, peaks.rows.size(), 0, {}}, peaks.rows, peaks.measured, regime);
        return made.sources.size() - 1;
    }

    void interpolate(YearRegimeRow& row) {
        const Regime& regime = row.regime;
        const std::string base = design_case(campaign_, regime);
        auto known =
            std::ranges::find_if(made.sources, [&](const TailSource& one) { return !one.of_case && one.name == base; });
        if (known == made.sources.end()) {
            for (std::size_t k = 0; k < trends_.size(); ++k)
                if (campaign_.campaign.cases[k].base == base)
                    refuse_rising(trends_[k], fmt::format("{}: point {}", regime.where, campaign_.table.cases[k].name),
                                  request_);
            indices_.push_back(std::make_unique<InterpolatedDesign>(campaign_, base, request_.load));
            const InterpolatedDesign& design = *indices_.back();
            add({base, std::nullopt, design.members(), design.fewest_arrangements(), 0, {}}, design.rows(),
                design.measured(), regime);
            design_of_.resize(made.sources.size(), 0);
            design_of_.back() = indices_.size() - 1;
            known = made.sources.end() - 1;
        }
        row.tail.source = static_cast<std::size_t>(known - made.sources.begin());
        const Emulated index = indices_[design_of_[row.tail.source]]->at(regime);
        row.tail.factor = index.mean;
        row.tail.factor_sd = std::sqrt(index.variance) / index.mean;
    }

    void add(TailSource source, const std::vector<PeakRow>& rows, const Measured& measured, const Regime& regime) {
        if (rows.size() < fewest_members)
            throw InputError(
                fmt::format("{}: {} has {} of the {} members that a tail needs; 8 or more are a beginning, "
                            "50 say something of rare loads",
                            regime.where, source.words(), rows.size(), fewest_members));
        std::vector<std::span<const double>> peaks;
        for (const PeakRow& one : rows) peaks.emplace_back(one.peaks);
        source.unlike = unlike_members(peaks, request_.load.share);
        source.time_run = measured.window * static_cast<double>(rows.size());
        auto posterior = std::make_unique<const PosteriorLoad>(
            peaks, source.unlike.out,
            PosteriorAsked{measured.window, measured.separation, measured.mean,
                           averaged_shares(request_.load.share, campaign_.table.cases.size() > most_averaged_cases)});
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
    double time_;
    std::vector<JointTrend> trends_;
    std::vector<std::unique_ptr<InterpolatedDesign>> indices_;
    std::vector<std::size_t> design_of_;  ///< for each source its place in indices_
};

}  // namespace

std::string TailSource::words() const {
    if (of_case) return "case " + name;
    return name.empty() ? "the design" : fmt::format("the design's case {}", name);
}

YearTails year_tails(const MatchWave& campaign, const std::vector<Regime>& regimes, const YearRequest& request) {
    TailFinder finder(campaign, request);
    for (const Regime& regime : regimes) {
        YearRegimeRow row = finder.row(regime);
        finder.made.regimes.push_back(std::move(row));
    }
    return std::move(finder.made);
}

namespace {

double number_of(const Entry& entry) {
    if (const auto* whole = std::get_if<std::int64_t>(&entry.value.data)) return static_cast<double>(*whole);
    return std::get<double>(entry.value.data);
}

}  // namespace

std::string design_case(const MatchWave& campaign, const Regime& regime) {
    if (!campaign.campaign.design.active())
        throw InputError(fmt::format(
            "{}: the regime {} gives {}, and {} has no design to interpolate; name one of its "
            "cases with case = \"…\", or run a [design] over {}",
            regime.where, regime.name, regime.values.front().path, campaign.file, regime.values.front().path));
    const std::vector<std::string> bases = match_cases({&campaign, 1});
    if (regime.case_name.empty() && bases.size() == 1) return bases.front();
    if (std::ranges::find(bases, regime.case_name) != bases.end()) return regime.case_name;
    if (bases.size() == 1 && bases.front().empty())
        throw InputError(
            fmt::format("{}: the design of {} has no [[case]] named {}; leave case out, or leave out the "
                        "values of axes to name one of its points",
                        regime.where, campaign.file, regime.case_name));
    throw InputError(
        fmt::format("{}: the regime {} has to say which [[case]] of the design it means: case = \"…\", one "
                    "of {}",
                    regime.where, regime.name, fmt::join(bases, ", ")));
}

InterpolatedDesign::InterpolatedDesign(const MatchWave& campaign, const std::string& base,
                                       const DesignLoadRequest& request) {
    const std::span<const MatchWave> waves(&campaign, 1);
    const double time = averaging_time(campaign.table, request);
    const std::array targets{to_predict(fmt::format("mean_maximum_{:g}s", time), base)};
    data_ = match_data(waves, targets);
    index_ = emulate(data_);
    const EmulatedTarget& index = index_.front();
    if (!index.emulated() || !index.mean().fault().empty())
        throw InputError(
            fmt::format("{}: the mean maximum cannot be interpolated between the points of the design: {}; "
                        "run more points, or name points as cases",
                        campaign.file, index.emulated() ? index.mean().fault() : "no point is done"));
    const CaseRuns runs = runs_of(waves, data_, std::vector<bool>(data_.points.size(), true), index, request);
    DividedRows divided = rows_of(runs.runs);
    measured_ = runs.measured;
    measured_.mean = divided.mean;
    rows_ = std::move(divided.rows);
    std::vector<std::size_t> counts(campaign.campaign.cases.size(), 0);
    for (const MemberRow& row : campaign.table.members) {
        const auto of_case = static_cast<std::size_t>(row.case_index);
        if (campaign.campaign.cases[of_case].base != base || row.averaged_over(time) == nullptr) continue;
        members_.push_back(static_cast<int>(&row - campaign.table.members.data()));
        ++counts[of_case];
    }
    fewest_ = std::numeric_limits<std::size_t>::max();
    for (const std::size_t count : counts)
        if (count > 0) fewest_ = std::min(fewest_, count);
}

Emulated InterpolatedDesign::at(const Regime& regime) const {
    constexpr double rounding = 1e-9;
    std::vector<std::string> keys;
    for (const MatchAxis& axis : data_.axes) keys.push_back(axis.key);
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
        const MatchAxis& axis = data_.axes[k];
        const double value = number_of(*found);
        const bool on_scale = axis.scale == AxisScale::linear || value > 0;
        const double coordinate = on_scale ? axis.coordinate(value) : -std::numeric_limits<double>::infinity();
        if (!(std::abs(coordinate) <= 1 + rounding))
            throw InputError(
                fmt::format("{}: {} = {:g} is outside of the design, which has it from {:g} to {:g}; between "
                            "its points loads are interpolated, beyond them nothing is known: run a "
                            "design that reaches there",
                            found->where, keys[k], value, axis.from, axis.to));
        at[static_cast<Eigen::Index>(k)] = coordinate;
    }
    Emulated index = index_.front().mean().at(at);
    index.variance += index_.front().common_variance(at);
    if (!(index.mean > 0))
        throw InputError(
            fmt::format("{}: the emulated mean maximum of the regime {} is {:.3g} N, which is no load; run "
                        "more points of the design near it",
                        regime.where, regime.name, index.mean));
    return index;
}

namespace {

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

Year find_year(const MatchWave& campaign, const std::vector<Regime>& regimes, const YearRequest& request) {
    YearTails tails = year_tails(campaign, regimes, request);
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
    }
    year.sources = std::move(tails.sources);
    year.regimes = std::move(tails.regimes);
    return year;
}

}  // namespace floes
