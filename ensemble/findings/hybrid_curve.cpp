#include "findings/hybrid_curve.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "core/error.hpp"
#include "core/units.hpp"
#include "theory/plate.hpp"

namespace floes {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

LevelIce ice_of(const Scenario& scenario) {
    return {.thickness = scenario.ice.thickness,
            .bending_strength = scenario.ice.bending_strength,
            .density = scenario.ice.density,
            .water_density = scenario.water.density,
            .gravity = scenario.general.gravity};
}

}  // namespace

IceHull hull_of(const Scenario& scenario) {
    const double diameter = 2 * scenario.structure.shape.waterline_radius();
    const double angle = scenario.structure.shape.wall_angle_above_water();
    if (!(angle > 0 && angle < right_angle))
        throw InputError(fmt::format(
            "The hybrid model needs a wall that flares from the waterline upwards; structure.profile_m has one of "
            "{:.4g}° from the horizontal there.",
            angle / unit::degree));
    return {.breadth = diameter,
            .length = diameter,
            .draught = scenario.structure.shape.draught(),
            .stem_angle = angle,
            .entrance_angle = right_angle,
            .friction = scenario.contact.ice_structure_friction};
}

HybridModel hybrid_model(const Scenario& scenario) {
    return {hull_of(scenario), ice_of(scenario), scenario.field.concentration, scenario.floe.length,
            scenario.structure.speed};
}

HybridCurve hybrid_curve(const Scenario& scenario, const HybridModel& model, std::span<const double> moduli) {
    const FloatingPlate plate{.thickness = scenario.ice.thickness,
                              .water_density = scenario.water.density,
                              .gravity = scenario.general.gravity};
    HybridCurve curve{hull_of(scenario), model.coefficients(), {}, model.crossing()};
    for (const double modulus : moduli) {
        curve.points.push_back({modulus, plate.characteristic_length(modulus), model.limit_stress(modulus),
                                model.limit_momentum(), model.load(modulus)});
    }
    return curve;
}

std::string hybrid_table(const HybridCurve& curve) {
    std::string text =
        "     E   l_c    R_LS = crushing + bending + submergence    R_LM     R_F\n"
        "   MPa     m       N          N         N             N       N       N\n";
    for (const HybridPoint& p : curve.points) {
        text += fmt::format("{:6.4g} {:5.3f} {:7.1f} {:10.1f} {:9.1f} {:13.1f} {:7.1f} {:7.1f}\n",
                            p.elastic_modulus / unit::megapascal, p.characteristic_length, p.limit_stress.total(),
                            p.limit_stress.crushing, p.limit_stress.bending, p.limit_stress.submergence,
                            p.limit_momentum, p.load);
    }
    text += curve.crossing ? fmt::format("\nfloes break above {:.4g} MPa and are pushed aside below it\n",
                                         *curve.crossing / unit::megapascal)
                           : "\nfloes are pushed aside at any modulus\n";
    return text + fmt::format("KPR coefficients k1 = {:.4g}, k2 = {:g}, k3 = {:g}: chosen, no source gives them\n",
                              curve.coefficients.static_part, curve.coefficients.dissipative,
                              curve.coefficients.impact);
}

std::string hybrid_json(const HybridCurve& curve) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const HybridPoint& p : curve.points) {
        rows.push_back({{"elastic_modulus_MPa", p.elastic_modulus / unit::megapascal},
                        {"limit_stress_N", p.limit_stress.total()},
                        {"limit_momentum_N", p.limit_momentum},
                        {"hybrid_N", p.load},
                        {"crushing_N", p.limit_stress.crushing},
                        {"bending_N", p.limit_stress.bending},
                        {"submergence_N", p.limit_stress.submergence},
                        {"characteristic_length_m", p.characteristic_length}});
    }
    nlohmann::ordered_json crossing = nullptr;
    if (curve.crossing) crossing = *curve.crossing / unit::megapascal;
    return nlohmann::ordered_json{
               {"rows", rows},
               {"crossing_MPa", crossing},
               {"wall_deg", curve.hull.stem_angle / unit::degree},
               {"kpr_coefficients",
                {curve.coefficients.static_part, curve.coefficients.dissipative, curve.coefficients.impact}}}
               .dump(2) +
           "\n";
}

std::string hybrid_csv(const HybridCurve& curve) {
    std::string text =
        "elastic_modulus_MPa,limit_stress_N,limit_momentum_N,hybrid_N,crushing_N,bending_N,submergence_N,"
        "characteristic_length_m\n";
    for (const HybridPoint& p : curve.points) {
        text += fmt::format("{},{},{},{},{},{},{},{}\n", p.elastic_modulus / unit::megapascal, p.limit_stress.total(),
                            p.limit_momentum, p.load, p.limit_stress.crushing, p.limit_stress.bending,
                            p.limit_stress.submergence, p.characteristic_length);
    }
    return text;
}

}  // namespace floes
