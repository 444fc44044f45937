#include "campaign/stop_quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "quantities/quantity.hpp"

namespace floes {

std::optional<std::string> stop_quantity_fault(const Campaign& campaign) {
    const std::string given = fmt::format("stop.of = \"{}\"", campaign.stop.of);
    const std::optional<Quantity> quantity = any_quantity(campaign.stop.of);
    if (!quantity || !quantity->stops) {
        std::vector<std::string> known;
        for (const Quantity& one : quantities)
            if (one.stops) known.push_back(fmt::format("\"{}\"", one.key.view()));
        return fmt::format("{} is not allowed; use {}, or one that is averaged, such as \"mean_maximum_0.5s\"", given,
                           fmt::join(known, " or "));
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
