#include "campaign/advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"
#include "shapes/hydrostatics.hpp"
#include "shapes/moorings.hpp"
#include "theory/plate.hpp"

namespace floes {

namespace {

/// What is odd about a case, as a sentence without its end; empty where nothing is.
struct Odd {
    std::string told = {};
    double grade = 0;  ///< how odd, beside other cases: the oddest one is quoted
};
using Oddity = Odd (*)(const Case& one);

double largest_element(const Scenario& scenario) {
    if (scenario.sizes.law == SizeLaw::one) return scenario.floe.element;
    return std::ranges::max(floe_sizes(scenario), {}, &FloeShape::element).element;
}

double least_element(const Scenario& scenario) {
    if (scenario.sizes.law == SizeLaw::one) return scenario.floe.element;
    return std::ranges::min(floe_sizes(scenario), {}, &FloeShape::element).element;
}

std::string element_words(const Scenario& scenario, double element) {
    const bool own = scenario.sizes.law != SizeLaw::one && scenario.sizes.element != ElementSide::given;
    return own ? fmt::format("an element of {:.4g} m", element) : given(scenario, "floe.element_m");
}

Odd large_elements(const Case& one) {
    const Scenario& scenario = one.scenario;
    const FloatingPlate plate{.thickness = scenario.floe.thickness,
                              .water_density = scenario.water.density,
                              .gravity = scenario.general.gravity};
    const double length = plate.characteristic_length(scenario.ice.elastic_modulus);
    const double element = largest_element(scenario);
    if (one.pairing == Pairing::find_modulus || element < length) return {};
    return {fmt::format("{} is not below {:.3g} m, the characteristic length of ice of {:g} MPa; such elements are too "
                        "large to show where the ice would bend and break",
                        element_words(scenario, element), length, scenario.ice.elastic_modulus / unit::megapascal),
            element / length};
}

Odd thick_elements(const Case& one) {
    const Scenario& scenario = one.scenario;
    const double element = least_element(scenario);
    if (scenario.floe.thickness <= element) return {};
    return {fmt::format("{} is more than {}; elements that are thicker than wide do not bend as a plate does",
                        given(scenario, "ice.thickness_m"), element_words(scenario, element)),
            scenario.floe.thickness / element};
}

Odd little_ice(const Case& one) {
    constexpr double little = 0.05;
    const Scenario& scenario = one.scenario;
    if (scenario.field.concentration >= little || scenario.arrangement.given()) return {};
    return {fmt::format("{} leaves the field of {:.4g} m almost without ice; 75 is three quarters",
                        given(scenario, "field.concentration_percent"), scenario.field_length()),
            -scenario.field.concentration};
}

Odd odd_strength(const Case& one) {
    constexpr double weakest = 1 * unit::kilopascal;
    constexpr double strongest = 5000 * unit::kilopascal;
    const double strength = one.scenario.ice.bending_strength;
    if (strength >= weakest && strength <= strongest) return {};
    return {fmt::format("{} is unlike any ice; sea ice has some 500, model ice some 40",
                        given(one.scenario, "ice.bending_strength_kPa")),
            std::abs(std::log(strength / (500 * unit::kilopascal)))};
}

Odd soft_in_compression(const Case& one) {
    const Ice& ice = one.scenario.ice;
    if (ice.compressive_strength >= ice.bending_strength) return {};
    return {fmt::format("{} is below {}; ice is several times stronger in compression than in bending",
                        given(one.scenario, "ice.compressive_strength_kPa"),
                        given(one.scenario, "ice.bending_strength_kPa")),
            -ice.compressive_strength / ice.bending_strength};
}

Odd few_sweeps(const Case& one) {
    constexpr int few = 10;
    if (one.scenario.general.iterations >= few) return {};
    return {fmt::format("{} leaves contacts unsolved, and the load depends on it; with solver direct steps end by "
                        "themselves, and the default is only the most that one may take",
                        given(one.scenario, "general.iterations")),
            static_cast<double>(-one.scenario.general.iterations)};
}

Odd long_steps(const Case& one) {
    constexpr double most_of_thickness = 0.1;  // in the tank it is 0.04
    const Scenario& scenario = one.scenario;
    const double way = scenario.structure.speed * scenario.general.time_step;
    if (way <= most_of_thickness * scenario.floe.thickness) return {};
    return {fmt::format("{} and {} take the structure {:.3g} m on in each step, more than a tenth of the ice's "
                        "thickness; a shorter step resolves how it meets the ice",
                        given(scenario, "general.time_step_s"), given(scenario, "structure.speed_m_s"), way),
            way / scenario.floe.thickness};
}

Odd narrow_gap(const Case& one) {
    constexpr double few = 2;
    const std::optional<BankGap> gap = one.scenario.gap();
    if (!gap || gap->floes >= few) return {};
    return {fmt::format("{} leaves {:.3g} m between the structure and the bank, {:.3g} sides of a floe; below two the "
                        "load depends on the gap (docs/sea_ice.md), and floes vary has a wider channel",
                        given(one.scenario, "field.half_width_m"), gap->breadth, gap->floes),
            -gap->floes};
}

Odd light_structure(const Case& one) {
    constexpr double many = 100;
    const Scenario& scenario = one.scenario;
    if (!scenario.moorings.give_way()) return {};
    const double ratio = structure_over_floe(scenario);
    if (ratio >= many) return {};
    return {
        fmt::format(
            "{} and the water that moves with it are {:.3g} times the heaviest floe: a floe that strikes it pushes it "
            "{:.2g} % too hard, as docs/moorings.md says",
            given(scenario, "moorings.mass_t"), ratio, 100 / ratio),
        -ratio};
}

Odd other_mass(const Case& one) {
    constexpr double much = 0.1;
    constexpr double in_kilograms = 300;  // and more, and less than 3000 times as much, where 1000 times were meant
    const Scenario& scenario = one.scenario;
    if (!scenario.moorings.give_way()) return {};
    const double water = scenario.water.density * hydrostatics(scenario.structure.shape).volume;
    const double share = scenario.moorings.mass / water;
    if (std::abs(share - 1) <= much) return {};
    const bool kilograms = share > in_kilograms && share < 10 * in_kilograms;
    return {
        fmt::format("{} is {} the {:.4g} t of water that the hull displaces, and a hull that floats weighs as "
                    "much; {}",
                    given(scenario, "moorings.mass_t"),
                    share < 10 ? fmt::format("{:.3g} % of", share / unit::percent) : fmt::format("{:.4g} times", share),
                    water / unit::tonne,
                    kilograms ? "moorings.mass_t is in tonnes, and this looks like kilograms"
                              : "look at its draught and its size"),
        std::abs(std::log(share))};
}

/// Of a straight way, past ice that does not come by itself.
Odd early_window(const Case& one) {
    const Scenario& scenario = one.scenario;
    if (scenario.path.any()) return {};
    const double way = scenario.field.begin - scenario.structure.start - scenario.structure.shape.waterline_ahead();
    const double meets = way / scenario.structure.speed;
    const double early = meets - scenario.analysis.steady_start;
    if (early <= scenario.general.time_step) return {};
    return {fmt::format("{} begins to measure before the hull meets the ice, after {:.4g} s: {:.3g} % of the window "
                        "is open water; begin later, or start the hull nearer (structure.start_m)",
                        given(scenario, "analysis.steady_start_s"), meets,
                        100 * std::min(1.0, early / scenario.analysis.window)),
            early / scenario.analysis.window};
}

/// As floes design refuses them after the run.
Odd long_period(const Case& one) {
    const Scenario& scenario = one.scenario;
    if (!scenario.moorings.give_way()) return {};
    double longest = 0;
    Motion of = Motion::surge;
    for (const NaturalMode& mode : natural_modes(scenario.moorings, scenario.water_stiffness())) {
        if (!std::isfinite(mode.period) || mode.period <= longest) continue;
        longest = mode.period;
        of = mode.motion;
    }
    if (longest <= scenario.analysis.window / fewest_periods) return {};
    return {
        fmt::format("{} is shorter than three natural periods of {:.4g} s in {}, so floes design would give no "
                    "design value of it; take a window of {:.4g} s or more",
                    given(scenario, "analysis.window_s"), longest, motion_names.at(at(of)), fewest_periods * longest),
        longest / scenario.analysis.window};
}

constexpr std::array<Oddity, 12> oddities{large_elements,      thick_elements, little_ice,   odd_strength,
                                          soft_in_compression, few_sweeps,     long_steps,   narrow_gap,
                                          light_structure,     other_mass,     early_window, long_period};

double least_grade(const std::vector<std::pair<const Case*, Odd>>& found) {
    return std::ranges::min(found, {}, [](const auto& one) { return one.second.grade; }).second.grade;
}

}  // namespace

std::vector<std::string> advice(const Campaign& campaign) {
    std::vector<std::string> sentences;
    for (const Oddity oddity : oddities) {
        std::vector<std::pair<const Case*, Odd>> found;
        for (const Case& one : campaign.cases)
            if (Odd odd = oddity(one); !odd.told.empty()) found.emplace_back(&one, std::move(odd));
        if (found.empty()) continue;
        const auto oddest = std::ranges::max_element(found, {}, [](const auto& one) { return one.second.grade; });
        std::vector<std::string> others;
        for (const auto& one : found)
            if (one.first != oddest->first) others.push_back(one.first->name);
        constexpr std::size_t few = 3;  // names that are read; of more, if it is all of them, that says it
        const bool all = others.size() + 1 == campaign.cases.size() && others.size() > few;
        const std::string told = fmt::format("case {}: {}.", oddest->first->name, oddest->second.told);
        sentences.push_back(others.empty()
                                ? told
                                : fmt::format("{} {} {}.", told,
                                              oddest->second.grade > least_grade(found) ? "Less so, the same holds for"
                                                                                        : "The same holds for",
                                              all ? fmt::format("all {} others", others.size()) : name_list(others)));
    }
    return sentences;
}

}  // namespace floes
