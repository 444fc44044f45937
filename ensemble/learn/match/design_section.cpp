#include <fmt/format.h>

#include <algorithm>

#include "core/units.hpp"
#include "match/predict.hpp"
#include "match/predict_design_load.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

std::string exceeded_words(const DesignLoadRequest& request) {
    return fmt::format("exceeded with {:.3g} %", (1 - request.quantiles.front()) / unit::percent);
}

Table table_of(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    double largest = 0;
    for (const PredictedDesignLoad& one : designs) largest = std::max(largest, one.quantile.high);
    const LoadUnit unit = load_unit(largest);
    const auto cell = [&](const PredictedRange& range) { return range_cell(range, unit.factor); };
    Table table{{"case", fmt::format("expected, {}", unit.name), "weighed",
                 fmt::format("{}, {}", exceeded_words(request), unit.name), "weighed", "growth", "lower half",
                 "upper half", "runs"}};
    for (const PredictedDesignLoad& one : designs)
        table.push_back({one.case_name.empty() ? "all" : one.case_name, cell(one.expected), cell(one.expected_weighed),
                         cell(one.quantile), cell(one.quantile_weighed),
                         Cell{fixed(one.growth_quantile.value, 2),
                              bracket(one.growth_quantile.interval.low, one.growth_quantile.interval.high, 2)},
                         fixed(one.growth_lower_half, 2), fixed(one.growth_upper_half, 2),
                         fmt::format("{}{}", one.runs, one.only_left ? "" : " *")});
    return table;
}

DataRows records_of(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    using Row = const PredictedDesignLoad&;
    std::vector<DataColumn<PredictedDesignLoad>> columns{{"case", &PredictedDesignLoad::case_name},
                                                         {"exposure_s", [&](Row) { return request.exposure; }},
                                                         {"averaging_s", [&](Row) { return request.averaging; }},
                                                         {"scale", [&](Row) { return request.scale; }},
                                                         {"quantile", [&](Row) { return request.quantiles.front(); }}};
    const auto add_range = [&](const std::string& name, PredictedRange PredictedDesignLoad::*range) {
        columns.push_back({name + "_N", [=](Row row) { return Datum((row.*range).mean); }});
        columns.push_back({name + "_low_N", [=](Row row) { return Datum((row.*range).low); }});
        columns.push_back({name + "_high_N", [=](Row row) { return Datum((row.*range).high); }});
    };
    add_range("expected", &PredictedDesignLoad::expected);
    add_range("expected_weighted", &PredictedDesignLoad::expected_weighed);
    add_range("quantile", &PredictedDesignLoad::quantile);
    add_range("quantile_weighted", &PredictedDesignLoad::quantile_weighed);
    columns.push_back({"growth_expected", [](Row row) { return row.growth_expected.value; }});
    columns.push_back({"growth_quantile", [](Row row) { return row.growth_quantile.value; }});
    columns.push_back({"growth_quantile_low", [](Row row) { return row.growth_quantile.interval.low; }});
    columns.push_back({"growth_quantile_high", [](Row row) { return row.growth_quantile.interval.high; }});
    columns.push_back({"growth_lower_half", &PredictedDesignLoad::growth_lower_half});
    columns.push_back({"growth_upper_half", &PredictedDesignLoad::growth_upper_half});
    columns.push_back({"runs", &PredictedDesignLoad::runs});
    columns.push_back({"only_left", &PredictedDesignLoad::only_left});
    return make_rows<PredictedDesignLoad>("match/design_load", designs, columns);
}

}  // namespace

Section design_section(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    const bool all_left = std::ranges::all_of(designs, &PredictedDesignLoad::only_left);
    return {
        .title = fmt::format("Design load over what is not ruled out: the largest load averaged over {:g} s in {:g} h",
                             request.averaging, request.exposure / unit::hour),
        .table = table_of(designs, request),
        .after = fmt::format(
            "\nIn brackets 95 %, of the inputs, the emulator and the tail together; weighed: by the likelihood of the "
            "targets.\n"
            "The emulated mean of the segment maxima times a growth: that to the load {}, from both tails of all runs "
            "at inputs that are left, each divided by its mean maximum. The halves have the runs with the smaller and "
            "the "
            "larger mean maxima; where they differ by more than the interval, the growth depends on the inputs.\n{}",
            exceeded_words(request),
            all_left
                ? ""
                : fmt::format("* Fewer than {} runs are at inputs that are left, so the runs at all points count.\n",
                              fewest_growth_runs)),
        .records = {records_of(designs, request)}};
}

}  // namespace floes
