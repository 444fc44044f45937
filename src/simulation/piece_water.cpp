#include "simulation/piece_water.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

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
    const CutFloe* cut = ice.cut(floe);
    const FloeGrid& grid = ice.grid(floe);
    const int first = ice.first_element(floe);
    const auto element = [&](int index) -> const IceElement& {
        return ice.elements()[static_cast<std::size_t>(first + index)];
    };
    piece_order_.resize(static_cast<std::size_t>(ice.elements(floe)));
    std::iota(piece_order_.begin(), piece_order_.end(), 0);
    std::ranges::sort(piece_order_, {}, [&](int index) { return std::pair(element(index).piece, index); });
    for (auto piece = piece_order_.begin(); piece != piece_order_.end();) {
        const auto end = std::find_if(piece, piece_order_.end(),
                                      [&, name = element(*piece).piece](int i) { return element(i).piece != name; });
        centres_.clear();
        polygons_.clear();
        for (auto index = piece; index != end; ++index) {
            if (cut != nullptr) {
                polygons_.push_back(&cut->elements[static_cast<std::size_t>(*index)]);
                continue;
            }
            const Vec3 centre = grid.centre(*index);
            centres_.emplace_back(centre.x(), centre.z());
        }
        const double draught = draught_[static_cast<std::size_t>(floe)];
        for (const ElementWater& share : cut != nullptr ? water_of_piece(polygons_, draught, body_)
                                                        : water_of_piece(centres_, grid.element, draught, body_)) {
            const int index = *piece++;
            const auto at = static_cast<std::size_t>(first + index);
            if (carries_) world.set_water(element(index).body, carried_[at] = share.carried);
            if (radiates_) water.set_damping(at, share.damping);
        }
    }
}

}  // namespace floes
