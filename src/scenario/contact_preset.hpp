#pragma once
// Sets of contact laws that belong together, docs/contact.md.

#include <array>
#include <initializer_list>
#include <string_view>

#include "solver/contact_law.hpp"

namespace floes {

enum class ContactPreset {
    paper,     ///< what Bullet does by default: friction in one direction, rigid contacts, internal edges act
    physical,  ///< friction in the whole contact plane, edges that crush, internal edges do not act
    own        ///< anything else
};

/// The words of the enumerations, in order, for keys, files and reports.
inline constexpr std::array<std::string_view, 3> preset_words{"paper", "physical", "own"};
inline constexpr std::array<std::string_view, 2> friction_words{"one_direction", "cone"};
inline constexpr std::array<std::string_view, 2> normal_law_words{"rigid", "crushing"};

/// The law with the choices of the preset; unchanged for `own`.
constexpr ContactLaw with_preset(ContactLaw law, ContactPreset preset) {
    if (preset == ContactPreset::own) return law;
    const bool physical = preset == ContactPreset::physical;
    law.friction = physical ? Friction::cone : Friction::one_direction;
    law.normal = physical ? NormalLaw::crushing : NormalLaw::rigid;
    law.internal_edges = !physical;
    return law;
}

constexpr ContactPreset preset_of(const ContactLaw& law) {
    for (const ContactPreset preset : {ContactPreset::paper, ContactPreset::physical}) {
        if (with_preset(law, preset) == law) return preset;
    }
    return ContactPreset::own;
}

}  // namespace floes
