#include "inference/load_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

Exposure exposure_of(const Campaign& campaign) {
    const StopRule& stop = campaign.stop;
    Exposure exposure{.time = stop.exposure, .probabilities = {}, .quick = campaign.cases.size() > most_averaged_cases};
    exposure.expected = stop.quantile == 0;
    if (!exposure.expected) exposure.probabilities.push_back(stop.quantile);
    return exposure;
}

}  // namespace

LoadPrecision::LoadPrecision(const Campaign& campaign, std::vector<bool> watched)
    : exposure_(exposure_of(campaign)),
      averaging_(campaign.stop.averaging),
      of_expected_(campaign.stop.quantile == 0),
      half_width_(undefined) {
    for (std::size_t k = 0; k < campaign.cases.size(); ++k)
        cases_.push_back({.name = campaign.cases[k].name,
                          .analysis = campaign.cases[k].scenario.analysis,
                          .watched = watched.at(k)});
}

std::optional<MemberLoad> LoadPrecision::member_load(std::size_t case_index, const MemberOutputs& outputs) const {
    const auto averaged = std::ranges::find(outputs.averaged, averaging_, &AveragedLoad::time);
    if (averaged == outputs.averaged.end()) return {};
    return MemberLoad{{averaged->peaks, averaged->segment_maximum},
                      member_trend(outputs, cases_.at(case_index).analysis.window)};
}

void LoadPrecision::add(std::size_t case_index, MemberLoad member) {
    OneCase& one = cases_.at(case_index);
    one.rows.push_back(std::move(member.peaks));
    one.trends.push_back(member.trend);
}

void LoadPrecision::judge() {
    std::vector<std::vector<MemberTrend>> members;
    for (const OneCase& one : cases_) members.push_back(one.trends);
    const std::vector<JointTrend> trends = joint_trends(members);
    half_width_ = 0;
    obstacle_.clear();
    for (std::size_t k = 0; k < cases_.size() && std::isfinite(half_width_); ++k)
        if (cases_[k].watched) half_width_ = std::max(half_width_of(cases_[k], trends[k]), half_width_);
}

double LoadPrecision::half_width_of(const OneCase& one, const JointTrend& trend) {
    if (trend.rises()) {
        obstacle_ = fmt::format("case {}: {}, so it has no design load", one.name, trend_text(trend));
        return undefined;
    }
    const Measured measured{one.analysis.window, one.analysis.window / one.analysis.segments,
                            one.analysis.peak_separation, trend.mean};
    const DesignLoad load = load_by_both_tails(one.rows, measured, exposure_);
    if (!load.valid()) {
        obstacle_ = fmt::format("case {}: {} members with {} peaks above the threshold are too few for a tail",
                                one.name, one.rows.size(), load.peaks);
        return undefined;
    }
    const DesignLoadEstimate& made = load.estimates.front();
    const DesignLoadFigure& figure = of_expected_ ? made.expected : made.quantiles.front();
    const double longer = std::max(figure.interval.high - figure.value, figure.value - figure.interval.low);
    const double half_width = longer / std::abs(figure.value);
    if (!std::isfinite(half_width)) obstacle_ = fmt::format("case {}: its expected largest load is infinite", one.name);
    return half_width;
}

}  // namespace floes
