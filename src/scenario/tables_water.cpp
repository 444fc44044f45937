// Keys of the tables [water] and [wind].

#include "scenario/tables.hpp"

namespace floes {

void add_water(Keys& keys, Water& water) {
    const Range coefficient = at_least(0).at_most(100);
    keys.push_back(number_key("water.density_kg_m3", water.density, unit::one, above(0).at_most(5000), "Table 1",
                              "Density of water."));
    keys.push_back(word_key(
        "water.flow", water.flow, {"potential", "still"}, "design; the paper: a simple flow around the structure",
        "Water velocity for the drag: potential flow round the moving waterline circle, or water at rest."));
    keys.push_back(number_key(
        "water.form_drag", water.form_drag, unit::one, coefficient, "Su, Aarsæther and Kristiansen 2019; others 0.5",
        "Form drag coefficient on the wetted edge faces of a floe. It carries floes round the structure."));
    keys.push_back(number_key("water.skin_drag", water.skin_drag, unit::one, coefficient,
                              "laminar plate, 1.328 / sqrt(Re) at Re 2.3e4; others 0.002 to 0.01",
                              "Skin drag coefficient on the bottom face."));
    keys.push_back(number_key("water.heave_drag", water.heave_drag, unit::one, coefficient, "bluff plate, DNV-RP-C205",
                              "Quadratic drag coefficient on vertical motion."));
    const auto damped_by_share = [&water] { return water.heave_damping_from == WaterFrom::share; };
    const auto mass_by_share = [&water] { return water.added_mass_from == WaterFrom::share; };
    keys.push_back(late_key(word_key(
        "water.heave_damping_from", water.heave_damping_from, {"share", "outline"},
        "closed form, docs/water.md; ice under water makes no waves",
        "Damping by waves. outline: what a plate of the outline of each connected piece radiates as it heaves, on "
        "ice that cuts the surface. share: water.heave_damping of each element by itself, under water too.")));
    keys.push_back(only_with("water.heave_damping_from = \"share\"", damped_by_share,
                             number_key("water.heave_damping", water.heave_damping, unit::one, at_least(0).at_most(1),
                                        "the paper's preset; usual 0.1 to 0.2",
                                        "Linear damping of vertical motion, as a share of an element's critical "
                                        "damping.")));
    keys.push_back(late_key(word_key(
        "water.added_mass_from", water.added_mass_from, {"share", "outline"}, "closed form, docs/water.md",
        "Water that moves with the ice. outline: in heave, roll and pitch that of a plate of the outline of each "
        "connected piece, 5 times the mass of the tank's floes; with solver direct only. share: water.added_mass in "
        "every direction.")));
    keys.push_back(only_with(
        "water.added_mass_from = \"share\"", mass_by_share,
        number_key("water.added_mass", water.added_mass, unit::one, coefficient, "none, as in the paper's preset",
                   "Added mass: mass of water that moves with an element, equal in all directions, as a "
                   "share of the element's own mass. The stiffness of joints that follow Σ is proportional to the "
                   "total mass (see [joint]), so another value needs another cfm.")));
    keys.push_back(late_key(only_with(
        "water.added_mass_from = \"outline\"", [mass_by_share] { return !mass_by_share(); },
        number_key("water.added_mass_in_plane", water.added_mass_in_plane, unit::one, coefficient,
                   "between 0.04 for fast and 0.18 for slow motion of the tank's floes, docs/water.md",
                   "Added mass along the surface and in yaw, as a share of the ice's mass."))));
    const Range angle = at_least(-360).at_most(360);
    keys.push_back(late_key(number_key("water.current_m_s", water.current, unit::one, at_least(0).at_most(100), "none",
                                       "Speed of the current. Floes drift with it from the start; the flow past the "
                                       "structure is that of the tow relative to it.")));
    keys.push_back(late_key(only_with(
        "water.current_m_s > 0", [&water] { return water.current > 0; },
        number_key("water.current_direction_deg", water.current_direction, unit::degree, angle, "along the tow",
                   "Direction towards which the current flows: 0 along the tow, 90 towards +z."))));
    keys.push_back(late_key(
        number_key("water.turning_deg", water.turning, unit::degree, at_least(-90).at_most(90),
                   "none in a tank; at sea 20 to 25 (Leppäranta, The Drift of Sea Ice, 2011, chapter 5)",
                   "Turning angle of the boundary layer below the ice: the water's skin drag is turned by it "
                   "from the water's motion relative to the ice, anticlockwise from above (northern hemisphere).")));
}

void add_wind(Keys& keys, Wind& wind) {
    const auto blows = [&wind] { return wind.speed > 0; };
    const std::string_view needs = "wind.speed_m_s > 0";
    keys.push_back(late_key(number_key("wind.speed_m_s", wind.speed, unit::one, at_least(0).at_most(100), "none",
                                       "Speed of the wind. Its stress on ice above the water is ρ_a C_a U².")));
    keys.push_back(late_key(only_with(
        needs, blows,
        number_key("wind.direction_deg", wind.direction, unit::degree, at_least(-360).at_most(360), "along the tow",
                   "Direction towards which the wind blows: 0 along the tow, 90 towards +z."))));
    keys.push_back(late_key(
        only_with(needs, blows,
                  number_key("wind.drag", wind.drag, unit::one, at_least(0).at_most(1),
                             "1e-3 to 2e-3 for the wind at 10 m (Leppäranta, The Drift of Sea Ice, 2011, chapter 5)",
                             "Drag coefficient C_a of the air on the ice."))));
    keys.push_back(late_key(only_with(needs, blows,
                                      number_key("wind.air_density_kg_m3", wind.air_density, unit::one,
                                                 above(0).at_most(10), "cold air", "Density of the air."))));
}

}  // namespace floes
