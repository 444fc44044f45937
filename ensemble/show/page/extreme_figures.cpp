// Figures of large loads: maxima of segments with their fits, and the time above load levels.

#include <algorithm>
#include <vector>

#include "page/case_colours.hpp"
#include "page/plot.hpp"
#include "page/report_figures.hpp"

namespace floes {

std::string exceedance_figure(const ReportData& data) {
    std::vector<double> loads;
    double least = 1;
    for (const CaseExtremes& one : *data.extremes) {
        for (const ExceedancePoint& point : one.exceedance) {
            loads.push_back(point.load);
            least = std::min(least, point.probability);
        }
    }
    const double floor = least / 20;
    Axis x = axis_around("largest load of a segment, N", loads, true);
    x.high *= 1.4;
    Plot plot("Probability that a segment's largest load exceeds a load", x,
              {"probability of exceedance", floor, 1, true}, {720, 380});
    for (std::size_t i = 0; i < data.extremes->size(); ++i) {
        const CaseExtremes& one = (*data.extremes)[i];
        for (const ExceedancePoint& point : one.exceedance) plot.dot(point.load, point.probability, colour(i), 2.5);
        for (const FittedExtreme* fitted : {&one.gumbel, &one.gev}) {
            if (!fitted->fit.valid()) continue;
            Plot::Points curve;
            for (int step = 0; step <= 200; ++step) {
                const double load = x.low + (x.high - x.low) * step / 200;
                const double probability = 1 - extreme_cdf(fitted->fit, load);
                if (probability >= floor && probability < 1) curve.emplace_back(load, probability);
            }
            plot.line(curve, colour(i) + (fitted == &one.gumbel ? "" : " dashed"));
        }
    }
    plot.legend(case_legend(data));
    return plot.svg();
}

std::string levels_figure(const ReportData& data) {
    const std::vector<LevelRow>& rows = data.levels;
    std::vector<double> loads;
    double least = 1;
    for (const LevelRow& row : rows) {
        loads.push_back(row.level);
        if (row.time_above.estimate > 0) least = std::min(least, row.time_above.estimate);
    }
    if (least == 1) return "";
    const double floor = least / 3;
    Axis x = axis_around("surge load, N", loads, true);
    Plot plot("Share of the time with a surge load above a level", x, {"share of the time", floor, 1, true},
              {720, 340});
    const std::size_t cases = data.summary.cases.size();
    for (std::size_t i = 0; i < cases; ++i) {
        // A small offset puts the intervals of one level side by side.
        const double aside = 0.006 * (x.high - x.low) * (static_cast<double>(i) - 0.5 * static_cast<double>(cases - 1));
        Plot::Points curve;
        for (const LevelRow& row : rows) {
            if (row.case_index != i || !(row.time_above.estimate > 0)) continue;
            const double at = row.level + aside;
            curve.emplace_back(at, row.time_above.estimate);
            plot.line({{at, std::max(floor, row.time_above.low)}, {at, row.time_above.high}}, colour(i) + " thin");
            plot.dot(at, row.time_above.estimate, colour(i), 3);
        }
        plot.line(curve, colour(i));
    }
    plot.legend(case_legend(data));
    return plot.svg();
}

}  // namespace floes
