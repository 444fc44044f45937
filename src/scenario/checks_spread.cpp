// Contradictions within the laws by which the ice of floes differs.

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "laws/brine.hpp"
#include "scenario/ice_draws.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace {

constexpr double least_mass = 1e-6;  // of a law within its bounds; less is a slip of the pen

struct NamedSpread {
    const Spread* spread;
    std::string law;  ///< its key
};

std::array<NamedSpread, 6> spreads_of(const IceSpread& of) {
    return {NamedSpread{&of.thickness, "spread.thickness"},
            {&of.strength, "spread.strength"},
            {&of.elastic_modulus, "spread.elastic_modulus"},
            {&of.density, "spread.density"},
            {&of.salinity, "spread.salinity"},
            {&of.temperature, "spread.temperature"}};
}

void check_laws(const Scenario& scenario, Contradictions& found) {
    for (const auto& [spread, law] : spreads_of(scenario.spread)) {
        if (!spread->any()) continue;
        const std::string bounds = law + "_within";
        const std::vector<double>& within = spread->within;
        if (within.size() != 2 || within[0] >= within[1]) {
            found.push_back(
                {{bounds}, fmt::format("{} is not two rising factors, such as [0.5, 2.0]", given(scenario, bounds))});
        } else if (const double mass = Factors(spread->factors()).mass(); mass < least_mass) {
            found.push_back(
                {{bounds, law, law + "_cov"},
                 fmt::format("{} leaves {:.2g} of the law {} with {}; take bounds on both sides of 1",
                             given(scenario, bounds), mass, given(scenario, law), given(scenario, law + "_cov"))});
        }
    }
}

void check_springs(const Scenario& scenario, Contradictions& found) {
    if (scenario.joint.model == JointModel::beam) return;
    const auto refuse = [&](const std::string& key) {
        found.push_back(
            {{key, "joint.model"},
             fmt::format("{} needs joint.model = \"beam\": with \"cfm\" joints do not follow the modulus of "
                         "each floe",
                         given(scenario, key))});
    };
    if (scenario.spread.elastic_modulus.any()) refuse("spread.elastic_modulus");
    if (scenario.brine.salinity > 0) refuse("brine.salinity_ppt");
}

void check_brine(const Scenario& scenario, Contradictions& found) {
    constexpr double warmest = -0.5;
    constexpr double coldest = -22.9;
    const Brine& brine = scenario.brine;
    const IceSpread& spread = scenario.spread;
    for (const auto& [one, key] :
         {std::pair(&spread.salinity, "spread.salinity"), {&spread.temperature, "spread.temperature"}})
        if (one->any() && brine.salinity == 0)
            found.push_back({{key}, fmt::format("{} needs brine.salinity_ppt above 0", given(scenario, key))});
    if (brine.salinity == 0 || !found.empty()) return;
    const double warm = brine.temperature * least_factor(spread.temperature);
    const double cold = brine.temperature * largest_factor(spread.temperature);
    if (warm > warmest || cold < coldest) {
        found.push_back({{"spread.temperature_within", "brine.temperature_C"},
                         fmt::format("{} with {} reaches from {:.3g} to {:.3g} °C; the formula is for {:g} to {:g} °C",
                                     given(scenario, "brine.temperature_C"),
                                     given(scenario, "spread.temperature_within"), cold, warm, coldest, warmest)});
        return;
    }
    const double most = brine_volume(brine.salinity * largest_factor(spread.salinity), warm);
    if (brine_modulus(most) <= 0)
        found.push_back(
            {{"brine.salinity_ppt", "brine.temperature_C", "spread.salinity_within"},
             fmt::format("{} with {} makes up to {:.3g} of the ice brine, where the formulas leave it no "
                         "stiffness; take colder or fresher ice, or narrower bounds",
                         given(scenario, "brine.salinity_ppt"), given(scenario, "brine.temperature_C"), most)});
}

/// Ice as [brine] says at one end of its laws.
void follow(Scenario& scenario, double salinity_factor, double temperature_factor) {
    if (scenario.brine.salinity == 0) return;
    const double brine =
        brine_volume(scenario.brine.salinity * salinity_factor, scenario.brine.temperature * temperature_factor);
    scenario.ice.bending_strength = flexural_strength(brine);
    scenario.ice.elastic_modulus = brine_modulus(brine);
}

}  // namespace

void check_spread(const Scenario& scenario, Contradictions& found) {
    const IceSpread& spread = scenario.spread;
    check_laws(scenario, found);
    check_springs(scenario, found);
    if (!found.empty()) return;
    check_brine(scenario, found);
    if (!found.empty() || !(spread.any() || scenario.brine.salinity > 0)) return;
    // Every single floe has to be ice that floats and bends little: the ends of the laws, in the worst combination.
    Scenario thin = scenario;
    follow(thin, least_factor(spread.salinity), largest_factor(spread.temperature));
    const double strongest = thin.ice.bending_strength;
    follow(thin, largest_factor(spread.salinity), least_factor(spread.temperature));
    thin.ice.bending_strength = strongest * largest_factor(spread.strength);
    thin.ice.elastic_modulus *= least_factor(spread.elastic_modulus);
    thin.ice.density *= least_factor(spread.density);
    thin.floe.thickness *= least_factor(spread.thickness);
    Scenario thick = scenario;
    thick.ice.density *= largest_factor(spread.density);
    thick.floe.thickness *= largest_factor(spread.thickness);
    for (const Scenario* end : {&thin, &thick}) {
        Contradictions of_end;
        check_floating(*end, of_end);
        check_proportions(*end, of_end);
        for (Contradiction& one : of_end) {
            one.sentence = "at an end of the laws of [spread]: " + one.sentence;
            for (const auto& [law, key] : spreads_of(spread))
                if (law->any()) one.keys.insert(one.keys.begin(), key);
            found.push_back(std::move(one));
        }
    }
}

}  // namespace floes
