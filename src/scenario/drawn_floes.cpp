// The floes of an arrangement: given one by one, or drawn by the laws of sizes and of the ice.

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "core/random.hpp"
#include "scenario/floes.hpp"
#include "scenario/ice_draws.hpp"
#include "scenario/shaped_floes.hpp"
#include "scenario/sizes.hpp"
#include "scenario/tables.hpp"

namespace floes {
namespace {

/// The keys that `columns` names, in its order; each holds a number.
std::vector<const Key*> named_keys(const Keys& keys, const std::string& columns) {
    std::vector<const Key*> named;
    std::istringstream names(columns);
    for (std::string name; std::getline(names, name, ',');) {
        const Key* key = find_key(keys, name);
        const bool number = key != nullptr && std::holds_alternative<NumberField>(key->field);
        if (!number || std::ranges::find(named, key) != named.end()) {
            throw InputError(fmt::format(
                "arrangement.columns = \"{}\" has \"{}\", which is {}; allowed: numbers of [floe], [ice] and [joint], "
                "each once, such as \"floe.length_m,floe.breadth_m,ice.thickness_m\"",
                columns, name, number ? "there twice" : "no such number"));
        }
        named.push_back(key);
    }
    return named;
}

std::vector<SingleFloe> given_floes(const Scenario& scenario) {
    const ArrangementRule& rule = scenario.arrangement;
    std::vector<SingleFloe> given;
    if (rule.columns.empty()) {
        for (const PlanarPose& pose : rule.poses) given.push_back({pose, scenario.floe, scenario.material()});
        return given;
    }
    FloeShape shape;
    Material material;
    Keys keys;
    add_floe(keys, shape);
    add_ice(keys, shape, material.ice, material.joint);
    add_joint(keys, material.joint);
    const std::vector<const Key*> columns = named_keys(keys, rule.columns);
    for (std::size_t floe = 0; floe < rule.poses.size(); ++floe) {
        const std::vector<double>& values = rule.values.at(floe);
        if (values.size() != columns.size())
            throw InputError(fmt::format("floe {} has {} values behind its pose and arrangement.columns names {}", floe,
                                         values.size(), columns.size()));
        shape = scenario.floe;
        material = scenario.material();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const NumberField& field = std::get<NumberField>(columns[i]->field);
            if (!field.range.contains(values[i]))
                throw InputError(fmt::format("floe {} has {} = {}; allowed: {}", floe, columns[i]->path, values[i],
                                             to_text(field.range)));
            field.set(values[i] * field.unit);
        }
        given.push_back({rule.poses[floe], shape, material});
    }
    return given;
}

/// Floes of the sizes of the scenario in an order of this arrangement's own, without places unless they were traced.
std::vector<SingleFloe> sized_floes(const Scenario& scenario, const Draw& draw) {
    if (scenario.arrangement.method == ArrangementMethod::traced) return floes_as_traced(scenario);
    std::vector<SingleFloe> sized;
    for (const FloeShape& shape : floe_sizes(scenario)) sized.push_back({{}, shape, scenario.material()});
    if (!sizes_may_differ(scenario)) return sized;
    RandomStream random(draw.seed, draw.number, StreamId::floe_sizes, draw.part);
    for (std::size_t left = sized.size(); left > 1; --left)
        std::swap(sized[left - 1].shape, sized[random.below(static_cast<std::uint32_t>(left))].shape);
    return sized;
}

}  // namespace

FloeSet floes_of(const Scenario& scenario, const Draw& draw) {
    const ArrangementRule& rule = scenario.arrangement;
    const bool given = rule.method == ArrangementMethod::file;
    if (!floes_may_differ(scenario))
        return floes_at(scenario,
                        given ? rule.poses : std::vector<PlanarPose>(static_cast<std::size_t>(scenario.field.floes)));
    std::vector<SingleFloe> floes = given ? given_floes(scenario) : sized_floes(scenario, draw);
    shape_floes(scenario, draw, floes);
    draw_ice(scenario, draw, floes);
    return gathered(floes);
}

}  // namespace floes
