#pragma once
// The keys of each table of a scenario; describe() strings them together.

#include "keys/key.hpp"
#include "scenario/scenario.hpp"

namespace floes {

void add_general(Keys& keys, General& general);
void add_ice(Keys& keys, FloeShape& floe, Ice& ice, const Joint& joint);
void add_floe(Keys& keys, FloeShape& floe);
void add_elements(Keys& keys, Elements& elements, const Joint& joint);
void add_joint(Keys& keys, Joint& joint);
void add_field(Keys& keys, Field& field);
void add_arrangement(Keys& keys, ArrangementRule& arrangement);
void add_structure(Keys& keys, Structure& structure);
void add_hull(Keys& keys, Structure& structure);
void add_path(Keys& keys, Path& path);
void add_moorings(Keys& keys, Moorings& moorings);
void add_contact(Keys& keys, ContactLaw& contact);
void add_water(Keys& keys, Water& water);
void add_wind(Keys& keys, Wind& wind);
void add_analysis(Keys& keys, Analysis& analysis);
void add_sizes(Keys& keys, Sizes& sizes);
void add_shapes(Keys& keys, Shapes& shapes);
void add_spread(Keys& keys, IceSpread& spread);
void add_brine(Keys& keys, Brine& brine);
void add_paper(Keys& keys, Scenario& scenario);

}  // namespace floes
