#include "inference/design_load.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/units.hpp"
#include "inference/posterior_load.hpp"
#include "inference/tails.hpp"

namespace floes {
namespace {

constexpr double peak_budget = 5e5;         // peaks fitted in all resamples; at least 199 resamples, at most 999
constexpr double no_expected_from = 0.9;    // the shape from which the mean of the largest is near infinite or is
constexpr std::size_t most_left_out = 100;  // rows, or groups of rows, that the jackknife leaves out in turn

using Rows = std::span<const std::uint32_t>;

/// Expected largest load, then its quantiles.
using Figures = std::vector<double>;

/// NaN of a tail that could not be fitted.
Figures figures_of(const Tail& tail, const Exposure& exposure) {
    if (!tail.valid()) return Figures(exposure.probabilities.size() + 1, undefined);
    const bool expected = tail.kind == TailKind::weibull || tail.shape < no_expected_from;
    Figures figures{expected ? expected_largest(tail, exposure.time) : undefined};
    for (const double p : exposure.probabilities) figures.push_back(quantile_of_largest(tail, exposure.time, p));
    return figures;
}

/// The mean of the largest of `count` maxima: Gumbel's moves by scale log count, GEV's by the power of count.
double expected_of_maxima(const ExtremeFit& fit, double count) {
    if (std::abs(fit.shape) < 1e-9) return fit.location + fit.scale * (std::log(count) + std::numbers::egamma);
    if (fit.shape >= no_expected_from) return undefined;
    return fit.location + fit.scale / fit.shape * (std::pow(count, fit.shape) * std::tgamma(1 - fit.shape) - 1);
}

Figures figures_of(const ExtremeFit& fit, const Exposure& exposure, double segment) {
    const double count = exposure.time / segment;
    Figures figures(exposure.probabilities.size() + 1, undefined);
    if (!fit.valid()) return figures;
    figures[0] = expected_of_maxima(fit, count);
    for (std::size_t k = 0; k < exposure.probabilities.size(); ++k)
        figures[k + 1] = extreme_quantile(fit, std::exp(std::log(exposure.probabilities[k]) / count));
    return figures;
}

/// The peak that the given share of all peaks exceeds.
double threshold_of(const std::vector<PeakRow>& rows, double share) {
    std::vector<double> all;
    for (const PeakRow& row : rows) all.insert(all.end(), row.peaks.begin(), row.peaks.end());
    if (all.empty()) return undefined;
    std::ranges::sort(all);
    return quantile_of_sorted(all, 1 - share);
}

struct BothTails {
    Tail pareto;
    Tail weibull;

    bool valid() const { return pareto.valid() && weibull.valid(); }
    /// Akaike weight; both have as many parameters.
    double weibull_weight() const { return 1 / (1 + std::exp(pareto.log_likelihood - weibull.log_likelihood)); }
};

/// The figures of two tails, of which the second one has that weight.
Figures weighted(const Figures& one, const Figures& other, double weight) {
    Figures both(one.size());
    for (std::size_t k = 0; k < one.size(); ++k) both[k] = (1 - weight) * one[k] + weight * other[k];
    return both;
}

/// Fits the peaks above one threshold, of rows drawn from all.
class TailFitter {
  public:
    TailFitter(const std::vector<PeakRow>& rows, const Measured& measured, double threshold)
        : rows_(rows), measured_(measured), threshold_(threshold) {}

    BothTails fit(Rows drawn) const {
        std::vector<double> excesses;
        for (const std::uint32_t row : drawn)
            for (const double peak : rows_[row].peaks) {
                if (!(peak > threshold_)) break;  // sorted, falling
                excesses.push_back(peak - threshold_);
            }
        std::ranges::sort(excesses, std::ranges::greater{});
        const double time = measured_.window * static_cast<double>(drawn.size());
        std::vector<double> weights;
        for (std::size_t higher = 0; higher < excesses.size(); ++higher)
            weights.push_back(events_per_peak((static_cast<double>(higher) + 0.5) * measured_.separation / time));
        return {fit_tail(TailKind::pareto, excesses, weights, threshold_, measured_.mean, time),
                fit_tail(TailKind::weibull, excesses, weights, threshold_, measured_.mean, time)};
    }

  private:
    const std::vector<PeakRow>& rows_;
    Measured measured_;
    double threshold_;
};

/// A draw a row, a figure a column.
using Resamples = std::vector<Figures>;

std::vector<double> column(const Resamples& draws, std::size_t figure) {
    std::vector<double> values;
    for (const Figures& row : draws) values.push_back(row[figure]);
    return values;
}

/// The figures of each tail from all rows, resampled, and with rows left out in turn.
struct TailDraws {
    Figures all;
    Resamples resampled;
    Resamples without;

    /// Sorted draws whose percentiles are the BCa limits.
    std::vector<double> corrected(std::size_t figure) const {
        return bca_draws(column(resampled, figure), all[figure], column(without, figure));
    }
};

DesignLoadEstimate estimate(LargestBy method, const Figures& values, const std::function<Limits(std::size_t)>& limits) {
    DesignLoadEstimate made{.method = method, .expected = {values[0], limits(0)}, .quantiles = {}};
    for (std::size_t k = 1; k < values.size(); ++k) made.quantiles.push_back({values[k], limits(k)});
    return made;
}

int resamples_for(std::size_t values) {
    return static_cast<int>(
        std::clamp(peak_budget / static_cast<double>(std::max<std::size_t>(values, 1)), 199.0, 999.0));
}

/// Both tails of members that differ.
void add_posterior(MemberPeakSpans peaks, const Measured& measured, const Exposure& exposure, DesignLoad& load) {
    const PosteriorLoad found(
        peaks, load.unlike.out,
        {measured.window, measured.separation, measured.mean, averaged_shares(exposure.share, exposure.quick)});
    if (!found.valid()) return;
    load.weibull_weight = found.weibull_weight();
    load.scatter = found.scatter();
    load.alike = found.alike();
    DesignLoadEstimate made{LargestBy::both_tails, {.value = undefined, .interval = {undefined, undefined}}, {}};
    if (exposure.expected) made.expected = found.expected(exposure.time);
    for (const double p : exposure.probabilities) made.quantiles.push_back(found.quantile(exposure.time, p));
    load.estimates.push_back(std::move(made));
}

/// Each tail alone, of members taken as alike; `tails`: of all rows.
void add_tails(const std::vector<PeakRow>& rows, const TailFitter& fitter, const BothTails& tails,
               const Exposure& exposure, DesignLoad& load) {
    TailDraws pareto{.all = figures_of(tails.pareto, exposure), .resampled = {}, .without = {}};
    TailDraws weibull{.all = figures_of(tails.weibull, exposure), .resampled = {}, .without = {}};
    const auto take = [&](const BothTails& found, Resamples TailDraws::*into) {
        (pareto.*into).push_back(figures_of(found.pareto, exposure));
        (weibull.*into).push_back(figures_of(found.weibull, exposure));
    };
    // A draw that cannot be fitted stays as NaN, so that the same draws of two cases keep the same place.
    bootstrap(rows.size(),
              [&](Rows drawn) {
                  take(fitter.fit(drawn), &TailDraws::resampled);
                  return 0.0;
              },
              {.resamples = resamples_for(load.peaks)});
    leave_out(rows.size(), most_left_out, [&](Rows others) {
        if (const BothTails found = fitter.fit(others); found.valid()) take(found, &TailDraws::without);
    });
    std::vector<std::vector<double>> of_pareto, of_weibull;
    for (std::size_t k = 0; k <= exposure.probabilities.size(); ++k) {
        of_pareto.push_back(pareto.corrected(k));
        of_weibull.push_back(weibull.corrected(k));
    }
    const auto limits_of = [](const std::vector<std::vector<double>>& draws) {
        return [&](std::size_t k) { return percentile_interval(draws[k]); };
    };
    load.estimates.push_back(estimate(LargestBy::pareto, pareto.all, limits_of(of_pareto)));
    load.estimates.push_back(estimate(LargestBy::weibull, weibull.all, limits_of(of_weibull)));
    for (std::size_t draw = 0; draw < pareto.resampled.size(); ++draw) {
        const Figures both = weighted(pareto.resampled[draw], weibull.resampled[draw], load.weibull_weight);
        load.draws.emplace_back(both.begin() + 1, both.end());
        load.dropped += std::isfinite(both.back()) ? 0 : 1;
    }
}

void add_maxima(const std::vector<PeakRow>& rows, double segment, const Exposure& exposure, ExtremeKind kind,
                DesignLoad& load) {
    const auto maxima_of = [&](Rows drawn) {
        std::vector<double> maxima;
        for (const std::uint32_t row : drawn)
            maxima.insert(maxima.end(), rows[row].segment_maxima.begin(), rows[row].segment_maxima.end());
        return maxima;
    };
    const std::vector<double> all = maxima_of(all_rows(rows.size()));
    const ExtremeFit fit = fit_maxima(all, kind);
    Resamples draws;
    if (fit.valid())
        bootstrap(rows.size(),
                  [&](Rows drawn) {
                      const ExtremeFit found = fit_maxima(maxima_of(drawn), kind, &fit);
                      if (found.valid()) draws.push_back(figures_of(found, exposure, segment));
                      return 0.0;
                  },
                  {.resamples = resamples_for(4 * all.size())});
    load.estimates.push_back(estimate(kind == ExtremeKind::gumbel ? LargestBy::gumbel : LargestBy::gev,
                                      figures_of(fit, exposure, segment),
                                      [&](std::size_t k) { return percentile_interval(column(draws, k)); }));
}

}  // namespace

std::string_view name_of(LargestBy method) {
    constexpr std::array<std::string_view, 5> names{"both tails", "Pareto tail", "Weibull tail", "Gumbel", "GEV"};
    return names.at(static_cast<std::size_t>(method));
}

DesignLoad load_by_both_tails(const std::vector<PeakRow>& rows, const Measured& measured, const Exposure& exposure) {
    DesignLoad load;
    load.arrangements = rows.size();
    load.time_run = measured.window * static_cast<double>(rows.size());
    load.threshold = threshold_of(rows, exposure.share);
    for (const PeakRow& row : rows)
        load.peaks += static_cast<std::size_t>(
            std::ranges::count_if(row.peaks, [&](double peak) { return peak > load.threshold; }));
    std::vector<std::span<const double>> peaks;
    for (const PeakRow& row : rows) peaks.emplace_back(row.peaks);
    load.unlike = unlike_members(peaks, exposure.share);
    if (rows.size() < fewest_members || load.peaks < fewest_peaks || !(load.threshold > measured.mean)) return load;
    const BothTails tails = TailFitter(rows, measured, load.threshold).fit(all_rows(rows.size()));
    if (!tails.valid()) return load;
    load.pareto = tails.pareto;
    load.weibull = tails.weibull;
    add_posterior(peaks, measured, exposure, load);
    return load;
}

DesignLoad design_load(const std::vector<PeakRow>& rows, const Measured& measured, const Exposure& exposure) {
    DesignLoad load = load_by_both_tails(rows, measured, exposure);
    if (!load.valid()) return load;
    const TailFitter fitter(rows, measured, load.threshold);
    add_tails(rows, fitter, {load.pareto, load.weibull}, exposure, load);
    add_maxima(rows, measured.segment, exposure, ExtremeKind::gumbel, load);
    add_maxima(rows, measured.segment, exposure, ExtremeKind::gev, load);
    return load;
}

std::vector<std::vector<double>> over_thresholds(const std::vector<PeakRow>& rows, const Measured& measured,
                                                 const Exposure& exposure, const std::vector<double>& shares) {
    std::vector<std::vector<double>> all;
    for (const double share : shares) {
        const double threshold = threshold_of(rows, share);
        Figures& found = all.emplace_back(exposure.probabilities.size(), undefined);
        if (!(threshold > measured.mean)) continue;
        const BothTails tails = TailFitter(rows, measured, threshold).fit(all_rows(rows.size()));
        if (!tails.valid()) continue;
        const Figures both =
            weighted(figures_of(tails.pareto, exposure), figures_of(tails.weibull, exposure), tails.weibull_weight());
        found.assign(both.begin() + 1, both.end());
    }
    return all;
}

}  // namespace floes
