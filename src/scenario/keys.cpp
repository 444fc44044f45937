#include "scenario/keys.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "keys/key.hpp"
#include "scenario/tables.hpp"

namespace floes {
namespace {

/// The values that late keys had before they came, by the paths of 1.0.0.
std::map<std::string_view, std::string> late_texts() {
    Scenario scenario = paper_scenario();
    std::map<std::string_view, std::string> texts;
    for (const Key& key : keys_of_digest(describe(scenario)))
        if (key.late) texts.emplace(key.path, exact_text(key));
    return texts;
}

/// The keys of two scenarios that have an effect in one of them, in the same order.
std::pair<Keys, Keys> effective_keys(Scenario& there, Scenario& here) {
    std::pair<Keys, Keys> found;
    const Keys all_there = describe(there);
    const Keys all_here = describe(here);
    for (std::size_t k = 0; k < all_there.size(); ++k) {
        if (all_there[k].idle() && all_here[k].idle()) continue;
        found.first.push_back(all_there[k]);
        found.second.push_back(all_here[k]);
    }
    return found;
}

}  // namespace

Keys describe(Scenario& scenario) {
    Keys keys;
    keys.reserve(190);
    add_general(keys, scenario.general);
    add_ice(keys, scenario.floe, scenario.ice, scenario.joint);
    add_floe(keys, scenario.floe);
    add_elements(keys, scenario.elements, scenario.joint);
    add_sizes(keys, scenario.sizes);
    add_shapes(keys, scenario.shapes);
    add_spread(keys, scenario.spread);
    add_brine(keys, scenario.brine);
    add_joint(keys, scenario.joint);
    add_field(keys, scenario.field);
    add_arrangement(keys, scenario.arrangement);
    add_structure(keys, scenario.structure);
    add_hull(keys, scenario.structure);
    add_path(keys, scenario.path);
    add_moorings(keys, scenario.moorings);
    add_contact(keys, scenario.contact);
    add_water(keys, scenario.water);
    add_wind(keys, scenario.wind);
    add_analysis(keys, scenario.analysis);
    add_paper(keys, scenario);
    return keys;
}

TableTitles scenario_titles() {
    return {
        {"general", "Time stepping and the constraint solver."},
        {"ice", "Material properties of the ice."},
        {"floe", "One floe: a sheet of elements joined where they share an edge."},
        {"sizes", "Sizes of floes that differ."},
        {"shapes", "Floes that are no rectangles."},
        {"spread", "Properties that differ from floe to floe: each a law of the factor on what [ice] or [brine] says."},
        {"brine", "Where bending strength and modulus come from, if not from [ice]."},
        {"joint",
         "The joints between elements. Eqs. (4)-(5) as printed in the paper do not give the stiffness that Bullet "
         "derives from these numbers. In Bullet K = erp / (time_step² cfm A) for each row of a joint, where A is the "
         "inverse of the row's effective mass, so the stiffness depends on mass and time step."},
        {"field",
         "The channel and the ice field in it. The length of the field follows from the number and size of the floes "
         "and the concentration."},
        {"arrangement", "How the initial positions of the floes are generated."},
        {"structure", "The towed structure. Its wall and the far end of the channel decide the load."},
        {"hull",
         "The shape of the structure, where it is no body of revolution by structure.profile_m (structures.md). Ahead "
         "is "
         "+x, starboard +z; the axis is in the middle of the waterline's length."},
        {"path", "Where the structure goes, or the ice drifts, if not straight on at structure.speed_m_s."},
        {"moorings",
         "What holds a structure that gives way to the ice. Its anchors are towed, which is the same as ice that "
         "drifts past them; docs/moorings.md."},
        {"contact",
         "Contacts between floes, and between ice and the structure. The coefficient of restitution is 0 (Table 1) and "
         "not a key."},
        {"water", "Buoyancy and drag, which act on each element."},
        {"wind", "The wind, which acts on ice above the water."},
        {"analysis", "The window in which the load is measured; the run ends with it."},
        {"paper",
         "What only a comparison with the paper needs: other readings of its equations, and what Bullet does by "
         "default."},
    };
}

Scenario paper_scenario() {
    Scenario scenario;
    scenario.general.iterations = 50;
    scenario.general.solver = SolverKind::lanes;
    scenario.general.tolerance = 0;
    scenario.elements.form = ElementForm::squares;
    scenario.joint.model = JointModel::cfm;
    scenario.joint.failure = JointFailure::moment;
    scenario.contact = with_preset(scenario.contact, ContactPreset::paper);
    scenario.water.heave_damping_from = WaterFrom::share;
    scenario.water.added_mass_from = WaterFrom::share;
    scenario.water.shelter_draughts = 0;
    return scenario;
}

bool is_superfluous(const Key& key) {
    static const std::map<std::string_view, std::string> usual = [] {
        Scenario scenario;  // keys that another one leaves without effect have the paper's values there, too
        std::map<std::string_view, std::string> texts;
        for (const Key& one : describe(scenario))
            if (one.in_force) texts.emplace(one.path, exact_text(one));
        return texts;
    }();
    return key.idle() && exact_text(key) == usual.at(key.path);
}

// A late key is left out where it has the value of before, so that members stored before it came keep their digest; and
// where it has no effect, because a text that is silent about it may give it another value.
std::string canonical_text(const Scenario& scenario) {
    static const std::map<std::string_view, std::string> before = late_texts();
    Scenario copy = scenario;
    Keys keys = keys_of_digest(describe(copy));
    std::erase_if(keys,
                  [](const Key& key) { return key.late && (key.idle() || exact_text(key) == before.at(key.path)); });
    return canonical_text(keys);
}

std::vector<std::string> differences(const Scenario& there, const Scenario& here) {
    Scenario one = there;
    Scenario other = here;
    const auto [of_one, of_other] = effective_keys(one, other);
    return key_differences(of_one, of_other);
}

std::vector<std::string> differing_keys(const Scenario& there, const Scenario& here) {
    Scenario one = there;
    Scenario other = here;
    const auto [of_one, of_other] = effective_keys(one, other);
    std::vector<std::string> paths;
    for (std::size_t k = 0; k < of_one.size(); ++k)
        if (!of_other[k].derived() && exact_text(of_one[k]) != exact_text(of_other[k]))
            paths.emplace_back(of_other[k].path);
    return paths;
}

std::string given(const Scenario& scenario, const std::string& path) {
    Scenario copy = scenario;
    const Keys keys = describe(copy);
    return fmt::format("{} = {}", path, literal(*find_key(keys, path)));
}

}  // namespace floes
