#include <fmt/format.h>

#include <algorithm>

#include "core/units.hpp"
#include "match/predict.hpp"
#include "match/predict_design_load.hpp"
#include "tables/number_text.hpp"

namespace floes {
Section design_section(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    double largest = 0;
    for (const PredictedDesignLoad& one : designs) largest = std::max(largest, one.quantile.high);
    const LoadUnit unit = load_unit(largest);
    const std::string exceeded = fmt::format("exceeded with {:.3g} %", (1 - request.quantiles.front()) / unit::percent);
    Section section{.before = fmt::format("Design load over what is not ruled out: the largest load averaged over {:g} "
                                          "s in {:g} h\n\n",
                                          request.averaging, request.exposure / unit::hour)};
    section.table = {{"case", fmt::format("expected, {}", unit.name), "weighed",
                      fmt::format("{}, {}", exceeded, unit.name), "weighed", "growth", "lower half", "upper half",
                      "runs"}};
    bool all_points = false;
    for (const PredictedDesignLoad& one : designs) {
        const auto cell = [&](const PredictedRange& range) { return range_cell(range, unit.factor); };
        section.table.push_back({one.case_name.empty() ? "all" : one.case_name, cell(one.expected),
                                 cell(one.expected_weighed), cell(one.quantile), cell(one.quantile_weighed),
                                 Cell{fixed(one.growth_quantile.value, 2),
                                      bracket(one.growth_quantile.interval.low, one.growth_quantile.interval.high, 2)},
                                 fixed(one.growth_lower_half, 2), fixed(one.growth_upper_half, 2),
                                 fmt::format("{}{}", one.runs, one.only_left ? "" : " *")});
        all_points = all_points || !one.only_left;
    }
    section.after = fmt::format(
        "\nIn brackets 95 %, of the inputs, the emulator and the tail together; weighed: by the likelihood of the "
        "targets.\n"
        "The emulated mean of the segment maxima times a growth: that to the load {}, from both tails of all runs\n"
        "at inputs that are left, each divided by its mean maximum. The halves have the runs with the smaller and the\n"
        "larger mean maxima; where they differ by more than the interval, the growth depends on the inputs.\n{}",
        exceeded,
        all_points ? fmt::format("* Fewer than {} runs are at inputs that are left, so the runs at all points count.\n",
                                 fewest_growth_runs)
                   : "");
    const auto of = [](auto outer, auto inner) {
        return [outer, inner](const PredictedDesignLoad& one) { return static_cast<double>((one.*outer).*inner); };
    };
    const auto limit = [](DesignLoadFigure PredictedDesignLoad::*figure, double Limits::*side) {
        return [figure, side](const PredictedDesignLoad& one) { return (one.*figure).interval.*side; };
    };
    section.records = {make_rows<PredictedDesignLoad>(
        "match/design_load", designs,
        {{"case", &PredictedDesignLoad::case_name},
         {"exposure_s", [&](const PredictedDesignLoad&) { return request.exposure; }},
         {"averaging_s", [&](const PredictedDesignLoad&) { return request.averaging; }},
         {"scale", [&](const PredictedDesignLoad&) { return request.scale; }},
         {"quantile", [&](const PredictedDesignLoad&) { return request.quantiles.front(); }},
         {"expected_N", of(&PredictedDesignLoad::expected, &PredictedRange::mean)},
         {"expected_low_N", of(&PredictedDesignLoad::expected, &PredictedRange::low)},
         {"expected_high_N", of(&PredictedDesignLoad::expected, &PredictedRange::high)},
         {"expected_weighted_N", of(&PredictedDesignLoad::expected_weighed, &PredictedRange::mean)},
         {"expected_weighted_low_N", of(&PredictedDesignLoad::expected_weighed, &PredictedRange::low)},
         {"expected_weighted_high_N", of(&PredictedDesignLoad::expected_weighed, &PredictedRange::high)},
         {"quantile_N", of(&PredictedDesignLoad::quantile, &PredictedRange::mean)},
         {"quantile_low_N", of(&PredictedDesignLoad::quantile, &PredictedRange::low)},
         {"quantile_high_N", of(&PredictedDesignLoad::quantile, &PredictedRange::high)},
         {"quantile_weighted_N", of(&PredictedDesignLoad::quantile_weighed, &PredictedRange::mean)},
         {"quantile_weighted_low_N", of(&PredictedDesignLoad::quantile_weighed, &PredictedRange::low)},
         {"quantile_weighted_high_N", of(&PredictedDesignLoad::quantile_weighed, &PredictedRange::high)},
         {"growth_expected", of(&PredictedDesignLoad::growth_expected, &DesignLoadFigure::value)},
         {"growth_quantile", of(&PredictedDesignLoad::growth_quantile, &DesignLoadFigure::value)},
         {"growth_quantile_low", limit(&PredictedDesignLoad::growth_quantile, &Limits::low)},
         {"growth_quantile_high", limit(&PredictedDesignLoad::growth_quantile, &Limits::high)},
         {"growth_lower_half", &PredictedDesignLoad::growth_lower_half},
         {"growth_upper_half", &PredictedDesignLoad::growth_upper_half},
         {"runs", [](const PredictedDesignLoad& one) { return static_cast<std::int64_t>(one.runs); }},
         {"only_left", &PredictedDesignLoad::only_left}})};
    return section;
}

}  // namespace floes
