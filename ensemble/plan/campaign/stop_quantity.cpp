#include "campaign/stop_quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "quantities/quantity.hpp"

namespace floes {
namespace {

/// Of a design load.
std::optional<std::string> design_load_fault(const Campaign& campaign) {
    constexpr double lowest_quantile = 0.001;
    const StopRule& stop = campaign.stop;
    if (stop.contrast != "none")
        return fmt::format(
            "stop.of = \"{}\" has no paired difference, and stop.contrast = \"{}\" asks for one; write "
            "stop.contrast = \"none\" and name a case, or let stop.of be a quantity of members",
            stop.of, stop.contrast);
    if (stop.quantile > 0 && stop.quantile < lowest_quantile)
        return fmt::format(
            "stop.quantile = {:g} is below {:g}; it is the probability that the load is not exceeded, 0.9 say, or 0 "
            "for the expected largest load",
            stop.quantile, lowest_quantile);
    for (const Case& one : campaign.cases) {
        const std::vector<double> times = one.scenario.averaging_times();
        if (std::ranges::find(times, stop.averaging) != times.end()) continue;
        const double segment = one.scenario.analysis.window / one.scenario.analysis.segments;
        if (stop.averaging > segment)
            return fmt::format(
                "stop.averaging_s = {:g} is longer than a segment of case {}, {:.6g} s (analysis.window_s, "
                "analysis.segments), so nothing can be averaged over it",
                stop.averaging, one.name, segment);
        return fmt::format(
            "stop.of = \"{}\" wants peaks of the load averaged over stop.averaging_s = {:g} s, which case {} does not "
            "take; {}",
            stop.of, stop.averaging, one.name,
            times.empty() ? std::string{"it averages over no time (analysis.averaging_s)"}
                          : fmt::format("its times are {} s (analysis.averaging_s)", fmt::join(times, ", ")));
    }
    return {};
}

}  // namespace

std::optional<std::string> stop_quantity_fault(const Campaign& campaign) {
    if (campaign.stop.of_design_load()) return design_load_fault(campaign);
    const std::string given = fmt::format("stop.of = \"{}\"", campaign.stop.of);
    const std::optional<Quantity> quantity = any_quantity(campaign.stop.of);
    if (!quantity || !quantity->stops) {
        std::vector<std::string> known;
        for (const Quantity& one : quantities)
            if (one.stops) known.push_back(fmt::format("\"{}\"", one.key.view()));
        return fmt::format("{} is not allowed; use {}, one that is averaged, such as \"mean_maximum_0.5s\", or \"{}\"",
                           given, fmt::join(known, " or "), design_load_word);
    }
    if (quantity->averaging == 0) return {};
    for (const Case& one : campaign.cases) {
        const std::vector<double> times = one.scenario.averaging_times();
        if (std::ranges::find(times, quantity->averaging) == times.end())
            return fmt::format(
                "{} is of a time that case {} does not average over; its times are {} s "
                "(analysis.averaging_s)",
                given, one.name, fmt::join(times, ", "));
    }
    return {};
}

}  // namespace floes
