#include "inference/posterior_load.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "inference/tails.hpp"

namespace floes {
namespace {

constexpr double weibull_before = 1.0 / 3;
constexpr double most_weibull = 7.0 / 9;
constexpr double highest_origin = 0.9;  // of the threshold
constexpr double highest_share = 0.9;   // of the peaks, of which a threshold is averaged over
constexpr int kept = 300;
constexpr double most_kept = 0.4;         // declustered peaks in a separation above a threshold that is averaged over
constexpr std::size_t each_expected = 3;  // of the draws one in so many gives an expected load, which takes longest
constexpr double walk_budget = 3e5;       // peaks met in a walk's steps, beyond which it is shorter

/// All peaks of a class, rising.
std::vector<double> pooled(MemberPeakSpans peaks, const std::vector<std::size_t>& out, bool of_out) {
    std::vector<double> all;
    for (std::size_t row = 0; row < peaks.size(); ++row)
        if (std::ranges::binary_search(out, row) == of_out) all.insert(all.end(), peaks[row].begin(), peaks[row].end());
    std::ranges::sort(all);
    return all;
}

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
                    const PosteriorAsked& asked) {
    TailData data{.members = {}, .window = asked.window};
    data.threshold = quantile_of_sorted(classes.usual, 1 - share);
    if (!classes.out.empty()) data.out_threshold = quantile_of_sorted(classes.out, 1 - share);
    data.origin = std::min(asked.mean, highest_origin * data.threshold);
    const double usual_time = asked.window * static_cast<double>(peaks.size() - out.size());
    const double out_time = asked.window * static_cast<double>(out.size());
    for (std::size_t row = 0; row < peaks.size(); ++row) {
        const bool is_out = std::ranges::binary_search(out, row);
        MemberPeaks& member = data.members.emplace_back(
            is_out ? above(peaks[row], classes.out, data.out_threshold, asked.separation / out_time)
                   : above(peaks[row], classes.usual, data.threshold, asked.separation / usual_time));
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

PosteriorFigure figure_of(std::vector<Weighted> values) {
    std::ranges::sort(values, {}, &Weighted::value);
    return {quantile_of(values, 0.5), {quantile_of(values, 0.025), quantile_of(values, 0.975)}};
}

}  // namespace

std::vector<double> averaged_shares(double share, bool quick) {
    std::vector<double> shares;
    for (const double part : quick ? std::vector{1.0} : std::vector{2.0, 1.0, 0.4})
        shares.push_back(std::min(part * share, highest_share));
    return shares;
}

PosteriorLoad::PosteriorLoad(MemberPeakSpans peaks, const std::vector<std::size_t>& out, const PosteriorAsked& asked)
    : window_(asked.window) {
    const Classes classes{pooled(peaks, out, false), pooled(peaks, out, true)};
    std::uint32_t number = 0;
    const double time = window_ * static_cast<double>(peaks.size() - out.size());
    for (const double share : asked.shares) {
        const double above = share * static_cast<double>(classes.usual.size());
        // Lower down most events are hidden, and what few peaks say of them is not what their many weights say.
        const bool crowded = above * asked.separation / time > most_kept && share > asked.shares.back();
        if (above >= fewest_peaks && !crowded) add(data_above(share, peaks, out, classes, asked), ++number);
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

PosteriorFigure PosteriorLoad::quantile(double exposure, double p) const {
    std::vector<Weighted> values;
    for (const auto& [tail, weight] : draws_)
        values.push_back({largest_at(tail, window_, exposure / window_, std::log(p)), weight});
    return figure_of(std::move(values));
}

PosteriorFigure PosteriorLoad::expected(double exposure) const {
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

}  // namespace floes
