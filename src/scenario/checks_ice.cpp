// Contradictions within the ice, its laws and the time of a run.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/laws.hpp"
#include "scenario/validate.hpp"

namespace floes {

namespace {

constexpr double relative_rounding = 1e-9;  // relative: 0.6 / 0.2 is not 3 in binary
constexpr double most_elements = 1e7;
constexpr double most_steps = 2e7;  // a member holds three loads of each, 480 MB

bool is_whole(double ratio) {
    return std::abs(ratio - std::round(ratio)) <= relative_rounding * std::max(1.0, std::abs(ratio));
}

void check_side(const Scenario& scenario, double side, const std::string& key, Contradictions& found) {
    const double ratio = side / scenario.floe.element;
    if (is_whole(ratio) && ratio > 0.5) return;
    const double pieces = std::max(1.0, std::round(ratio));
    refuse(scenario, found, {"floe.element_m", key},
           "<floe.element_m> does not divide <{}>; the nearest side that does is {:.6g}", key, side / pieces);
}

void check_whole_steps(const Scenario& scenario, double time, const std::string& key, Contradictions& found) {
    const double step = scenario.general.time_step;
    if (is_whole(time / step)) return;
    refuse(scenario, found, {key, "general.time_step_s"},
           "<{}> is not a whole number of steps of <general.time_step_s>; the nearest that is: {:.6g}", key,
           std::max(1.0, std::round(time / step)) * step);
}

}  // namespace

void check_sides(const Scenario& scenario, Contradictions& found) {
    if (scenario.has_cells()) return;
    check_side(scenario, scenario.floe.length, "floe.length_m", found);
    if (scenario.floe.breadth != scenario.floe.length)
        check_side(scenario, scenario.floe.breadth, "floe.breadth_m", found);
}

void check_elements(const Scenario& scenario, Contradictions& found) {
    if (scenario.sizes.law != SizeLaw::one || scenario.shapes.from_file()) return;  // others have looked at those
    if (!scenario.shapes.any()) check_sides(scenario, found);
    if (!scenario.arrangement.columns.empty()) return;  // check_given_floes() counts those
    check_element_count(scenario, scenario.floe.elements() * scenario.field.floes, found);
}

void check_element_count(const Scenario& scenario, double elements, Contradictions& found) {
    if (elements > most_elements) {
        refuse(scenario, found, {"floe.element_m", "field.floes"},
               "<floe.element_m> with <field.floes> makes {:.4g} elements, more than the {:.0e} a member may have; "
               "take larger elements or fewer floes",
               elements, most_elements);
    }
}

void check_floating(const Scenario& scenario, Contradictions& found) {
    if (scenario.ice.density >= scenario.water.density) {
        refuse(scenario, found, {"ice.density_kg_m3", "water.density_kg_m3"},
               "<ice.density_kg_m3> is not below <water.density_kg_m3>, so the ice sinks; lower the ice's density");
        return;
    }
    // An element heaves as a spring of stiffness ρ_w g L_e² under a mass ρ_i T_e L_e²; explicit forces need ω Δt < 2
    // (√(1 + ζ²) - ζ), where damping ζ of the critical is explicit, too.
    const double heave =
        std::sqrt(scenario.water.density * scenario.general.gravity / (scenario.ice.density * scenario.floe.thickness));
    const double damping = scenario.water.heave_damping_from == WaterFrom::share ? scenario.water.heave_damping : 0;
    const double most = 2 * (std::hypot(1, damping) - damping);
    if (heave * scenario.general.time_step >= most) {
        refuse(scenario, found,
               {"general.time_step_s", "ice.thickness_m", "ice.density_kg_m3", "water.density_kg_m3",
                "general.gravity_m_s2"},
               "<general.time_step_s> is too long for <ice.thickness_m>: floating ice heaves at {:.4g} rad/s there and "
               "diverges; take a step below {:.4g}",
               heave, most / heave);
    }
}

void check_stress_averaging(const Scenario& scenario, Contradictions& found) {
    constexpr int most_steps = 1000;  // each keeps the reactions of all joints
    if (!scenario.joint.fails_by_stress() || scenario.stress_steps() <= most_steps) return;
    refuse(scenario, found, {"joint.averaging_s", "general.time_step_s"},
           "the stress at joints is averaged over {:.4g} s, {} steps of <general.time_step_s>, more than the {} that "
           "are kept; take longer steps or a shorter joint.averaging_s",
           scenario.stress_averaging(), scenario.stress_steps(), most_steps);
}

void check_proportions(const Scenario& scenario, Contradictions& found) {
    constexpr double largest_strain = 0.1;        // at failure; ice breaks at some 1e-4, model ice at some 1e-3
    constexpr double least_concentration = 0.01;  // less is a fraction that was meant as a percentage
    double side = std::min(scenario.floe.length, scenario.floe.breadth);
    if (scenario.sizes.law != SizeLaw::one || scenario.shapes.from_file()) {
        side = std::numeric_limits<double>::infinity();
        for (const FloeShape& shape : floe_sizes(scenario)) side = std::min({side, shape.length, shape.breadth});
    }
    if (scenario.floe.thickness > side) {
        refuse(scenario, found, {"ice.thickness_m", "floe.length_m", "floe.breadth_m"},
               "<ice.thickness_m> is more than the floe's side of {:g} m, so that it would lie on its edge; a floe is "
               "a sheet. Take thinner ice or larger floes",
               side);
    }
    if (scenario.ice.bending_strength > largest_strain * scenario.ice.elastic_modulus) {
        refuse(scenario, found, {"ice.bending_strength_kPa", "ice.elastic_modulus_MPa"},
               "<ice.bending_strength_kPa> is more than a tenth of <ice.elastic_modulus_MPa>: such ice is rubber, and "
               "joints are elastic only as long as they turn little. Sea ice has some 500 kPa and 5000 MPa, model ice "
               "some 40 kPa and 60 MPa; mind that one is in kPa and the other in MPa");
    }
    if (scenario.field.concentration < least_concentration && !scenario.arrangement.given()) {
        refuse(scenario, found, {"field.concentration_percent"},
               "<field.concentration_percent> is less than 1 percent, a field of {:.4g} m almost without ice; write 75 "
               "for three quarters. For single floes in open water give their places: arrangement.method = \"file\"",
               scenario.field_length());
    }
}

void check_friction(const Scenario& scenario, Contradictions& found) {
    const SlipFriction& slip = scenario.contact.slip;
    if (slip.least <= slip.largest) return;
    refuse(scenario, found, {"contact.least_friction", "contact.largest_friction"},
           "<contact.least_friction> is above <contact.largest_friction>; between them every coefficient must find its "
           "place");
}

void check_solver(const Scenario& scenario, Contradictions& found) {
    const SolverKind solver = scenario.general.solver;
    std::vector<Refusal> refused = refused_contacts(solver, scenario.contact);
    const auto ask = [&](bool wanted, Feature feature) {
        if (const auto refusal = refusal_of(solver, feature); wanted && refusal) refused.push_back(*refusal);
    };
    ask(scenario.joint.model == JointModel::beam, Feature::springs);
    ask(scenario.water.added_mass_from == WaterFrom::outline, Feature::carried_water);
    ask(scenario.field.wake_radius > 0, Feature::sleep);
    ask(scenario.water.has_bed(), Feature::bed);
    ask(scenario.field.sides == FieldSides::wall, Feature::walls);
    for (const auto& [key, with, reason, instead] : refused) {
        refuse(scenario, found, {std::string(key), std::string(with)}, "<{}> is not possible with <{}>: {}; take {}",
               std::string(key), std::string(with), reason, instead);
    }
}

namespace {

/// `noun`: what the list is of; `takes`: what a member does with them.
void check_rising(const Scenario& scenario, const std::vector<double>& list, const std::string& key, std::size_t most,
                  const char* noun, const char* takes, Contradictions& found) {
    if (std::ranges::adjacent_find(list, std::greater_equal()) != list.end())
        refuse(scenario, found, {key}, "<{}> does not rise from each to the next", key);
    if (list.size() > most)
        refuse(found, {key}, "{} has {} {}, more than the {} that a member {}", key, list.size(), noun, most, takes);
}

/// The windows and the number of segments next to those of a configuration that go together, in words.
std::string what_cuts(const Analysis& analysis, std::int64_t window_steps, double time_step) {
    // A value of the history must not lie across the window's edge either.
    const std::int64_t stride = analysis.keep_history ? analysis.history_stride : 1;
    const std::int64_t part = std::lcm(std::int64_t{analysis.segments}, stride);
    const std::int64_t least = (2 * analysis.segments + part - 1) / part * part;
    const std::int64_t below = window_steps / part * part;
    std::string words =
        fmt::format("analysis.window_s = {:.10g}", static_cast<double>(std::max(below, least)) * time_step);
    if (below >= least) words += fmt::format(" or {:.10g}", static_cast<double>(below + part) * time_step);
    std::int64_t segments = std::min(std::int64_t{analysis.segments}, window_steps / 2);
    while (segments > 1 && window_steps % segments != 0) --segments;
    return segments < 1 ? words : words + fmt::format(", or analysis.segments = {}", segments);
}

}  // namespace

void check_time(const Scenario& scenario, Contradictions& found) {
    const Analysis& analysis = scenario.analysis;
    const double steps = (analysis.steady_start + analysis.window) / scenario.general.time_step;
    if (steps > most_steps) {
        refuse(scenario, found, {"general.time_step_s", "analysis.steady_start_s", "analysis.window_s"},
               "<general.time_step_s> with <analysis.steady_start_s> and <analysis.window_s> makes {:.4g} steps, more "
               "than the {:.0e} a run may have; take a longer step or a shorter run",
               steps, most_steps);
        return;
    }
    const std::size_t before = found.size();
    check_whole_steps(scenario, analysis.steady_start, "analysis.steady_start_s", found);
    check_whole_steps(scenario, analysis.window, "analysis.window_s", found);
    if (found.size() > before) return;
    const int window_steps = scenario.step_count() - scenario.first_window_step();
    if (window_steps % analysis.segments != 0 || window_steps / analysis.segments < 2) {
        refuse(scenario, found, {"analysis.segments", "analysis.window_s", "general.time_step_s"},
               "<analysis.segments> does not cut <analysis.window_s> ({} steps) into equal parts of at least 2 steps; "
               "take {}",
               window_steps, what_cuts(analysis, window_steps, scenario.general.time_step));
    }
    if (analysis.keep_history &&
        (window_steps % analysis.history_stride != 0 || scenario.first_window_step() % analysis.history_stride != 0)) {
        refuse(scenario, found,
               {"analysis.history_steps", "analysis.steady_start_s", "analysis.window_s", "general.time_step_s"},
               "<analysis.history_steps> does not divide both the {} steps before the window and the {} in it, so that "
               "a value of the history would lie across its edge; take a divisor of both",
               scenario.first_window_step(), window_steps);
    }
}

void check_levels(const Scenario& scenario, Contradictions& found) {
    check_rising(scenario, scenario.analysis.exceedance_levels, "analysis.exceedance_levels_N", 1000, "levels",
                 "counts", found);
}

void check_averaging(const Scenario& scenario, Contradictions& found) {
    const std::string key = "analysis.averaging_s";
    check_rising(scenario, scenario.analysis.averaging, key, 100, "times", "takes", found);
    const double step = scenario.general.time_step;
    const double segment = scenario.analysis.window / scenario.analysis.segments;
    for (const double time : scenario.averaging_times()) {
        if (scenario.is_averaging_time(time)) continue;
        if (time > segment) {
            refuse(scenario, found, {key, "analysis.window_s", "analysis.segments"},
                   "<{}>: {:g} s is longer than a segment of {:.6g} s; take a shorter time", key, time, segment);
        } else {
            refuse(scenario, found, {key, "general.time_step_s"},
                   "<{}>: {:g} s is not a whole number of steps of <general.time_step_s>; the nearest that is: {:.6g}",
                   key, time, std::max(1.0, std::round(time / step)) * step);
        }
        return;  // one message is enough
    }
}

namespace {

constexpr double least_mass = 1e-6;  // of a law within its bounds; less is a slip of the pen

void check_list(const Scenario& scenario, Contradictions& found) {
    const std::string key = "sizes.list_m";
    const std::vector<ListedSize>& list = scenario.sizes.list;
    if (list.empty()) {
        refuse(scenario, found, {"sizes.law", key},
               "<sizes.law> needs sizes.list_m = [[length_m, breadth_m, share_percent], ...]");
        return;
    }
    double sum = 0;
    for (const ListedSize& one : list) sum += one.share;
    if (std::abs(sum - 1) > 1e-6)
        refuse(found, {key}, "the shares of {} sum to {:.6g} %; they are to sum to 100 %", key, 100 * sum);
    if (scenario.sizes.element != ElementSide::given || scenario.has_cells()) return;
    const double element = scenario.floe.element;
    for (const ListedSize& one : list) {
        for (const double side : {one.length, one.breadth}) {
            const double ratio = side / element;
            if (is_whole(ratio) && ratio > 0.5) continue;
            refuse(scenario, found, {key, "floe.element_m"},
                   "<floe.element_m> does not divide the side of {:g} m in {}; the nearest side that does is {:.6g}, "
                   "or take sizes.element = \"of_floe\"",
                   side, key, side / std::max(1.0, std::round(ratio)));
            return;
        }
    }
}

void check_size_law(const Scenario& scenario, Contradictions& found) {
    const Sizes& sizes = scenario.sizes;
    if (sizes.smallest >= sizes.largest) {
        refuse(scenario, found, {"sizes.smallest_m", "sizes.largest_m"},
               "<sizes.smallest_m> is not below <sizes.largest_m>");
        return;
    }
    if (sizes.least_ratio > sizes.largest_ratio)
        refuse(scenario, found, {"sizes.ratio_lowest", "sizes.ratio_highest"},
               "<sizes.ratio_lowest> is above <sizes.ratio_highest>");
    if (sizes.law != SizeLaw::lognormal) return;
    const LognormalSizes law{sizes.mean, sizes.cov};
    const double mass =
        cut_off(sizes.by == SharesOf::area ? number_law(law) : law, {sizes.smallest, sizes.largest}).mass();
    if (mass < least_mass)
        refuse(scenario, found, {"sizes.smallest_m", "sizes.largest_m", "sizes.mean_m", "sizes.cov"},
               "<sizes.smallest_m> and <sizes.largest_m> leave {:.2g} of the lognormal law of <sizes.mean_m> and "
               "<sizes.cov>; take bounds on both sides of most floes",
               mass);
}

/// The shortest and the longest side of any floe before it is rounded, m.
std::pair<double, double> extreme_sides(const Sizes& sizes) {
    if (sizes.law != SizeLaw::list)
        return {sizes.smallest / std::sqrt(sizes.largest_ratio), sizes.largest * std::sqrt(sizes.largest_ratio)};
    std::vector<double> sides;
    for (const ListedSize& one : sizes.list) sides.insert(sides.end(), {one.length, one.breadth});
    const auto [shortest, longest] = std::ranges::minmax(sides);
    return {shortest, longest};
}

/// Elements no larger than the smallest floe, and no more of them than a member may have.
void check_size_elements(const Scenario& scenario, Contradictions& found) {
    const Sizes& sizes = scenario.sizes;
    if (sizes.element != ElementSide::of_floe) {
        const auto [shorter, longest] = extreme_sides(sizes);
        const double side = element_side(scenario, shorter);
        const std::string key = sizes.element == ElementSide::given ? "floe.element_m" : "sizes.element_share";
        if (side > shorter * (1 + 1e-9)) {
            refuse(scenario, found, {key, "sizes.smallest_m", "sizes.list_m"},
                   "<{}> makes elements of {:.4g} m, larger than the side of {:.4g} m of the smallest floe; take "
                   "smaller elements or larger floes",
                   key, side, shorter);
            return;
        }
        constexpr double most_along = 1e4;
        if (longest > most_along * side) {
            refuse(scenario, found, {key, "sizes.largest_m", "sizes.list_m"},
                   "<{}> makes elements of {:.4g} m, more than {:g} of them along the largest floe", key, side,
                   most_along);
            return;
        }
    }
    double elements = 0;
    for (const FloeShape& shape : floe_sizes(scenario)) elements += shape.elements();
    check_element_count(scenario, elements, found);
}

}  // namespace

void check_sizes(const Scenario& scenario, Contradictions& found) {
    const Sizes& sizes = scenario.sizes;
    if (sizes.law == SizeLaw::one) return;
    if (scenario.arrangement.method == ArrangementMethod::file) {
        refuse(scenario, found, {"sizes.law", "arrangement.method"},
               "<sizes.law> does not suit <arrangement.method>; give the sizes as columns of arrangement.file");
        return;
    }
    if (sizes.law == SizeLaw::list)
        check_list(scenario, found);
    else
        check_size_law(scenario, found);
    if (found.empty()) check_size_elements(scenario, found);
}

namespace {

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
            refuse(scenario, found, {bounds}, "<{}> is not two rising factors, such as [0.5, 2.0]", bounds);
        } else if (const double mass = Factors(spread->factors()).mass(); mass < least_mass) {
            refuse(scenario, found, {bounds, law, law + "_cov"},
                   "<{}> leaves {:.2g} of the law <{}> with <{}>; take bounds on both sides of 1", bounds, mass, law,
                   law + "_cov");
        }
    }
}

void check_springs(const Scenario& scenario, Contradictions& found) {
    if (scenario.joint.model == JointModel::beam) return;
    const auto needs_beams = [&](const std::string& key) {
        refuse(scenario, found, {key, "joint.model"},
               "<{}> needs joint.model = \"beam\": with \"cfm\" joints do not follow the modulus of each floe", key);
    };
    if (scenario.spread.elastic_modulus.any()) needs_beams("spread.elastic_modulus");
    if (scenario.brine.salinity > 0) needs_beams("brine.salinity_ppt");
}

void check_brine(const Scenario& scenario, Contradictions& found) {
    constexpr double warmest = -0.5;
    constexpr double coldest = -22.9;
    const Brine& brine = scenario.brine;
    const IceSpread& spread = scenario.spread;
    for (const auto& [one, key] :
         {std::pair(&spread.salinity, "spread.salinity"), {&spread.temperature, "spread.temperature"}})
        if (one->any() && brine.salinity == 0)
            refuse(scenario, found, {key}, "<{}> needs brine.salinity_ppt above 0", key);
    if (brine.salinity == 0 || !found.empty()) return;
    const double warm = brine.temperature * least_factor(spread.temperature);
    const double cold = brine.temperature * largest_factor(spread.temperature);
    if (warm > warmest || cold < coldest) {
        refuse(scenario, found, {"spread.temperature_within", "brine.temperature_C"},
               "<brine.temperature_C> with <spread.temperature_within> reaches from {:.3g} to {:.3g} °C; the formula "
               "is for {:g} to {:g} °C",
               cold, warm, coldest, warmest);
        return;
    }
    const double most = brine_volume(brine.salinity * largest_factor(spread.salinity), warm);
    if (brine_modulus(most) <= 0)
        refuse(scenario, found, {"brine.salinity_ppt", "brine.temperature_C", "spread.salinity_within"},
               "<brine.salinity_ppt> with <brine.temperature_C> makes up to {:.3g} of the ice brine, where the "
               "formulas leave it no stiffness; take colder or fresher ice, or narrower bounds",
               most);
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
