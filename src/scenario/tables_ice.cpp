// Keys of the tables [general], [ice], [floe], [joint], [contact], [paper], [sizes], [spread] and [brine].

#include <limits>

#include "keys/key.hpp"
#include "scenario/scenario.hpp"
#include "scenario/tables.hpp"

namespace floes {

void add_general(Keys& keys, General& general) {
    keys.push_back(
        number_key("general.time_step_s", general.time_step, unit::one, above(0).at_most(1), "Table 1",
                   "Time step. With joint.model = \"cfm\" the stiffness of joints is proportional to its inverse "
                   "square (see [joint]), so another time step gives other ice."));
    keys.push_back(integer_key(
        "general.iterations", general.iterations, 1, 100000, "docs/convergence.md",
        "Projected Gauss-Seidel sweeps per step. With solver direct they are over contacts only, end as soon as "
        "general.tolerance_mm_s is met, and this is the most: a cone takes 15 on average, ice that jams on a wall over "
        "100 (docs/fracture.md). Summaries say where most steps end before. "
        "With the others more sweeps make ice of small cfm stiffer: at cfm 1e-10 a sheet shows 37, 207 and 421 MPa at "
        "10, 50 and 100 sweeps; the paper's figures need 50."));
    keys.push_back(word_key(
        "general.solver", general.solver, {"stock", "lanes", "direct"},
        "E as stated, without a ceiling; docs/fracture.md",
        "Constraint solver: direct solves all joints of a floe exactly, so that only contacts need "
        "iterations (docs/fracture.md). lanes sweeps over joints and contacts, with many floes at once, one per "
        "SIMD lane; stock is Bullet's own, the reference and the paper's."));
    keys.push_back(late_key(only_with(
        "general.solver = \"direct\"", [&general] { return general.solver == SolverKind::direct; },
        number_key("general.tolerance_mm_s", general.tolerance, unit::millimetre, at_least(0).at_most(100),
                   "docs/performance.md",
                   "With solver direct: the sweeps of a step end after one that changed the velocity at no contact by "
                   "as much as this; general.iterations is the most. For ice of 33 mm, and in proportion to the root "
                   "of the thickness of other ice. 0: as many as general.iterations in every step."))));
    keys.push_back(
        number_key("general.gravity_m_s2", general.gravity, unit::one, above(0).at_most(100), "standard", "Gravity."));
    keys.push_back(number_key(
        "general.runaway_speed_m_s", general.runaway_speed, unit::one, above(0).at_most(1000), "a fall of 5 m",
        "If an element exceeds this speed, the member ends as failed, because the simulation has diverged."));
}

void add_ice(Keys& keys, FloeShape& floe, Ice& ice, const Joint& joint) {
    const Range strength = above(0).at_most(1e6);
    const Range criterion = at_least(0).at_most(1e6);
    keys.push_back(number_key("ice.thickness_m", floe.thickness, unit::one, above(0).at_most(10), "Table 1",
                              "Thickness of floes and elements. Failure thresholds and mass increase with it."));
    keys.push_back(number_key("ice.density_kg_m3", ice.density, unit::one, above(0).at_most(5000), "Table 1",
                              "Density of ice. The draught is thickness x density / water density."));
    keys.push_back(number_key("ice.bending_strength_kPa", ice.bending_strength, unit::kilopascal, strength, "Table 1",
                              "Bending (flexural) strength: of the outer fibres with joint.failure = \"stress\", by "
                              "Eq. (3) with \"moment\". With a lower value more floes break."));
    keys.push_back(number_key("ice.compressive_strength_kPa", ice.compressive_strength, unit::kilopascal, strength,
                              "Table 1",
                              "Compressive strength, Eq. (1); four times the bending strength in the paper."));
    keys.push_back(number_key("ice.shear_strength_kPa", ice.shear_strength, unit::kilopascal, strength, "Table 1",
                              "Shear strength, Eq. (2); twice the bending strength in the paper."));
    keys.push_back(number_key("ice.tensile_strength_kPa", ice.tensile_strength, unit::kilopascal, criterion,
                              "the paper has none",
                              "Tensile strength, of ice that is split in its plane. 0: the bending strength with "
                              "joint.failure = \"stress\", no failure criterion with \"moment\"."));
    keys.push_back(number_key("ice.torsion_strength_kPa", ice.torsion_strength, unit::kilopascal, criterion,
                              "the paper has none",
                              "Strength in torsion about the joint's axis; 0: no failure criterion."));
    keys.push_back(number_key("ice.in_plane_bending_strength_kPa", ice.in_plane_bending_strength, unit::kilopascal,
                              criterion, "the paper has none",
                              "Strength in bending about the vertical axis; 0: no failure criterion."));
    keys.push_back(number_key(
        "ice.elastic_modulus_MPa", ice.elastic_modulus, unit::megapascal, above(0).at_most(1e6), "Table 1",
        "E of the ice. With joint.model = \"beam\" joints get their stiffness from it. With \"cfm\" floes run finds "
        "the joint.cfm with which a sheet of this ice shows it; if joint.cfm is given as well, both have to agree "
        "within 5 % in a plate test; and if only joint.cfm is given, this E is what that test shows."));
    keys.push_back(late_key(number_key("ice.poisson_ratio", ice.poisson_ratio, unit::one, at_least(0).at_most(0.5),
                                       "usual for ice", "Poisson's ratio ν, with joint.model = \"beam\".")));
    keys.push_back(late_key(only_with(
        "joint.failure = \"stress\"", [&joint] { return joint.fails_by_stress(); },
        number_key("ice.fracture_energy_J_m2", ice.fracture_energy, unit::one, at_least(0).at_most(1e6),
                   "docs/fracture.md",
                   "Energy G_f that a crack takes per area. A joint at its strength softens until it has taken "
                   "this; 0: it loses all it carries at once. Below some 0.2 strength² thickness / E, 0.15 J/m² for "
                   "the tank's ice and 10 for sea ice of 1 m, the strength decides and it changes little."))));
}

void add_floe(Keys& keys, FloeShape& floe) {
    const Range size = above(0).at_most(1000);
    keys.push_back(
        number_key("floe.length_m", floe.length, unit::one, size, "Table 1", "Length of a floe along its own x."));
    keys.push_back(
        number_key("floe.breadth_m", floe.breadth, unit::one, size, "Table 1", "Breadth of a floe along its own z."));
    keys.push_back(number_key("floe.element_m", floe.element, unit::one, size, "Table 1",
                              "Side of a square of the area of an element. Floes break only between elements, so it is "
                              "the least size of their "
                              "pieces. Squares have to divide length and breadth."));
}

void add_elements(Keys& keys, Elements& elements, const Joint& joint) {
    const auto with_beams = late_with("joint.model = \"beam\"", [&joint] { return joint.model == JointModel::beam; });
    keys.push_back(with_beams(word_key(
        "floe.elements", elements.form, {"squares", "cells"}, "no load knows their direction; docs/fracture.md",
        "What floes are cut into. cells: of a centroidal Voronoi diagram, which have no direction. squares: a grid "
        "along "
        "the floe's sides, as in the paper; polygons have cells all the same. With joint.model = \"cfm\" they are "
        "squares.")));
    keys.push_back(
        with_beams(integer_key("floe.elements_draw", elements.draw, 0, 1'000'000, "the first",
                               "Number of the draw of the cells. Cases that differ in it alone have the same "
                               "floes cut in another way: what of the scatter is the cells'.")));
}

void add_joint(Keys& keys, Joint& joint) {
    const auto with_cfm = [&joint](Key key) {
        return only_with(
            "joint.model = \"cfm\"", [&joint] { return joint.model == JointModel::cfm; }, std::move(key));
    };
    const auto with_beams = late_with("joint.model = \"beam\"", [&joint] { return joint.model == JointModel::beam; });
    keys.push_back(with_cfm(number_key(
        "joint.cfm", joint.cfm, unit::one, above(0).below(1).because("at 1 and above the solver diverges"), "Table 1",
        "Constraint force mixing Σ of all six axes, Bullet's dimensionless number. A larger value gives softer ice. "
        "With general.solver = \"stock\" or \"lanes\" iterations leave the ice soft however small it is.")));
    keys.push_back(
        with_cfm(number_key("joint.erp", joint.erp, unit::one, above(0).at_most(1), "Table 1",
                            "Error reduction parameter Γ: the share of a joint's error corrected in each step. "
                            "Stiffness is proportional to it.")));
    keys.push_back(late_key(word_key(
        "joint.model", joint.model, {"cfm", "beam"}, "E as stated, whatever the elements; docs/fracture.md",
        "How stiff joints are. beam: an elastic beam from centre to centre, whose stiffness follows from "
        "ice.elastic_modulus_MPa, ice.poisson_ratio, element side and thickness; with general.solver = \"direct\" only "
        "(docs/fracture.md). cfm: by cfm and erp, together with element size, time step and iterations, as in the "
        "paper.")));
    keys.push_back(with_beams(word_key(
        "joint.failure", joint.failure, {"moment", "stress"}, "does not know the grid; docs/fracture.md",
        "What cracks a joint. stress: the largest principal tension in its outer fibres by bending, twist and thrust, "
        "with the peak below contacts that a grid of elements does not show, reaches ice.bending_strength_kPa; then it "
        "softens as ice.fracture_energy_J_m2 says. moment: its bending moment exceeds Eq. (3), and it is gone at once; "
        "fewer floes break, and how many depends on floe.element_m.")));
    keys.push_back(only_with(
        "joint.failure = \"stress\"", [&joint] { return joint.fails_by_stress(); },
        late_key(number_key("joint.averaging_s", joint.averaging, unit::one, at_least(0).at_most(10),
                            "docs/fracture.md",
                            "Time over which the stress at a joint is averaged before it meets the strength: blows "
                            "that are shorter crack by their mean alone, so that broken floes do not depend on the "
                            "time step. Rounded to whole steps, at least one. 0: a tenth of the square root of the "
                            "plate's characteristic length over g, 0.02 s for the tank's ice, 0.1 s at full "
                            "scale."))));
    keys.push_back(
        with_beams(number_key("joint.damping_ratio", joint.damping_ratio, unit::one, at_least(0).at_most(10),
                              "hardly matters: docs/fracture.md",
                              "Damping of joints: share of critical for two elements that swing against each other.")));
}

namespace {

Key contact_preset(ContactLaw& contact) {
    const WordField words{
        {"paper", "physical", "own"},
        [&contact] { return static_cast<std::size_t>(preset_of(contact)); },
        [&contact](std::size_t word) { contact = with_preset(contact, static_cast<ContactPreset>(word)); }};
    return preset_key(
        {"contact.preset", words, "docs/convergence.md",
         "Sets contact.friction, contact.law and paper.internal_edges together; those of them that are given "
         "as well are applied after it. physical: cone, crushing, false, with which no dependence of loads over 0.1 s "
         "and more on the time step shows (docs/convergence.md). paper: one_direction, rigid, true, which is what "
         "Bullet does by default and so probably the paper. own: leaves them as they are."});
}

/// How the friction of one kind of surfaces depends on the speed.
void add_slip_effect(Keys& keys, std::string_view law, std::string_view power, SlipEffect& effect,
                     std::string_view exponent, double& of, std::string_view source) {
    keys.push_back(late_key(word_key(
        law, effect, {slip_effect_words.begin(), slip_effect_words.end()}, "docs/convergence.md",
        "How this coefficient of friction depends on the speed of sliding; contact.friction_speed_m_s is the speed at "
        "which it is given (docs/convergence.md). constant: not at all. power: as a power of it. rate_and_state: by "
        "the logarithms of it and of the speed that the contact remembers. Not with solver stock.")));
    keys.push_back(only_with(
        power, [&effect] { return effect == SlipEffect::power; },
        late_key(number_key(exponent, of, unit::one, at_least(0).at_most(2), source,
                            "The coefficient falls as the speed to this power."))));
}

void add_slip_friction(Keys& keys, SlipFriction& slip) {
    add_slip_effect(keys, "contact.ice_ice_friction_law", "contact.ice_ice_friction_law = \"power\"", slip.ice_ice,
                    "contact.ice_ice_friction_exponent", slip.ice_ice_exponent, "polished ice: docs/convergence.md");
    add_slip_effect(keys, "contact.ice_structure_friction_law", "contact.ice_structure_friction_law = \"power\"",
                    slip.ice_structure, "contact.ice_structure_friction_exponent", slip.ice_structure_exponent,
                    "steel and concrete: docs/convergence.md");
    const auto of_any = late_with("a friction law other than \"constant\"", [&slip] {
        return slip.ice_ice != SlipEffect::constant || slip.ice_structure != SlipEffect::constant;
    });
    const auto of_state = late_with("a friction law \"rate_and_state\"", [&slip] {
        return slip.ice_ice == SlipEffect::rate_and_state || slip.ice_structure == SlipEffect::rate_and_state;
    });
    const auto add = [&](const auto& of, std::string_view path, double& field, Range range, std::string_view source,
                         std::string_view doc) {
        keys.push_back(of(number_key(path, field, unit::one, range, source, doc)));
    };
    add(of_any, "contact.friction_speed_m_s", slip.speed, above(0).at_most(100), "of the tests of hulls",
        "Speed of sliding at which the coefficients of friction are given.");
    add(of_any, "contact.least_friction", slip.least, at_least(0).at_most(10), "docs/convergence.md",
        "No coefficient that depends on the speed falls below this.");
    add(of_any, "contact.largest_friction", slip.largest, above(0).at_most(10), "docs/convergence.md",
        "No coefficient that depends on the speed rises above this; what sticks has it, or less.");
    add(of_state, "contact.friction_direct", slip.direct, at_least(0).at_most(10), "Lishman et al. 2011",
        "A: what e times the speed of sliding adds to the coefficient at once.");
    add(of_state, "contact.friction_evolution", slip.evolution, at_least(0).at_most(10), "Lishman et al. 2011",
        "B: what e times the remembered speed takes from it. Above A friction falls with the speed.");
    add(of_state, "contact.friction_memory_s", slip.memory, above(0).at_most(1e6), "Lishman et al. 2013",
        "Time in which a contact forgets how fast it slid.");
}

}  // namespace

void add_contact(Keys& keys, ContactLaw& contact) {
    const Range friction = at_least(0).at_most(10);
    keys.push_back(contact_preset(contact));
    keys.push_back(number_key("contact.erp", contact.erp, unit::one, at_least(0).at_most(1), "Bullet's default",
                              "Error reduction parameter Γ of contacts: the share of a penetration corrected in each "
                              "step. The load depends on it."));
    keys.push_back(number_key("contact.ice_ice_friction", contact.ice_ice_friction, unit::one, friction, "Table 1",
                              "Coefficient of friction between floes, and between floes and the fixed ice sheets."));
    keys.push_back(number_key("contact.ice_structure_friction", contact.ice_structure_friction, unit::one, friction,
                              "Table 1", "Coefficient of friction between ice and the structure."));
    keys.push_back(late_key(word_key(
        "contact.friction", contact.friction, {friction_words.begin(), friction_words.end()}, "docs/convergence.md",
        "Law of friction. one_direction: one row per contact along the sliding velocity, as in Bullet; a contact that "
        "sticks is not held across that row. cone: Coulomb's law in the whole contact plane, not with solver stock; "
        "higher loads and more broken floes (docs/convergence.md).")));
    keys.push_back(late_key(word_key(
        "contact.law", contact.normal, {normal_law_words.begin(), normal_law_words.end()}, "docs/convergence.md",
        "What bounds the force along the normal. rigid: nothing, so that a collision ends within one step and the "
        "largest load depends on the time step. crushing: ice yields at crushing_pressure_kPa over the area that the "
        "overlap opens and does not push back, not with solver stock; contact.erp and split impulse then have no "
        "effect (docs/convergence.md).")));
    keys.push_back(late_key(number_key(
        "contact.crushing_pressure_kPa", contact.crushing_pressure, unit::kilopascal, at_least(0).at_most(1e6),
        "the paper has none",
        "Pressure at which edges crush, with contact.law = \"crushing\"; 0: ice.compressive_strength_kPa. With a "
        "higher value contacts are stiffer and need shorter steps.")));
    add_slip_friction(keys, contact.slip);
}

// Keys of the table [paper]: what only a comparison with the paper needs.

namespace {

Key split_impulse(ContactLaw& contact) {
    constexpr double never = std::numeric_limits<double>::infinity();
    constexpr double deepest = 10;  // m
    NumberField depth{[&contact] { return contact.split_impulse ? contact.split_impulse_depth : never; },
                      [&contact](double value) {
                          contact.split_impulse = value < never;
                          contact.split_impulse_depth = value < never ? value : ContactLaw{}.split_impulse_depth;
                      },
                      unit::one, at_least(0).at_most(deepest).or_infinity()};
    return instead_of({switch_key("contact.split_impulse", contact.split_impulse, "", ""),
                       number_key("contact.split_impulse_depth_m", contact.split_impulse_depth, unit::one,
                                  at_least(0).at_most(deepest), "", "")},
                      {"paper.split_impulse_depth_m", std::move(depth), "Bullet's default",
                       "With rigid contacts: penetration depth from which a penetration is corrected without adding to "
                       "the velocity (Bullet's split impulse). With the default hardly any contact is that deep; inf: "
                       "none is corrected so."});
}

}  // namespace

void add_paper(Keys& keys, Scenario& scenario) {
    keys.push_back(formerly(
        "joint.threshold_form",
        word_key("paper.threshold_form", scenario.joint.threshold_form, {"force", "as_printed"}, "design decision",
                 "Failure thresholds of compression and shear. force: L_e T_e σ, a force. as_printed: L_e T_e² σ, Eqs. "
                 "(1)-(2) as printed in the paper, which has the unit of a moment and is the value of force times "
                 "T_e.")));
    keys.push_back(late_key(formerly(
        "joint.moment_about",
        word_key("paper.moment_about", scenario.joint.moment_about, {"pivot", "element_centre"}, "Eq. (3)",
                 "Point about which the bending moment of Eq. (3) is taken. pivot: the section that breaks. "
                 "element_centre: the centre of the joint's first element, about which Bullet reports a joint's "
                 "torque; this adds shear times half an element's side to the moment, and more floes break."))));
    keys.push_back(late_key(formerly(
        "water.form_drag_on",
        word_key("paper.form_drag_on", scenario.water.form_drag_on, {"outline", "every_element"},
                 "what meets the water",
                 "Edge faces that form drag acts on. outline: those of the floe, and of cracks. "
                 "every_element: those of each element, as if it were alone; a floe of 3 x 3 elements then "
                 "has three times the drag where water.shelter_draughts is 0; else the elements ahead shelter those "
                 "behind."))));
    keys.push_back(late_key(formerly(
        "contact.internal_edges",
        switch_key("paper.internal_edges", scenario.contact.internal_edges, "docs/convergence.md",
                   "Whether faces between the elements of a floe, and the rims at which pieces of the structure meet, "
                   "can be touched although they lie inside the body, as Bullet's can. false: nothing acts there, not "
                   "with solver stock."))));
    keys.push_back(split_impulse(scenario.contact));
}

namespace {

RowsField size_rows(Sizes& sizes) {
    const Range side = above(0).at_most(1000);
    return rows_of<ListedSize>(sizes.list,
                               {{{"length_m", unit::one, side}, &ListedSize::length},
                                {{"breadth_m", unit::one, side}, &ListedSize::breadth},
                                {{"share_percent", unit::percent, above(0).at_most(100)}, &ListedSize::share}});
}

/// The three keys of one property; paths and settings are literals because keys keep no words of their own.
struct SpreadWords {
    std::string_view law, cov, within, given, doc, source, why_cov;
};

void add_property(Keys& keys, Spread& spread, const SpreadWords& words) {
    const auto of_law = late_with(words.given, [&spread] { return spread.any(); });
    keys.push_back(late_key(word_key(words.law, spread.law, {"none", "normal", "lognormal", "weibull", "uniform"},
                                     words.source, words.doc)));
    keys.push_back(of_law(number_key(
        words.cov, spread.cov, unit::one, at_least(0.001).at_most(1), words.why_cov,
        "Standard deviation over mean of the law before it is cut off; the mean is what [ice] or [brine] says.")));
    keys.push_back(of_law(numbers_key(words.within, spread.within, unit::one, at_least(0.001).at_most(100),
                                      "3.75 default standard deviations or more",
                                      "Least and largest factor on the mean, at which the law is cut off.")));
}

}  // namespace

void add_sizes(Keys& keys, Sizes& sizes) {
    const Range size = above(0).at_most(1000);
    const auto law_is = [&sizes](auto... laws) { return [&sizes, laws...] { return ((sizes.law == laws) || ...); }; };
    const auto drawn =
        late_with("sizes.law = \"lognormal\" or \"power_law\"", law_is(SizeLaw::lognormal, SizeLaw::power_law));
    const auto lognormal = late_with("sizes.law = \"lognormal\"", law_is(SizeLaw::lognormal));
    const auto mixed =
        late_with("a sizes.law other than \"one\"", law_is(SizeLaw::list, SizeLaw::lognormal, SizeLaw::power_law));
    keys.push_back(late_key(word_key(
        "sizes.law", sizes.law, {"one", "list", "lognormal", "power_law"}, "the paper: one size",
        "Sizes of the floes, docs/sea_ice.md. one: all as [floe] says. list: those of list_m in their shares. "
        "lognormal and power_law: spread evenly over the law, from smallest_m to largest_m, so that every "
        "arrangement has the same floes and covers the same area. Squares (floe.elements) round sides to whole "
        "elements.")));
    keys.push_back(mixed(word_key("sizes.by", sizes.by, {"number", "area"}, "as densities of floes are published",
                                  "What the shares, or the density, of the law are of: the number of floes, or the "
                                  "area that floes of a size cover.")));
    keys.push_back(late_key(
        only_with("sizes.law = \"list\"", law_is(SizeLaw::list),
                  {"sizes.list_m", size_rows(sizes), "none",
                   "Sizes with their shares, which sum to 100 %: [[length_m, breadth_m, share_percent], ...]."})));
    keys.push_back(drawn(number_key("sizes.smallest_m", sizes.smallest, unit::one, size, "two elements of Table 1",
                                    "Least D, the side of the square with the floe's area.")));
    keys.push_back(drawn(
        number_key("sizes.largest_m", sizes.largest, unit::one, size, "twice the floe of Table 1", "Largest D.")));
    keys.push_back(lognormal(
        number_key("sizes.mean_m", sizes.mean, unit::one, size, "Table 1", "Mean D of the law before it is cut off.")));
    keys.push_back(
        lognormal(number_key("sizes.cov", sizes.cov, unit::one, at_least(0.001).at_most(2), "an example; give your own",
                             "Standard deviation of D over its mean before the law is cut off.")));
    keys.push_back(late_key(only_with(
        "sizes.law = \"power_law\"", law_is(SizeLaw::power_law),
        number_key("sizes.exponent", sizes.exponent, unit::one, at_least(0).at_most(10), "docs/sea_ice.md",
                   "The density of floes (or of area, with by = \"area\") is in proportion to D^-exponent. Natural "
                   "floes have some 2.3 to 3.1 by number."))));
    keys.push_back(drawn(number_key("sizes.ratio_lowest", sizes.least_ratio, unit::one, at_least(1).at_most(20),
                                    "squares", "Least length over breadth of a floe.")));
    keys.push_back(
        drawn(number_key("sizes.ratio_highest", sizes.largest_ratio, unit::one, at_least(1).at_most(20), "squares",
                         "Largest length over breadth; ratios are spread evenly between the two, whatever "
                         "the size.")));
    keys.push_back(mixed(word_key(
        "sizes.element", sizes.element, {"given", "of_floe", "of_ice"}, "Table 1: one element",
        "Side of the elements. given: floe.element_m. of_floe: the floe's shorter side over elements_across. of_ice: "
        "element_share of the characteristic length that a sheet of [ice] has on water.")));
    keys.push_back(late_key(only_with(
        "sizes.element = \"of_floe\"", [&sizes] { return sizes.element == ElementSide::of_floe; },
        integer_key("sizes.elements_across", sizes.elements_across, 1, 1000, "Table 1: 0.6 m by 0.2 m",
                    "Elements along the shorter side of every floe. A large floe then has few large elements."))));
    keys.push_back(late_key(only_with(
        "sizes.element = \"of_ice\"", [&sizes] { return sizes.element == ElementSide::of_ice; },
        number_key("sizes.element_share", sizes.element_share, unit::one, at_least(0.001).at_most(10),
                   "in the range of docs/fracture.md",
                   "Side of the elements over the characteristic length of the ice; well below 1, or elements are "
                   "too large to show where ice bends."))));
}

void add_spread(Keys& keys, IceSpread& spread) {
    add_property(keys, spread.thickness,
                 {"spread.thickness", "spread.thickness_cov", "spread.thickness_within",
                  "a spread.thickness other than \"none\"",
                  "Law of the floes' thicknesses about ice.thickness_m. Each floe has one draw, from a stream of its "
                  "own: it changes neither the arrangement nor any other draw.",
                  "the paper: one thickness", "an example; give your own"});
    add_property(
        keys, spread.strength,
        {"spread.strength", "spread.strength_cov", "spread.strength_within", "a spread.strength other than \"none\"",
         "Law of the floes' strengths: one factor on all strengths of [ice] together.", "the paper: one strength",
         "0.2 to 0.3: docs/sea_ice.md, from memory"});
    add_property(keys, spread.elastic_modulus,
                 {"spread.elastic_modulus", "spread.elastic_modulus_cov", "spread.elastic_modulus_within",
                  "a spread.elastic_modulus other than \"none\"",
                  "Law of the floes' moduli about ice.elastic_modulus_MPa, with joint.model = \"beam\".",
                  "the paper: one modulus", "an example; give your own"});
    add_property(keys, spread.density,
                 {"spread.density", "spread.density_cov", "spread.density_within",
                  "a spread.density other than \"none\"", "Law of the floes' densities about ice.density_kg_m3.",
                  "the paper: one density", "an example; give your own"});
    add_property(
        keys, spread.salinity,
        {"spread.salinity", "spread.salinity_cov", "spread.salinity_within", "a spread.salinity other than \"none\"",
         "Law of the floes' salinities about brine.salinity_ppt.", "none", "an example; give your own"});
    add_property(keys, spread.temperature,
                 {"spread.temperature", "spread.temperature_cov", "spread.temperature_within",
                  "a spread.temperature other than \"none\"",
                  "Law of the floes' temperatures about brine.temperature_C: a factor on degrees below 0.", "none",
                  "an example; give your own"});
    keys.push_back(late_key(only_with(
        "spread.thickness and spread.strength", [&spread] { return spread.thickness.any() && spread.strength.any(); },
        number_key("spread.correlation", spread.correlation, unit::one, at_least(-1).at_most(1), "independent",
                   "Correlation ρ of thickness and strength: of the two normal variables behind them (Gaussian "
                   "copula). Their ranks then correlate by 6/π asin(ρ/2)."))));
    keys.push_back(late_key(number_key(
        "spread.length_m", spread.length, unit::one, at_least(0).at_most(1e4), "none: one ice a floe",
        "arrangement.method level: spread.thickness, spread.strength and spread.elastic_modulus are laws of a random "
        "field within the sheet, whose normal variables correlate by exp(-r²/(2 a²)) at a distance r, a this length. "
        "Joints have the thickness, strength and modulus of their place; weight and draught are of one thickness. 0: "
        "one factor for the whole sheet.")));
    keys.push_back(late_key(number_key(
        "spread.weakened_percent", spread.weakened, unit::percent, at_least(0).at_most(100), "the paper: none",
        "Share of the floes that are weaker than the others, as floes that were cut, thawed or cracked before. Each "
        "floe has one draw, from a stream of its own.")));
    keys.push_back(late_key(only_with(
        "spread.weakened_percent > 0", [&spread] { return spread.weakened > 0; },
        number_key("spread.weakened_to", spread.weakened_to, unit::one, above(0).at_most(1),
                   "an example: measure yours", "Factor on all strengths of the weaker floes."))));
    keys.push_back(late_key(only_with(
        "a law in [spread]", [&spread] { return spread.any(); },
        integer_key("spread.draw", spread.draw, 0, 1'000'000, "the first",
                    "Number of the draw. Cases that differ in it alone have the same floes in the same places, of "
                    "other ice: what of the scatter is the ice's."))));
}

void add_brine(Keys& keys, Brine& brine) {
    keys.push_back(late_key(number_key(
        "brine.salinity_ppt", brine.salinity, 1e-3, at_least(0).at_most(35), "none: [ice] says the strengths",
        "Salinity of the ice. Above 0 bending strength and modulus follow from it and the temperature (docs/sea_ice.md)"
        ", and the other strengths keep their ratios to ice.bending_strength_kPa. At full scale only.")));
    keys.push_back(late_key(only_with(
        "brine.salinity_ppt > 0", [&brine] { return brine.salinity > 0; },
        number_key("brine.temperature_C", brine.temperature, unit::one, at_least(-22.9).at_most(-0.5),
                   "docs/sea_ice.md", "Temperature of the ice, within what its formula is for."))));
}

}  // namespace floes
