#include "campaign/advice.hpp"

#include <fmt/format.h>

#include "core/units.hpp"
#include "theory/plate.hpp"

namespace floes {

std::vector<std::string> advice(const Campaign& campaign) {
    constexpr int most_named = 12;  // a design may have thousands of cases
    std::vector<std::string> sentences;
    int others = 0;
    for (const Case& one : campaign.cases) {
        const Scenario& scenario = one.scenario;
        const FloatingPlate plate{.thickness = scenario.floe.thickness,
                                  .water_density = scenario.water.density,
                                  .gravity = scenario.general.gravity};
        const double length = plate.characteristic_length(scenario.ice.elastic_modulus);
        if (scenario.floe.element < length) continue;
        if (sentences.size() == most_named) {
            ++others;
            continue;
        }
        sentences.push_back(fmt::format(
            "case {}: floe.element_m = {:g} is not below {:.3g} m, the characteristic length of ice of {:g} MPa; "
            "such elements are too large to show where the ice would bend and break.",
            one.name, scenario.floe.element, length, scenario.ice.elastic_modulus / unit::megapascal));
    }
    if (others > 0) sentences.push_back(fmt::format("The same holds for {} further cases.", others));
    return sentences;
}

}  // namespace floes
