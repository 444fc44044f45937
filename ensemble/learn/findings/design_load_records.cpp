#include "findings/design_load_records.hpp"

#include <fmt/format.h>

#include <cmath>

namespace floes {

DataRows load_records(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                      const DesignLoadRequest& request) {
    struct Line {
        const CaseDesignLoad* of;
        const DesignLoadEstimate* made;
        const DesignLoadFigure* figure;
        double probability;  ///< NaN for the expected load
    };
    std::vector<Line> lines;
    for (const CaseDesignLoad& one : designs)
        for (const DesignLoadEstimate& made : one.load.estimates) {
            lines.push_back({&one, &made, &made.expected, std::nan("")});
            for (std::size_t k = 0; k < made.quantiles.size(); ++k)
                lines.push_back({&one, &made, &made.quantiles[k], request.quantiles[k]});
        }
    const double factor = request.force_factor();
    return make_rows<Line>(
        "design/loads", lines,
        {{"case", [&](const Line& line) { return summary.name_of(line.of->case_index); }},
         {"method", [](const Line& line) { return name_of(line.made->method); }},
         {"averaging_s",
          [&](const Line&) {
              return request.force == DesignLoadRequest::Force::load ? Datum(request.averaging) : Undefined{};
          }},
         {"exposure_h", [&](const Line&) { return request.exposure / unit::hour; }},
         {"scale", [&](const Line&) { return request.scale; }},
         {"figure", [](const Line& line) { return std::isnan(line.probability) ? "expected" : "quantile"; }},
         {"probability", [](const Line& line) { return line.probability; }},
         {"load_N", [=](const Line& line) { return factor * line.figure->value; }},
         {"low", [=](const Line& line) { return factor * line.figure->interval.low; }},
         {"high", [=](const Line& line) { return factor * line.figure->interval.high; }}});
}

DataRows basis_records(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                       const DesignLoadRequest& request) {
    // What was not looked at, or could not be fitted, is not 0.
    const auto seen = [](auto value) {
        return [value](const CaseDesignLoad& one) { return one.refused ? Undefined{} : Datum(value(one.load)); };
    };
    const auto found = [](auto value) {
        return [value](const CaseDesignLoad& one) { return one.load.valid() ? Datum(value(one.load)) : Undefined{}; };
    };
    const auto change = [](auto value) {
        return [value](const CaseDesignLoad& one) {
            const double told = value(one.trend.load);
            return std::isfinite(told) ? Datum(told) : Datum(Undefined{});
        };
    };
    using Load = const DesignLoad&;
    std::vector<DataColumn<CaseDesignLoad>> columns{
        {"case", [&](const CaseDesignLoad& one) { return summary.name_of(one.case_index); }},
        {"arrangements", [](const CaseDesignLoad& one) { return one.load.arrangements; }},
        {"refused_as_rising", [](const CaseDesignLoad& one) { return one.refused; }},
        {"trend_seen", [](const CaseDesignLoad& one) { return one.trend.seen; }},
        {"trend_p", change([](const Change& one) { return one.p; })},
        {"change_over_window_N", change([](const Change& one) { return one.over_window.estimate; })},
        {"change_low_N", change([](const Change& one) { return one.over_window.low; })},
        {"change_high_N", change([](const Change& one) { return one.over_window.high; })},
        {"time_run_s", seen([](Load load) { return load.time_run; })},
        {"exposure_s", [&](const CaseDesignLoad&) { return request.model_exposure(); }},
        {"peak_separation_s", [](const CaseDesignLoad& one) { return one.separation; }},
        {"peaks", seen([](Load load) { return load.peaks; })},
        {"threshold_N", seen([](Load load) { return load.threshold; })},
        {"pareto/scale_N", found([](Load load) { return load.pareto.scale; })},
        {"pareto/shape", found([](Load load) { return load.pareto.shape; })},
        {"weibull/origin_N", found([](Load load) { return load.weibull.origin; })},
        {"weibull/scale_N", found([](Load load) { return load.weibull.scale; })},
        {"weibull/shape", found([](Load load) { return load.weibull.shape; })},
        {"weibull/weight", found([](Load load) { return load.weibull_weight; })},
        {"stand_out", seen([](Load load) { return load.unlike.out.size(); })},
        {"peaks_carried", seen([](Load load) { return load.unlike.carried; })},
        {"unseen_share", [](const CaseDesignLoad& one) { return unseen_share(one.load.arrangements); }},
        {"scatter", found([](Load load) { return load.scatter; })},
        {"alike_probability", found([](Load load) { return load.alike; })},
        {"dispersion", seen([](Load load) { return load.unlike.dispersion; })},
        {"dispersion_p", seen([](Load load) { return load.unlike.dispersion_p; })},
        {"resamples", found([](Load load) { return load.draws.size(); })},
        {"resamples_without_fit", found([](Load load) { return load.dropped; })}};
    for (std::size_t k = 0; k < std::size(threshold_shares); ++k) {
        columns.push_back({fmt::format("over_thresholds/{}/share", k),
                           [k](const CaseDesignLoad&) { return Datum(threshold_shares[k]); }});
        columns.push_back({fmt::format("over_thresholds/{}/load_N", k),
                           [k](const CaseDesignLoad& one) { return Datum(one.over_shares[k]); }});
    }
    return json_only(make_rows<CaseDesignLoad>("design/basis", designs, columns));
}

DataRows rate_records(const Summary& summary, const std::vector<CaseDesignLoad>& designs) {
    struct Point {
        const CaseDesignLoad* of;
        double load;
        double seen;  ///< per s
    };
    std::vector<Point> points;
    for (const CaseDesignLoad& one : designs)
        for (std::size_t k = 0; k < one.peaks.size(); ++k)
            points.push_back({&one, one.peaks[k], static_cast<double>(k + 1) / one.load.time_run});
    const auto tail = [](const Tail& fitted, double load) {
        return fitted.valid() && load >= fitted.threshold ? Datum(rate_above(fitted, load)) : Datum(Undefined{});
    };
    return json_only(make_rows<Point>(
        "design/rates", points,
        {{"case", [&](const Point& point) { return summary.name_of(point.of->case_index); }},
         {"load_N", [](const Point& point) { return point.load; }},
         {"seen_per_s", [](const Point& point) { return point.seen; }},
         {"pareto_per_s", [=](const Point& point) { return tail(point.of->load.pareto, point.load); }},
         {"weibull_per_s", [=](const Point& point) { return tail(point.of->load.weibull, point.load); }}}));
}

}  // namespace floes
