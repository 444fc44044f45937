#include "findings/load_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "core/wording.hpp"
#include "findings/printable.hpp"
#include "inference/unlike_members.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

double largest_estimate(const Summary& summary, const Quantity& quantity) {
    double largest = 0;
    for (const CaseSummary& row : summary.cases) {
        const double found = std::abs(row.of(quantity).estimate);
        if (found > largest) largest = found;  // false for NaN
    }
    return largest;
}

}  // namespace

int few_decimals(double largest) {
    return largest >= 100 ? 0 : largest >= 1 ? 1 : largest >= 0.1 ? 2 : largest > 0 ? 3 : 1;
}

std::string LoadColumn::cell(const CaseSummary& row) const {
    const Estimate& found = row.of(quantity);
    if (!std::isfinite(found.estimate)) return "–";
    const std::string value = fixed(factor * found.estimate, decimals);
    if (row.done >= fewest_for_interval && found.low == found.high) return value + " in all";
    const double half = std::max(found.high - found.estimate, found.estimate - found.low);
    const bool said = says_something(quantity, found.estimate, {found.low, found.high}, row.done);
    return fmt::format("{} ± {}", value, said ? fixed(factor * half, decimals) : "–");
}

Quantity largest_load(const Summary& summary) {
    Quantity largest = quantity("mean_maximum");
    for (const Quantity& one : summary.quantities) {
        if (one.averaging == 0 || one.averaged != quantity("mean_maximum").averaged) continue;
        largest = one;
        if (one.averaging == 1) break;
    }
    return largest;
}

std::string largest_words(const Quantity& largest) {
    return largest.averaging == 0 ? "largest of a step" : fmt::format("largest over {:g} s", largest.averaging);
}

std::vector<LoadColumn> load_columns(const Summary& summary) {
    std::vector<LoadColumn> columns;
    const auto add = [&](const Quantity& quantity, const std::string& words) {
        const double largest = largest_estimate(summary, quantity);
        const LoadUnit unit = load_unit(largest);
        columns.push_back({quantity, words, std::string{unit.name}, unit.factor, few_decimals(unit.factor * largest)});
    };
    add(quantity("mean_load"), "mean load");
    add(largest_load(summary), largest_words(largest_load(summary)));
    const Quantity& broken = quantity("failure_ratio");
    columns.push_back({broken, "broken floes", "%", broken.factor(), 1});
    return columns;
}

namespace {

/// Whether a case has a figure without an interval.
bool any_dash(const Summary& summary) {
    for (const LoadColumn& column : load_columns(summary))
        for (const CaseSummary& row : summary.cases)
            if (column.cell(row).ends_with("± –")) return true;
    return false;
}

}  // namespace

std::string unseen_text(const Summary& summary, bool in_full) {
    constexpr double times = 5;  // the load
    int fewest = 0;
    for (const CaseSummary& row : summary.cases)
        if (row.done >= fewest_for_interval && (fewest == 0 || row.done < fewest)) fewest = row.done;
    if (fewest == 0) return "";
    return fmt::format(
        " Kinds of member that none of n = {} is are in no interval; up to {:.2g} % of all may be such{}.", fewest,
        unseen_share(static_cast<std::size_t>(fewest)) / unit::percent,
        in_full ? fmt::format(": each percent at {:g} times the load adds {:g} % to the mean", times, times - 1)
                : std::string{});
}

std::string load_columns_text(const Summary& summary) {
    const Quantity largest = largest_load(summary);
    int segments = 0;
    bool same = true;
    for (const CaseSummary& row : summary.cases) {
        same = same && (segments == 0 || segments == row.about.analysis.segments);
        segments = row.about.analysis.segments;
    }
    const std::string parts = same && segments == 1 ? "the window"
                              : same ? fmt::format("each of the window's {}", counted(segments, "segment"))
                                     : std::string{"each of the window's segments"};
    return fmt::format(
               "±: 95 % interval of the mean over arrangements (t), of sampling alone (floes vary: of the model){}. "
               "Largest: of {}, {}; their mean.",
               any_dash(summary) ? fmt::format("; –: of fewer than {}, or too wide", fewest_for_interval)
                                 : std::string{},
               parts,
               largest.averaging == 0 ? std::string{"in a single step, which depends on the time step"}
                                      : fmt::format("averaged over {:g} s", largest.averaging)) +
           unseen_text(summary, false);
}

}  // namespace floes
