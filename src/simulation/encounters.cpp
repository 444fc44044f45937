#include "simulation/encounters.hpp"

#include <algorithm>

namespace floes {

void Encounters::meet(std::span<const ContactForce> contacts, const IceField& ice) {
    if (met_.size() < static_cast<std::size_t>(ice.places())) met_.resize(static_cast<std::size_t>(ice.places()));
    for (const ContactForce& contact : contacts) {
        for (const BodyId body : {contact.a, contact.b}) {
            if (const auto element = ice.element_of(body))
                met_[static_cast<std::size_t>(ice.elements()[*element].floe)] = 1;
        }
    }
}

void Encounters::leave(int place, const IceField& ice) {
    if (!has_met(place)) return;
    ++left_met_;
    left_broken_ += ice.is_broken(place) ? 1 : 0;
    met_[static_cast<std::size_t>(place)] = 0;
}

bool Encounters::has_met(int place) const {
    return static_cast<std::size_t>(place) < met_.size() && met_[static_cast<std::size_t>(place)] != 0;
}

int Encounters::met(const IceField& ice) const {
    int found = left_met_;
    for (int place = 0; place < ice.places(); ++place) found += ice.is_there(place) && has_met(place) ? 1 : 0;
    return found;
}

int Encounters::met_broken(const IceField& ice) const {
    int found = left_broken_;
    for (int place = 0; place < ice.places(); ++place)
        found += ice.is_there(place) && has_met(place) && ice.is_broken(place) ? 1 : 0;
    return found;
}

}  // namespace floes
