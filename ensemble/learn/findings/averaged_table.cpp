#include "findings/averaged_table.hpp"

#include <fmt/format.h>

#include "tables/number_text.hpp"

namespace floes {

Table averaged_table(const Summary& summary) {
    Table table{{"case", "over, s", "SD, N", "mean maximum, N", "95 % interval", "one further run", "SD maximum, N"}};
    for (const CaseSummary& row : summary.cases) {
        for (const Quantity& one : summary.quantities) {
            if (one.averaging == 0 || one.averaged != quantity("mean_maximum").averaged) continue;
            const Estimate& found = row.of(one);
            const auto estimate = [&](const Quantity& other) {
                return fixed(row.of(averaged_over(other, one.averaging)).estimate, 1);
            };
            table.push_back({row.about.name, fmt::format("{}", one.averaging), estimate(quantity("sd_load")),
                             fixed(found.estimate, 1), bracket(found.low, found.high, 1),
                             bracket(found.prediction_low, found.prediction_high, 1),
                             estimate(quantity("sd_maximum"))});
        }
    }
    return table;
}

}  // namespace floes
