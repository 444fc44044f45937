#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tables/number_text.hpp"
#include "year/year_section.hpp"

namespace floes {

Figure year_figure(const Year& year, const YearRequest& request) {
    constexpr std::size_t most_told_apart = 6;
    double largest = 0;
    for (const YearCurvePoint& point : year.curve)
        if (point.all.value > largest) largest = point.all.value;
    const LoadUnit unit = load_unit(largest * request.load.force_factor());
    const double factor = unit.factor * request.load.force_factor();
    std::vector<double> values;
    Figure::Points low, high, middle;
    for (const YearCurvePoint& point : year.curve) {
        if (!std::isfinite(point.all.value)) continue;
        low.emplace_back(factor * point.all.interval.low, point.per_year);
        high.emplace_back(factor * point.all.interval.high, point.per_year);
        middle.emplace_back(factor * point.all.value, point.per_year);
        values.push_back(middle.back().first);
        values.push_back(std::min(high.back().first, 3 * middle.back().first));
    }
    const double rarest = year.curve.back().per_year;
    Figure figure{.description = "Probability that the largest load of a year exceeds a load",
                  .x = axis_around(fmt::format("largest load of a year, averaged over {:g} s, {}",
                                               request.load.averaging, unit.name),
                                   values, true),
                  .y = {"probability of exceedance in a year", rarest * 0.7, 1, true},
                  .size = {720, 380}};
    // The band lies between curves along the loads, so it is an outline, cut off where the axis ends.
    Figure::Points outline = low;
    outline.insert(outline.end(), high.rbegin(), high.rend());
    for (auto& [load, probability] : outline) load = std::clamp(load, figure.x.low, figure.x.high);
    figure.area(std::move(outline), "ink veil");
    const bool colours = year.regimes.size() <= most_told_apart;
    for (std::size_t regime = 0; regime < year.regimes.size(); ++regime) {
        Figure::Points line;
        for (const YearCurvePoint& point : year.curve)
            if (std::isfinite(point.alone[regime]) && factor * point.alone[regime] <= figure.x.high)
                line.emplace_back(factor * point.alone[regime], point.per_year);
        figure.line(std::move(line), colours ? colour(regime) : "thin");
        if (colours) figure.legend.emplace_back(colour(regime), year.regimes[regime].regime.name);
    }
    figure.line(std::move(middle), "thick");
    figure.legend.emplace_back("ink", "all regimes");
    for (const YearLevel& level : year.levels) figure.level(level.per_year, "dashed");
    figure.caption = fmt::format(
        "Probability that the largest load of a year exceeds a load: of all regimes (thick, with its 95 % interval), "
        "and "
        "of each as if there were no other{}. Dashed: the probabilities asked for.",
        colours ? "" : " (thin)");
    return figure;
}

}  // namespace floes
