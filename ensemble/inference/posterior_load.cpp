#include "inference/posterior_load.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/random.hpp"
#include "core/units.hpp"
#include "inference/explained_variance.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

constexpr double weibull_before = 1.0 / 3;
constexpr double most_weibull = 7.0 / 9;
constexpr double highest_origin = 0.9;  // of the threshold
constexpr double highest_share = 0.9;   // of the peaks, of which a threshold is averaged over
// The share of the draws between the limits, of which 95 % hold the truth: found with the sets for tuning in
// tests/inference/known_sets.hpp. More than that would hold nearly always where tails are neither bounded nor heavy.
constexpr double credible = 0.92;
constexpr int kept = 300;
constexpr double most_kept = 0.4;         // declustered peaks in a separation above a threshold that is averaged over
constexpr std::size_t each_expected = 3;  // of the draws one in so many gives an expected load, which takes longest
constexpr double walk_budget = 3e5;       // peaks met in a walk's steps, beyond which it is shorter

/// The events that each peak above a threshold stands for, by its rank in its class.
MemberPeaks above(std::span<const double> peaks, const std::vector<double>& rising, double threshold, double apart) {
    MemberPeaks member;
    for (const double peak : peaks) {
        if (!(peak > threshold)) break;
        const auto higher = static_cast<double>(rising.end() - std::ranges::upper_bound(rising, peak));
        member.peaks.push_back(peak);
        member.weights.push_back(events_per_peak((higher + 0.5) * apart));
    }
    return member;
}

struct Classes {
    std::vector<double> usual;
    std::vector<double> out;
};

TailData data_above(double share, MemberPeakSpans peaks, const std::vector<std::size_t>& out, const Classes& classes,
                    const Measured& measured) {
    TailData data{.members = {}, .window = measured.window};
    data.threshold = quantile_of_sorted(classes.usual, 1 - share);
    if (!classes.out.empty()) data.out_threshold = quantile_of_sorted(classes.out, 1 - share);
    data.origin = std::min(measured.mean, highest_origin * data.threshold);
    const double usual_time = measured.window * static_cast<double>(peaks.size() - out.size());
    const double out_time = measured.window * static_cast<double>(out.size());
    for (std::size_t row = 0; row < peaks.size(); ++row) {
        const bool is_out = std::ranges::binary_search(out, row);
        MemberPeaks& member = data.members.emplace_back(
            is_out ? above(peaks[row], classes.out, data.out_threshold, measured.separation / out_time)
                   : above(peaks[row], classes.usual, data.threshold, measured.separation / usual_time));
        member.stands_out = is_out;
    }
    return data;
}

struct Weighted {
    double value;
    double weight;
};

double quantile_of(const std::vector<Weighted>& rising, double p) {
    double all = 0, sum = 0;
    for (const Weighted& one : rising) all += one.weight;
    for (const Weighted& one : rising)
        if ((sum += one.weight) >= p * all) return one.value;
    return rising.back().value;
}

LoadFigure figure_of(std::vector<Weighted> values) {
    constexpr double outside = (1 - credible) / 2;
    std::ranges::sort(values, {}, &Weighted::value);
    return {quantile_of(values, 0.5), {quantile_of(values, outside), quantile_of(values, 1 - outside)}};
}

}  // namespace

std::vector<double> averaged_shares(double share, bool quick) {
    std::vector<double> shares;
    for (const double part : quick ? std::vector{1.0} : std::vector{2.0, 1.0, 0.4})
        shares.push_back(std::min(part * share, highest_share));
    return shares;
}

PosteriorLoad::PosteriorLoad(MemberPeakSpans peaks, const std::vector<std::size_t>& out, const Measured& measured,
                             const std::vector<double>& shares)
    : window_(measured.window) {
    const Classes classes{pooled_peaks(peaks, out, false), pooled_peaks(peaks, out, true)};
    std::uint32_t number = 0;
    const double time = window_ * static_cast<double>(peaks.size() - out.size());
    for (const double share : shares) {
        const double above = share * static_cast<double>(classes.usual.size());
        // Lower down most events are hidden, and what few peaks say of them is not what their many weights say.
        const bool crowded = above * measured.separation / time > most_kept && share > shares.back();
        if (above >= fewest_peaks && !crowded) add(data_above(share, peaks, out, classes, measured), ++number);
    }
    double all = 0;
    for (const Draw& draw : draws_) all += draw.weight;
    for (Draw& draw : draws_) draw.weight /= all;
}

/// Draws of both tails above one threshold; their weights add up to one.
void PosteriorLoad::add(const TailData& data, std::uint32_t number) {
    std::size_t peaks = 0;
    for (const MemberPeaks& member : data.members) peaks += member.peaks.size() + 1;
    const int steps = static_cast<int>(std::clamp(walk_budget / static_cast<double>(peaks), 1500.0, 3000.0));
    const UnlikeTails pareto = draw_tails(TailKind::pareto, data, {steps, kept, 2 * number});
    const UnlikeTails weibull = draw_tails(TailKind::weibull, data, {steps, kept, 2 * number + 1});
    if (pareto.draws.empty() || weibull.draws.empty()) return;
    const double odds = weibull_before / (1 - weibull_before) * std::exp(weibull.log_evidence - pareto.log_evidence);
    const double weight = std::isfinite(odds) ? std::min(most_weibull, odds / (1 + odds)) : most_weibull;
    for (const UnlikeTail& tail : pareto.draws)
        draws_.push_back({tail, (1 - weight) / static_cast<double>(pareto.draws.size())});
    for (const UnlikeTail& tail : weibull.draws)
        draws_.push_back({tail, weight / static_cast<double>(weibull.draws.size())});
}

LoadFigure PosteriorLoad::quantile(double exposure, double p) const {
    std::vector<Weighted> values;
    for (const auto& [tail, weight] : draws_)
        values.push_back({largest_at(tail, window_, exposure / window_, std::log(p)), weight});
    return figure_of(std::move(values));
}

LoadFigure PosteriorLoad::expected(double exposure) const {
    std::vector<Weighted> values;
    for (std::size_t k = 0; k < draws_.size(); k += each_expected)
        values.push_back({mean_largest(draws_[k].tail, window_, exposure / window_), draws_[k].weight});
    return figure_of(std::move(values));
}

double PosteriorLoad::weibull_weight() const {
    double sum = 0;
    for (const Draw& draw : draws_)
        if (draw.tail.kind == TailKind::weibull) sum += draw.weight;
    return sum;
}

double PosteriorLoad::scatter() const {
    std::vector<Weighted> values;
    for (const Draw& draw : draws_) values.push_back({draw.tail.scatter, draw.weight});
    return figure_of(std::move(values)).value;
}

double PosteriorLoad::alike() const {
    double sum = 0;
    for (const Draw& draw : draws_)
        if (draw.tail.scatter == 0) sum += draw.weight;
    return sum;
}

namespace {

constexpr std::size_t drawn = 800;
constexpr std::size_t drawn_for_indices = 256;
constexpr double least_factor = 0.05;  // a load is above 0, however uncertain its emulator

/// One number in each of `count` equal parts of (0, 1), in random order.
std::vector<double> latin(std::size_t count, RandomStream& random) {
    std::vector<double> values(count);
    for (std::size_t k = 0; k < count; ++k)
        values[k] = (static_cast<double>(k) + random.uniform(1e-9, 1)) / static_cast<double>(count);
    for (std::size_t k = count; k > 1; --k)
        std::swap(values[k - 1], values[random.below(static_cast<std::uint32_t>(k))]);
    return values;
}

LoadFigure figure_of(std::vector<double> values) {
    // A year without such a load in some of the draws has none to quote.
    if (std::ranges::any_of(values, [](double value) { return std::isnan(value); }))
        return {undefined, {undefined, undefined}};
    std::ranges::sort(values);
    return {quantile_of_sorted(values, 0.5), {quantile_of_sorted(values, 0.025), quantile_of_sorted(values, 0.975)}};
}

}  // namespace

YearLoad::YearLoad(std::span<const PosteriorLoad* const> sources, std::vector<YearRegime> regimes)
    : sources_(sources.begin(), sources.end()), regimes_(std::move(regimes)), years_(draw(drawn, 0)) {}

std::vector<YearLoad::Year> YearLoad::draw(std::size_t count, std::uint32_t number) const {
    std::vector<Year> years(count);
    for (std::size_t source = 0; source < sources_.size(); ++source) {
        RandomStream random{36, number, StreamId::bootstrap, source};
        const std::vector<double> places = latin(count, random);
        const std::vector<double> offs = latin(count, random);
        const std::vector<PosteriorLoad::Draw>& draws = sources_[source]->draws();
        std::vector<double> sums;
        double sum = 0;
        for (const PosteriorLoad::Draw& one : draws) sums.push_back(sum += one.weight);
        for (std::size_t k = 0; k < count; ++k) {
            const auto at = std::ranges::lower_bound(sums, places[k] * sum) - sums.begin();
            const auto row = std::min(static_cast<std::size_t>(at), draws.size() - 1);
            years[k].push_back({&draws[row].tail, normal_quantile(offs[k])});
        }
    }
    return years;
}

double YearLoad::expected_above(std::size_t regime, const Year& year, double x) const {
    const YearRegime& one = regimes_[regime];
    const Choice& choice = year[one.source];
    const double factor = one.factor * std::max(least_factor, 1 + one.factor_sd * choice.off);
    const double window = sources_[one.source]->window();
    return -log_below(*choice.tail, window, one.time / window, x / factor, Scales::far);
}

double YearLoad::expected_above(const Year& year, double x) const {
    double sum = 0;
    for (std::size_t regime = 0; regime < regimes_.size(); ++regime) sum += expected_above(regime, year, x);
    return sum;
}

double YearLoad::load_of(const Year& year, double probability) const {
    const double wanted = -std::log1p(-probability);
    double low = std::numeric_limits<double>::infinity();
    for (const YearRegime& regime : regimes_) low = std::min(low, regime.factor * year[regime.source].tail->threshold);
    low *= 0.1;
    if (!(expected_above(year, low) > wanted)) return undefined;
    return halved_from(low, 20, [&](double x) { return expected_above(year, x) > wanted; });
}

std::vector<double> YearLoad::loads(double probability) const {
    std::vector<double> found;
    for (const Year& year : years_) found.push_back(load_of(year, probability));
    return found;
}

LoadFigure YearLoad::load(double probability) const {
    return figure_of(loads(probability));
}

std::vector<YearShare> YearLoad::shares(double probability) const {
    const std::vector<double> found = loads(probability);
    const double expected = -std::log1p(-probability);
    std::vector<YearShare> made;
    for (std::size_t regime = 0; regime < regimes_.size(); ++regime) {
        std::vector<double> parts;
        for (std::size_t k = 0; k < years_.size(); ++k) {
            const double all = expected_above(years_[k], found[k]);
            parts.push_back(all > 0 ? expected_above(regime, years_[k], found[k]) / all : undefined);
        }
        const double mean = std::accumulate(parts.begin(), parts.end(), 0.0) / static_cast<double>(parts.size());
        made.push_back({mean, percentile_interval(std::move(parts)), regimes_[regime].time / (mean * expected)});
    }
    return made;
}

std::vector<double> YearLoad::uncertainty(double probability) const {
    if (sources_.size() == 1) return {1.0};
    const std::vector<Year> one = draw(drawn_for_indices, 1);
    const std::vector<Year> other = draw(drawn_for_indices, 2);
    const auto log_loads = [&](const std::vector<Year>& years) {
        std::vector<double> values;
        for (const Year& year : years) values.push_back(std::log(load_of(year, probability)));
        return values;
    };
    SaltelliValues values{log_loads(one), log_loads(other), {}};
    for (std::size_t source = 0; source < sources_.size(); ++source) {
        std::vector<Year> mixed = one;
        for (std::size_t k = 0; k < mixed.size(); ++k) mixed[k][source] = other[k][source];
        values.ab.push_back(log_loads(mixed));
    }
    std::vector<double> made(sources_.size(), undefined);
    const auto is_known = [](const std::vector<double>& all) {
        return std::ranges::all_of(all, [](double value) { return std::isfinite(value); });
    };
    if (!is_known(values.a) || !is_known(values.b) || !std::ranges::all_of(values.ab, is_known)) return made;
    const SobolIndices indices = sobol_indices(values, 999);
    for (std::size_t source = 0; source < made.size(); ++source)
        made[source] = std::clamp(indices.first[source].estimate, 0.0, 1.0);
    return made;
}

std::vector<double> YearLoad::exceeded(double x) const {
    std::vector<double> found;
    for (const Year& year : years_) found.push_back(-std::expm1(-expected_above(year, x)));
    return found;
}

}  // namespace floes
