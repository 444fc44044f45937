#include "inference/design_load.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/units.hpp"

namespace floes {
namespace {

constexpr double peak_budget = 5e5;       // peaks fitted in all resamples; at least 199 resamples, at most 999
constexpr double no_expected_from = 0.9;  // the shape from which the mean of the largest is near infinite or is

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
double threshold_of(MemberPeakSpans peaks, double share) {
    const std::vector<double> all = pooled_peaks(peaks, {}, false);
    return all.empty() ? undefined : quantile_of_sorted(all, 1 - share);
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

/// Fitted to the peaks above one threshold, of rows drawn from all.
BothTails fit_tails(const std::vector<PeakRow>& rows, const Measured& measured, double threshold, Rows drawn) {
    std::vector<double> excesses;
    for (const std::uint32_t row : drawn)
        for (const double peak : rows[row].peaks) {
            if (!(peak > threshold)) break;  // sorted, falling
            excesses.push_back(peak - threshold);
        }
    std::ranges::sort(excesses, std::ranges::greater{});
    const double time = measured.window * static_cast<double>(drawn.size());
    std::vector<double> weights;
    for (std::size_t higher = 0; higher < excesses.size(); ++higher)
        weights.push_back(events_per_peak((static_cast<double>(higher) + 0.5) * measured.separation / time));
    return {fit_tail(TailKind::pareto, excesses, weights, threshold, measured.mean, time),
            fit_tail(TailKind::weibull, excesses, weights, threshold, measured.mean, time)};
}

/// Without limits.
DesignLoadEstimate estimate(LargestBy method, const Figures& values) {
    constexpr Limits none{undefined, undefined};
    DesignLoadEstimate made{.method = method, .expected = {values[0], none}, .quantiles = {}};
    for (std::size_t k = 1; k < values.size(); ++k) made.quantiles.push_back({values[k], none});
    return made;
}

int resamples_for(std::size_t values) {
    return static_cast<int>(
        std::clamp(peak_budget / static_cast<double>(std::max<std::size_t>(values, 1)), 199.0, 999.0));
}

/// Both tails of members that differ.
void add_posterior(MemberPeakSpans peaks, const Measured& measured, const Exposure& exposure, DesignLoad& load) {
    const PosteriorLoad found(peaks, load.unlike.out, measured, averaged_shares(exposure.share, exposure.quick));
    if (!found.valid()) return;
    load.weibull_weight = found.weibull_weight();
    load.scatter = found.scatter();
    load.alike = found.alike();
    DesignLoadEstimate made{LargestBy::both_tails, {.value = undefined, .interval = {undefined, undefined}}, {}};
    if (exposure.expected) made.expected = found.expected(exposure.time);
    for (const double p : exposure.probabilities) made.quantiles.push_back(found.quantile(exposure.time, p));
    load.estimates.push_back(std::move(made));
}

/// Each tail alone, of members taken as alike, and draws of both for differences between cases.
void add_tails(const std::vector<PeakRow>& rows, const Measured& measured, const Exposure& exposure, DesignLoad& load) {
    load.estimates.push_back(estimate(LargestBy::pareto, figures_of(load.pareto, exposure)));
    load.estimates.push_back(estimate(LargestBy::weibull, figures_of(load.weibull, exposure)));
    // A draw that cannot be fitted stays as NaN, so that the same draws of two cases keep the same place.
    bootstrap(
        rows.size(),
        [&](Rows drawn) {
            const BothTails found = fit_tails(rows, measured, load.threshold, drawn);
            const Figures both =
                weighted(figures_of(found.pareto, exposure), figures_of(found.weibull, exposure), load.weibull_weight);
            load.draws.emplace_back(both.begin() + 1, both.end());
            load.dropped += std::isfinite(both.back()) ? 0 : 1;
            return 0.0;
        },
        resamples_for(load.peaks));
}

void add_maxima(const std::vector<PeakRow>& rows, double segment, const Exposure& exposure, DesignLoad& load) {
    std::vector<double> maxima;
    for (const PeakRow& row : rows) maxima.insert(maxima.end(), row.segment_maxima.begin(), row.segment_maxima.end());
    for (const auto& [method, kind] :
         {std::pair{LargestBy::gumbel, ExtremeKind::gumbel}, std::pair{LargestBy::gev, ExtremeKind::gev}})
        load.estimates.push_back(estimate(method, figures_of(fit_maxima(maxima, kind), exposure, segment)));
}

}  // namespace

std::string_view name_of(LargestBy method) {
    constexpr std::array<std::string_view, 5> names{"both tails", "Pareto tail", "Weibull tail", "Gumbel", "GEV"};
    return names.at(static_cast<std::size_t>(method));
}

std::vector<std::span<const double>> peaks_of(const std::vector<PeakRow>& rows) {
    std::vector<std::span<const double>> peaks;
    for (const PeakRow& row : rows) peaks.emplace_back(row.peaks);
    return peaks;
}

DesignLoad load_by_both_tails(const std::vector<PeakRow>& rows, const Measured& measured, const Exposure& exposure) {
    DesignLoad load;
    load.arrangements = rows.size();
    load.time_run = measured.window * static_cast<double>(rows.size());
    const std::vector<std::span<const double>> peaks = peaks_of(rows);
    load.threshold = threshold_of(peaks, exposure.share);
    for (const PeakRow& row : rows)
        load.peaks += static_cast<std::size_t>(
            std::ranges::count_if(row.peaks, [&](double peak) { return peak > load.threshold; }));
    load.unlike = unlike_members(peaks, exposure.share);
    if (rows.size() < fewest_members || load.peaks < fewest_peaks || !(load.threshold > measured.mean)) return load;
    const BothTails tails = fit_tails(rows, measured, load.threshold, all_rows(rows.size()));
    if (!tails.valid()) return load;
    load.pareto = tails.pareto;
    load.weibull = tails.weibull;
    add_posterior(peaks, measured, exposure, load);
    return load;
}

DesignLoad design_load(const std::vector<PeakRow>& rows, const Measured& measured, const Exposure& exposure) {
    DesignLoad load = load_by_both_tails(rows, measured, exposure);
    if (!load.valid()) return load;
    add_tails(rows, measured, exposure, load);
    add_maxima(rows, measured.segment, exposure, load);
    return load;
}

std::vector<std::vector<double>> over_thresholds(const std::vector<PeakRow>& rows, const Measured& measured,
                                                 const Exposure& exposure, const std::vector<double>& shares) {
    std::vector<std::vector<double>> all;
    for (const double share : shares) {
        const double threshold = threshold_of(peaks_of(rows), share);
        Figures& found = all.emplace_back(exposure.probabilities.size(), undefined);
        if (!(threshold > measured.mean)) continue;
        const BothTails tails = fit_tails(rows, measured, threshold, all_rows(rows.size()));
        if (!tails.valid()) continue;
        const Figures both =
            weighted(figures_of(tails.pareto, exposure), figures_of(tails.weibull, exposure), tails.weibull_weight());
        found.assign(both.begin() + 1, both.end());
    }
    return all;
}

}  // namespace floes
