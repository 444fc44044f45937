#include "year/year_records.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/units.hpp"

namespace floes {

std::vector<DataRows> year_records(const Year& year, const YearRequest& request) {
    const double factor = request.load.force_factor();
    const double hours = std::sqrt(request.load.scale) / unit::hour;
    const auto loads =
        make_rows<YearLevel>("year/loads", year.levels,
                             {{"exceeded_a_year", [](const YearLevel& one) { return one.per_year; }},
                              {"averaging_s", [&](const YearLevel&) { return request.load.averaging; }},
                              {"scale", [&](const YearLevel&) { return request.load.scale; }},
                              {"load_N", [=](const YearLevel& one) { return factor * one.load.value; }},
                              {"low", [=](const YearLevel& one) { return factor * one.load.interval.low; }},
                              {"high", [=](const YearLevel& one) { return factor * one.load.interval.high; }},
                              {"hours_for_one_over_hours_run", [](const YearLevel& one) { return one.beyond_run; }}});
    struct Part {
        const YearLevel* level;
        std::size_t row;
    };
    std::vector<Part> parts, sources;
    for (const YearLevel& level : year.levels) {
        for (std::size_t k = 0; k < level.shares.size(); ++k) parts.push_back({&level, k});
        for (std::size_t k = 0; k < level.uncertainty.size(); ++k) sources.push_back({&level, k});
    }
    const auto row_of = [&](const Part& part) -> const YearRegimeRow& { return year.regimes[part.row]; };
    const auto share_of = [](const Part& part) -> const YearShare& { return part.level->shares[part.row]; };
    const auto regimes = make_rows<Part>(
        "year/regimes", parts,
        {{"regime", [=](const Part& part) { return row_of(part).regime.name; }},
         {"hours_a_year", [=](const Part& part) { return row_of(part).regime.time / unit::hour; }},
         {"source", [&, row_of](const Part& part) { return year.sources[row_of(part).tail.source].words(); }},
         {"factor", [=](const Part& part) { return row_of(part).tail.factor; }},
         {"factor_sd", [=](const Part& part) { return row_of(part).tail.factor_sd; }},
         {"exceeded_a_year", [](const Part& part) { return part.level->per_year; }},
         {"share", [=](const Part& part) { return share_of(part).value; }},
         {"share_low", [=](const Part& part) { return share_of(part).interval.low; }},
         {"share_high", [=](const Part& part) { return share_of(part).interval.high; }},
         {"hours_for_one", [=](const Part& part) { return hours * share_of(part).exceeded_once_in; }}});
    const auto source_of = [&](const Part& part) -> const TailSource& { return year.sources[part.row]; };
    const auto basis =
        make_rows<Part>("year/sources", sources,
                        {{"source", [=](const Part& part) { return source_of(part).words(); }},
                         {"members", [=](const Part& part) { return source_of(part).members.size(); }},
                         {"hours_run", [=](const Part& part) { return hours * source_of(part).time_run; }},
                         {"stand_out", [=](const Part& part) { return source_of(part).unlike.out.size(); }},
                         {"exceeded_a_year", [](const Part& part) { return part.level->per_year; }},
                         {"share_of_uncertainty", [](const Part& part) { return part.level->uncertainty[part.row]; }}});
    const auto curve = make_rows<YearCurvePoint>(
        "year/curve", year.curve,
        {{"exceeded_a_year", [](const YearCurvePoint& one) { return one.per_year; }},
         {"load_N", [=](const YearCurvePoint& one) { return factor * one.all.value; }},
         {"low", [=](const YearCurvePoint& one) { return factor * one.all.interval.low; }},
         {"high", [=](const YearCurvePoint& one) { return factor * one.all.interval.high; }}});
    return {loads, regimes, basis, curve};
}

}  // namespace floes
