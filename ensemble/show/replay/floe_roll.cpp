#include "replay/floe_roll.hpp"

#include <algorithm>
#include <utility>

namespace floes {

std::size_t FloeRoll::index_of(int number) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(numbers_, number) - numbers_.begin());
}

void FloeRoll::enter(const Simulation& run, Frame& frame) {
    const IceField& ice = run.ice();
    std::vector<std::pair<int, int>> there;  // number, place
    for (int place = 0; place < ice.places(); ++place)
        if (ice.is_there(place)) there.emplace_back(ice.number_of(place), place);
    std::ranges::sort(there);

    constexpr int gone = -1;
    std::vector<int> ids(frame.elements.size(), gone);  // by the run's index
    std::vector<std::size_t> shown;                     // those of the run, in the order of the record
    for (const auto& [number, place] : there) {
        // Floes enter in the order of their numbers, so one that no frame has shown is behind all that one has.
        if (numbers_.empty() || number > numbers_.back()) {
            numbers_.push_back(number);
            floes_.push_back(run.laid(place));
            first_element_.push_back(elements_);
            elements_ += ice.elements(place);
        }
        const int first = first_element_[index_of(number)];
        for (int k = 0; k < ice.elements(place); ++k) {
            shown.push_back(static_cast<std::size_t>(ice.first_element(place) + k));
            ids[shown.back()] = first + k;
        }
    }

    const auto id = [&](int element) { return ids[static_cast<std::size_t>(element)]; };
    const Frame whole = frame;
    frame.elements.clear();
    frame.pieces.clear();
    frame.utilisation.clear();
    frame.ids.clear();
    for (const std::size_t k : shown) {
        frame.elements.push_back(whole.elements[k]);
        frame.pieces.push_back(id(whole.pieces[k]));
        frame.utilisation.push_back(whole.utilisation[k]);
        frame.ids.push_back(ids[k]);
    }
    for (FrameContact& contact : frame.contacts) {
        contact.element = id(contact.element);
        if (contact.other >= 0) contact.other = id(contact.other);
    }
}

std::vector<BreakEvent> FloeRoll::breaks(const std::vector<BreakEvent>& of_run) const {
    std::vector<BreakEvent> found;
    for (BreakEvent event : of_run) {
        const std::size_t index = index_of(event.floe);
        if (index == numbers_.size() || numbers_[index] != event.floe) continue;
        event.floe = static_cast<int>(index);
        found.push_back(event);
    }
    return found;
}

}  // namespace floes
