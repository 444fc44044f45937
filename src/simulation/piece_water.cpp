#include "simulation/piece_water.hpp"

namespace floes {

PieceWater::PieceWater(const Scenario& scenario, const FloeSet& floes)
    : body_{scenario.water.density, scenario.general.gravity, scenario.water.added_mass_in_plane},
      carries_(scenario.water.added_mass_from == WaterFrom::outline),
      radiates_(scenario.water.heave_damping_from == WaterFrom::outline) {
    carried_.resize(static_cast<std::size_t>(element_count(floes)));
    for (std::size_t i = 0; i < floes.size(); ++i)
        draught_.push_back(floes.shape(i).thickness * floes.material(i).ice.density / scenario.water.density);
}

void PieceWater::share_out(int floe, const IceField& ice, World& world, WaterLanes& water) {
    if (!carries_ && !radiates_) return;
    const FloeGrid& grid = ice.grid(floe);
    const int first = ice.first_element(floe);
    const auto element = [&](int index) -> const IceElement& {
        return ice.elements()[static_cast<std::size_t>(first + index)];
    };
    for (int head = 0; head < grid.elements(); ++head) {
        if (element(head).piece != first + head) continue;  // a piece is named by its first element
        piece_.clear();
        centres_.clear();
        for (int index = head; index < grid.elements(); ++index) {
            if (element(index).piece != first + head) continue;
            piece_.push_back(index);
            const Vec3 centre = grid.centre(index);
            centres_.emplace_back(centre.x(), centre.z());
        }
        const std::vector<ElementWater> shares =
            water_of_piece(centres_, grid.element, draught_[static_cast<std::size_t>(floe)], body_);
        for (std::size_t i = 0; i < piece_.size(); ++i) {
            const auto at = static_cast<std::size_t>(first + piece_[i]);
            if (carries_) world.set_water(element(piece_[i]).body, carried_[at] = shares[i].carried);
            if (radiates_) water.set_damping(at, shares[i].damping);
        }
    }
}

}  // namespace floes
