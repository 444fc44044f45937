#pragma once
// What a campaign file keeps of single floes where they differ.

#include <array>
#include <vector>

#include "scenario/floes.hpp"

namespace floes {

struct FloeProperty {
    const char* name;
    double (*of)(const FloeShape&, const Material&);  ///< SI
};

inline constexpr std::array floe_properties{
    FloeProperty{"length", [](const FloeShape& shape, const Material&) { return shape.length; }},
    FloeProperty{"breadth", [](const FloeShape& shape, const Material&) { return shape.breadth; }},
    FloeProperty{"thickness", [](const FloeShape& shape, const Material&) { return shape.thickness; }},
    FloeProperty{"element", [](const FloeShape& shape, const Material&) { return shape.element; }},
    FloeProperty{"density", [](const FloeShape&, const Material& of) { return of.ice.density; }},
    FloeProperty{"elastic_modulus", [](const FloeShape&, const Material& of) { return of.ice.elastic_modulus; }},
    FloeProperty{"bending_strength", [](const FloeShape&, const Material& of) { return of.ice.bending_strength; }},
    FloeProperty{"compressive_strength",
                 [](const FloeShape&, const Material& of) { return of.ice.compressive_strength; }},
    FloeProperty{"shear_strength", [](const FloeShape&, const Material& of) { return of.ice.shear_strength; }},
};

/// A row for each floe, in the order of the list.
std::vector<double> properties_of(const FloeSet& floes);

}  // namespace floes
