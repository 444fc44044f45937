#include "findings/sloping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "core/units.hpp"
#include "tables/number_text.hpp"
#include "theory/hybrid_curve.hpp"

namespace floes {
namespace {

struct Line {
    double modulus;  ///< Pa
    SlopingLoad load;
};

struct Crushing {
    double strength;
    double load;
};

std::string rubble_words(const Rubble& rubble) {
    return fmt::format(
        "rubble {:.3g} m high, porosity {:g}, angle {:.3g}°, friction angle {:.3g}°, cohesion {:g} kPa; ice on ice "
        "{:g}",
        rubble.height, rubble.porosity, rubble.angle / unit::degree, rubble.friction_angle / unit::degree,
        rubble.cohesion / unit::kilopascal, rubble.ice_friction);
}

Table table_of(const std::vector<Line>& lines, const LoadUnit& unit) {
    Table table{{"E, MPa", fmt::format("sloping, {}", unit.name), "H_B", "H_P", "H_L", "H_R", "H_T", "thrust"}};
    for (const auto& [modulus, load] : lines) {
        const auto shown = [&](double force) {
            const double value = unit.factor * force;
            return fixed(value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
        };
        table.push_back({fmt::format("{:.4g}", modulus / unit::megapascal), shown(load.total()), shown(load.breaking),
                         shown(load.pushing), shown(load.lifting), shown(load.ride_up), shown(load.turning),
                         fixed(load.thrust, 3)});
    }
    return table;
}

std::vector<DataRows> records_of(const std::vector<Line>& lines, const Rubble& rubble, const Crushing& crushing) {
    return {json_only(make_rows<Line>(
                "sloping/rows", lines,
                {{"elastic_modulus_MPa", [](const Line& one) { return one.modulus / unit::megapascal; }},
                 {"load_N", [](const Line& one) { return one.load.total(); }},
                 {"breaking_N", [](const Line& one) { return one.load.breaking; }},
                 {"pushing_N", [](const Line& one) { return one.load.pushing; }},
                 {"lifting_N", [](const Line& one) { return one.load.lifting; }},
                 {"ride_up_N", [](const Line& one) { return one.load.ride_up; }},
                 {"turning_N", [](const Line& one) { return one.load.turning; }},
                 {"thrust", [](const Line& one) { return one.load.thrust; }}})),
            json_only(make_object<Rubble>(
                "sloping/rubble", rubble,
                {{"height_m", &Rubble::height},
                 {"porosity", &Rubble::porosity},
                 {"angle_deg", [](const Rubble& one) { return one.angle / unit::degree; }},
                 {"friction_angle_deg", [](const Rubble& one) { return one.friction_angle / unit::degree; }},
                 {"cohesion_kPa", [](const Rubble& one) { return one.cohesion / unit::kilopascal; }},
                 {"ice_friction", &Rubble::ice_friction}})),
            json_only(make_object<Crushing>(
                "crushing", crushing,
                {{"strength_MPa", [](const Crushing& one) { return one.strength / unit::megapascal; }},
                 {"load_N", &Crushing::load}}))};
}

}  // namespace

Rubble rubble_on(const Scenario& scenario) {
    Rubble rubble;
    rubble.height = 3 * scenario.floe.thickness;
    rubble.angle = std::min(rubble.angle, hull_of(scenario).stem_angle);
    rubble.ice_friction = scenario.contact.ice_ice_friction;
    return rubble;
}

Section sloping_section(const Scenario& scenario, std::span<const double> moduli, const SlopingRequest& request) {
    const IceHull hull = hull_of(scenario);
    check_rubble(request.rubble, hull.stem_angle);
    LevelIce ice = level_ice_of(scenario);
    const Crushing crushing{request.crushing_strength,
                            crushing_load(hull.breadth, ice.thickness, request.crushing_strength)};
    std::vector<Line> lines;
    std::string refusal;
    double largest = crushing.load;
    try {
        for (const double modulus : moduli) {
            ice.elastic_modulus = modulus;
            lines.push_back({modulus, sloping_load(hull, ice, request.rubble)});
            largest = std::max(largest, lines.back().load.total());
        }
    } catch (const InputError& none) {
        refusal = fmt::format("{}\n", none.what());
    }
    const LoadUnit unit = load_unit(largest);
    Section section{
        .title = "Level ice without an end, by ISO 19906",
        .before = refusal,
        .after = fmt::format(
            "\nSloping wall, (H_B + H_P + H_L + H_R + H_T) x thrust: breaking the sheet, pushing it through the "
            "rubble, "
            "lifting rubble, blocks up the wall, turning them at its top; {}. Crushing on a vertical wall of the same "
            "breadth with C_R {:g} MPa: {:.3g} {}.\n"
            "For a sheet that is wide and goes on coming; not for floes (no concentration), round hulls or tanks.\n",
            rubble_words(request.rubble), request.crushing_strength / unit::megapascal, unit.factor * crushing.load,
            unit.name),
        .records = records_of(lines, request.rubble, crushing)};
    if (!lines.empty()) section.table = table_of(lines, unit);
    return section;
}

}  // namespace floes
