#include "findings/extremes.hpp"

#include <algorithm>

namespace floes {

Figure exceedance_figure(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    std::vector<double> loads;
    double least = 1;
    for (const CaseExtremes& one : extremes) {
        for (const ExceedancePoint& point : one.exceedance) {
            loads.push_back(point.load);
            least = std::min(least, point.probability);
        }
    }
    const double floor = least / 20;
    Axis x = axis_around("largest load of a segment, N", loads, true);
    x.high *= 1.4;
    Figure figure{.description = "Probability that a segment's largest load exceeds a load",
                  .x = x,
                  .y = {"probability of exceedance", floor, 1, true},
                  .size = {720, 380},
                  .legend = case_legend(summary),
                  .caption =
                      "Dots: maxima of all segments, of single steps, which are no design loads. Lines: Gumbel, "
                      "dashed: GEV, fitted by maximum likelihood."};
    for (std::size_t i = 0; i < extremes.size(); ++i) {
        const CaseExtremes& one = extremes[i];
        for (const ExceedancePoint& point : one.exceedance) figure.dot(point.load, point.probability, colour(i), 2.5);
        for (const FittedExtreme* fitted : {&one.gumbel, &one.gev}) {
            if (!fitted->fit.valid()) continue;
            Figure::Points curve;
            for (int step = 0; step <= 200; ++step) {
                const double load = x.low + (x.high - x.low) * step / 200;
                const double probability = 1 - extreme_cdf(fitted->fit, load);
                if (probability >= floor && probability < 1) curve.emplace_back(load, probability);
            }
            figure.line(std::move(curve), colour(i) + (fitted == &one.gumbel ? "" : " dashed"));
        }
    }
    return figure;
}

}  // namespace floes
