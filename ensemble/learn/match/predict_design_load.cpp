#include "match/predict_design_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "match/divided_runs.hpp"
#include "match/predict.hpp"

namespace floes {
namespace {

/// For each point, whether no target rules it out.
std::vector<bool> points_left(const MatchData& data, const std::vector<EmulatedTarget>& targets) {
    std::vector<bool> left;
    for (const MatchPoint& point : data.points)
        left.push_back(std::ranges::none_of(
            targets, [x = coordinates_of(point)](const EmulatedTarget& target) { return target.rules_out(x); }));
    return left;
}

/// Growth of the quantile, of runs in order of their mean maxima.
double growth_of(std::span<const DividedRun> runs, Measured measured, const Exposure& exposure) {
    const DividedRows divided = rows_of(runs);
    measured.mean = divided.mean;
    return over_thresholds(divided.rows, measured, exposure, {exposure.share}).front().front();
}

/// The growth, with its own uncertainty, times the mean maximum at each point.
AtPoints grown(const AtPoints& mean_maximum, const DesignLoadFigure& growth, double factor) {
    constexpr double half_width = 1.96;
    const double sd = (growth.interval.high - growth.interval.low) / (2 * half_width);
    AtPoints made;
    for (std::size_t k = 0; k < mean_maximum.mean.size(); ++k) {
        const double mean = mean_maximum.mean[k];
        const double variance = growth.value * growth.value * mean_maximum.variance[k] + mean * mean * sd * sd;
        made.mean.push_back(factor * growth.value * mean);
        made.variance.push_back(factor * factor * variance);
    }
    return made;
}

PredictedDesignLoad of_case(CaseRuns all, const AtPoints& mean_maximum, const OverLeft& left,
                            const std::string& case_name, const DesignLoadRequest& request) {
    PredictedDesignLoad made;
    made.case_name = case_name;
    const auto at_left = static_cast<std::size_t>(std::ranges::count(all.runs, true, &DividedRun::left));
    made.only_left = at_left >= fewest_growth_runs;
    if (made.only_left) std::erase_if(all.runs, [](const DividedRun& run) { return !run.left; });
    std::ranges::stable_sort(all.runs, {}, &DividedRun::mean_maximum);
    made.runs = all.runs.size();
    const DividedRows divided = rows_of(all.runs);
    all.measured.mean = divided.mean;
    const Exposure exposure{request.model_exposure(), {request.quantiles.front()}, request.share};
    const DesignLoad load = design_load(divided.rows, all.measured, exposure);
    if (!load.valid())
        throw InputError(fmt::format("{}{}too few peaks ({} of {}) for a design load; run more points or arrangements.",
                                     case_name, case_name.empty() ? "" : ": ", load.peaks, fewest_peaks));
    made.growth_expected = load.estimates.front().expected;
    made.growth_quantile = load.estimates.front().quantiles.front();
    const std::span<const DividedRun> runs = all.runs;
    made.growth_lower_half = growth_of(runs.first(runs.size() / 2), all.measured, exposure);
    made.growth_upper_half = growth_of(runs.subspan(runs.size() / 2), all.measured, exposure);
    const AtPoints expected = grown(mean_maximum, made.growth_expected, request.force_factor());
    const AtPoints quantile = grown(mean_maximum, made.growth_quantile, request.force_factor());
    made.expected = left.even(expected);
    made.expected_weighed = left.weighed(expected);
    made.quantile = left.even(quantile);
    made.quantile_weighed = left.weighed(quantile);
    return made;
}

}  // namespace

std::vector<PredictedDesignLoad> predict_design_load(std::span<const MatchWave> waves, const MatchData& data,
                                                     const std::vector<EmulatedTarget>& targets, const OverLeft& left,
                                                     const DesignLoadRequest& request) {
    const double time = averaging_time(waves.front().table, request);
    std::vector<Target> indices;
    for (const std::string& name : match_cases(waves))
        indices.push_back(to_predict(fmt::format("mean_maximum_{:g}s", time), name));
    const std::vector<bool> at_left = points_left(data, targets);
    std::vector<PredictedDesignLoad> designs;
    for (const EmulatedTarget& index : emulate(match_data(waves, indices))) {
        if (!index.emulated()) continue;
        const std::string& name = index.target().case_name;
        const AtPoints mean_maximum = left.emulated(index);
        designs.push_back(of_case(runs_of(waves, data, at_left, index, request), mean_maximum, left, name, request));
    }
    return designs;
}

}  // namespace floes
