#include "inference/joint_trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "inference/paired.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {
namespace {

constexpr double trend_level = 0.01;
constexpr std::size_t fewest_for_trend = 3;

}  // namespace

MemberTrend member_trend(const MemberOutputs& outputs, double window) {
    const std::vector<double>& maxima =
        outputs.averaged.empty() ? outputs.load.segment_maximum : outputs.averaged.front().segment_maximum;
    return {.mean = outputs.load.mean,
            .rise = outputs.load.trend * window,
            .growth = maxima.size() < 2 ? std::nan("") : maxima.back() - maxima.front(),
            .largest = maxima.empty() ? 0 : mean_of(maxima)};
}

Change change_of(const std::vector<double>& values) {
    if (values.size() < fewest_for_trend || std::ranges::min(values) == std::ranges::max(values))
        return {mean_interval(values), std::nan("")};
    const std::vector<double> none(values.size());
    return {mean_interval(values), compare_paired(none, values).t_p};
}

bool matters(const Change& change, double figure) {
    return std::max(std::abs(change.over_window.low), std::abs(change.over_window.high)) >=
           negligible_change * std::abs(figure);
}

std::vector<JointTrend> joint_trends(const std::vector<std::vector<MemberTrend>>& cases) {
    std::vector<JointTrend> trends;
    std::vector<double> p;
    for (const std::vector<MemberTrend>& members : cases) {
        JointTrend& one = trends.emplace_back();
        one.case_index = trends.size() - 1;
        one.members = static_cast<int>(members.size());
        std::vector<double> rises, growths;
        for (const MemberTrend& member : members) {
            one.mean += member.mean;
            one.largest += member.largest;
            rises.push_back(member.rise);
            growths.push_back(member.growth);
        }
        one.mean /= std::max(1, one.members);
        one.largest /= std::max(1, one.members);
        for (std::vector<double>* values : {&rises, &growths})
            std::erase_if(*values, [](double value) { return !std::isfinite(value); });
        one.load = change_of(rises);
        one.maxima = change_of(growths);
        p.insert(p.end(), {one.load.p, one.maxima.p});
    }
    const std::vector<double> adjusted = holm(p);
    for (std::size_t k = 0; k < trends.size(); ++k) {
        JointTrend& one = trends[k];
        const bool load = adjusted[2 * k] < trend_level;
        const bool maxima = adjusted[2 * k + 1] < trend_level;
        const bool load_matters = load && matters(one.load, one.mean);
        const bool maxima_matter = maxima && matters(one.maxima, one.largest);
        one.significant = load || maxima;
        one.seen = load_matters || maxima_matter;
        one.by_load =
            load_matters != maxima_matter ? load_matters : !std::isfinite(one.maxima.p) || one.load.p <= one.maxima.p;
    }
    return trends;
}

std::string trend_text(const JointTrend& trend) {
    const bool of_load = trend.by_load;
    const double change = (of_load ? trend.load : trend.maxima).over_window.estimate;
    const std::string by = of_load ? fmt::format("{:.3g} N of {:.3g} N", std::abs(change), trend.mean)
                                   : fmt::format("{:.3g} N", std::abs(change));
    return fmt::format("{} {} by {} over the measured window ({} members, p = {:.1g})",
                       of_load ? "the load" : "the largest load of a segment", change > 0 ? "rises" : "falls", by,
                       trend.members, of_load ? trend.load.p : trend.maxima.p);
}

}  // namespace floes
