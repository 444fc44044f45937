// Keys of the tables [general], [ice], [floe], [joint], [contact]: Table 1 and the solver.

#include "scenario/contact_preset.hpp"
#include "scenario/tables.hpp"

namespace floes {

void add_general(Keys& keys, General& general) {
    keys.push_back(
        number_key("general.time_step_s", general.time_step, unit::one, above(0).at_most(1), "Table 1",
                   "Time step. With joint.model = \"cfm\" the stiffness of joints is proportional to its inverse "
                   "square (see [joint]), so another time step gives other ice."));
    keys.push_back(integer_key(
        "general.iterations", general.iterations, 1, 100000, "docs/convergence.md",
        "Projected Gauss-Seidel sweeps per step. With solver direct they are over contacts only, and 20 are enough. "
        "With the others more sweeps make ice of small cfm stiffer: at cfm 1e-10 a sheet shows 37, 207 and 421 MPa at "
        "10, 50 and 100 sweeps; the paper's figures need 50."));
    keys.push_back(word_key(
        "general.solver", general.solver, {"stock", "lanes", "direct"}, "E as stated, without a ceiling; docs/ice.md",
        "Constraint solver: direct solves all joints of a floe exactly, so that only contacts need "
        "iterations (docs/ice.md). lanes sweeps over joints and contacts, with many floes at once, one per "
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
        "within "
        "5 % in a plate test; and if only joint.cfm is given, this E is what that test shows."));
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
    keys.push_back(number_key(
        "floe.element_m", floe.element, unit::one, size, "Table 1",
        "Side of the square elements; must divide length and breadth. Floes break only along the grid of elements."));
}

void add_joint(Keys& keys, Joint& joint) {
    const auto with_cfm = [&joint](Key key) {
        return only_with(
            "joint.model = \"cfm\"", [&joint] { return joint.model == JointModel::cfm; }, std::move(key));
    };
    const auto with_beams = [&joint](Key key) {
        return only_with(
            "joint.model = \"beam\"", [&joint] { return joint.model == JointModel::beam; }, std::move(key));
    };
    keys.push_back(with_cfm(number_key(
        "joint.cfm", joint.cfm, unit::one, above(0).below(1).because("at 1 and above the solver diverges"), "Table 1",
        "Constraint force mixing Σ of all six axes, Bullet's dimensionless number. A larger value gives softer ice. "
        "With "
        "general.solver = \"stock\" or \"lanes\" iterations leave the ice soft however small it is.")));
    keys.push_back(
        with_cfm(number_key("joint.erp", joint.erp, unit::one, above(0).at_most(1), "Table 1",
                            "Error reduction parameter Γ: the share of a joint's error corrected in each step. "
                            "Stiffness is proportional to it.")));
    keys.push_back(late_key(word_key(
        "joint.model", joint.model, {"cfm", "beam"}, "E as stated, whatever the elements; docs/ice.md",
        "How stiff joints are. beam: an elastic beam from centre to centre, whose stiffness follows from "
        "ice.elastic_modulus_MPa, ice.poisson_ratio, element side and thickness; with general.solver = \"direct\" only "
        "(docs/ice.md). cfm: by cfm and erp, together with element size, time step and iterations, as in the paper.")));
    keys.push_back(with_beams(late_key(word_key(
        "joint.failure", joint.failure, {"moment", "stress"}, "does not know the grid; docs/fracture.md",
        "What cracks a joint. stress: the largest principal tension in its outer fibres by bending, twist and thrust, "
        "with the peak below contacts that a grid of elements does not show, reaches ice.bending_strength_kPa; then it "
        "softens as ice.fracture_energy_J_m2 says. moment: its bending moment exceeds Eq. (3), and it is gone at once; "
        "fewer floes break, and how many depends on floe.element_m."))));
    keys.push_back(with_beams(late_key(number_key(
        "joint.damping_ratio", joint.damping_ratio, unit::one, at_least(0).at_most(10), "hardly matters: docs/ice.md",
        "Damping of joints: share of critical for two elements that swing against each other."))));
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
         "as well are applied after it. physical: cone, crushing, false, with which the largest loads do not depend "
         "on the time step (docs/convergence.md). paper: one_direction, rigid, true, which is what Bullet does by "
         "default and so probably the paper. own: leaves them as they are."});
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
        "higher loads and more broken floes (docs/contact.md).")));
    keys.push_back(late_key(word_key(
        "contact.law", contact.normal, {normal_law_words.begin(), normal_law_words.end()}, "docs/convergence.md",
        "What bounds the force along the normal. rigid: nothing, so that a collision ends within one step and the "
        "largest load depends on the time step. crushing: ice yields at crushing_pressure_kPa over the area that the "
        "overlap opens and does not push back, not with solver stock; contact.erp and split impulse then have no "
        "effect (docs/contact.md).")));
    keys.push_back(late_key(number_key(
        "contact.crushing_pressure_kPa", contact.crushing_pressure, unit::kilopascal, at_least(0).at_most(1e6),
        "the paper has none",
        "Pressure at which edges crush, with contact.law = \"crushing\"; 0: ice.compressive_strength_kPa. With a "
        "higher value contacts are stiffer and need shorter steps.")));
}

}  // namespace floes
