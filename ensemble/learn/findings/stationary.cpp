#include "findings/stationary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace floes {

std::string stationary_text(const std::string& name, const JointTrend& trend, const CaseRow& about) {
    if (trend.significant || !std::isfinite(trend.load.p)) return "";
    const Interval& change = trend.load.over_window;
    const double open = std::max(std::abs(change.low), std::abs(change.high)) / std::abs(trend.mean);
    const bool known = open <= much_left_open;
    const bool endless = about.far_end == FarEnd::never;
    const std::string verdict =
        known ? endless ? "stationary, and ice comes as long as the run lasts" : "no trend within this window"
              : "not shown to be stationary: few members, or a short window";
    const std::string beyond = endless ? ""
                               : about.far_end == FarEnd::ice_sheet
                                   ? " The field ends at an ice sheet, so a longer exposure is taken as one such "
                                     "passage after another."
                                   : " The field ends in open water, so a longer exposure is taken as one such passage "
                                     "after another.";
    return fmt::format(
        "{}: {}. Slopes of {} members, Student's t: the load changes by {:+.2g} % [{:+.2g}, {:+.2g}] of its mean over "
        "the measured window of {:g} s (p = {:.2g}){}.{}",
        name, verdict, trend.members, change.estimate / trend.mean / unit::percent,
        change.low / trend.mean / unit::percent, change.high / trend.mean / unit::percent, about.analysis.window,
        trend.load.p,
        std::isfinite(trend.maxima.p)
            ? fmt::format("; its segment maxima, the last less the first: p = {:.2g}", trend.maxima.p)
            : "",
        beyond);
}

std::string end_text(const CaseRow& about) {
    if (about.far_end == FarEnd::never) return "";
    if (about.far_end == FarEnd::open) return " The field ends in open water; field.far_end = \"never\" has no end.";
    return " The tow comes nearer to the ice sheet at the field's end; field.far_end = \"never\" has no end.";
}

}  // namespace floes
