// Keys of the table [paper]: what only a comparison with the paper needs.

#include <limits>

#include "keys/former.hpp"
#include "scenario/tables.hpp"

namespace floes {
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
    keys.push_back(late_key(
        formerly("water.form_drag_on",
                 word_key("paper.form_drag_on", scenario.water.form_drag_on, {"outline", "every_element"},
                          "what meets the water",
                          "Edge faces that form drag acts on. outline: those of the floe, and of cracks. "
                          "every_element: those of each element, as if it were alone; a floe of 3 x 3 elements then "
                          "has three times the drag."))));
    keys.push_back(late_key(formerly(
        "contact.internal_edges",
        switch_key("paper.internal_edges", scenario.contact.internal_edges, "docs/convergence.md",
                   "Whether faces between the elements of a floe, and the rims at which pieces of the structure meet, "
                   "can be touched although they lie inside the body, as Bullet's can. false: nothing acts there, not "
                   "with solver stock."))));
    keys.push_back(split_impulse(scenario.contact));
}

}  // namespace floes
