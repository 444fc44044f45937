#include "simulation/field_water.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/state_archive.hpp"
#include "solver/lane_width.hpp"

namespace floes {

namespace {

/// What water flows round; none: the waterline circle.
std::vector<FlowEllipse> flow_ellipses(const Shape& shape) {
    std::vector<FlowEllipse> ellipses;
    if (shape.is_of_revolution()) return ellipses;
    for (const WaterlineEllipse& one : shape.waterline_ellipses())
        ellipses.push_back({one.x, one.z, one.half_length, one.half_breadth});
    return ellipses;
}

}  // namespace

WaterLanes make_water(const Scenario& scenario, const FloeSet& floes, const IceField& ice) {
    const std::vector<IceElement>& elements = ice.elements();
    std::map<std::tuple<std::size_t, double, int>, std::size_t>
        kinds;  // shape, density, and which element, if it matters
    std::vector<WaterModel> models;
    std::vector<std::size_t> model_of;
    const double radius = scenario.structure.shape.waterline_radius();
    const std::vector<FlowEllipse> ellipses = flow_ellipses(scenario.structure.shape);
    for (const IceElement& element : elements) {
        const auto floe = static_cast<std::size_t>(element.floe);
        const FloeShape& shape = floes.shape(floe);
        const Ice& ice_of_floe = floes.material(floe).ice;
        const bool squares = ice.cut(element.floe).squares;
        const auto [kind, is_new] = kinds.try_emplace(
            {floes.floes[floe].shape, ice_of_floe.density, squares ? 0 : element.index}, models.size());
        model_of.push_back(kind->second);
        if (!is_new) continue;
        const CutElement& cut = ice.cut_element(element);
        models.emplace_back(scenario.water, scenario.general.gravity, cut, shape.thickness,
                            shape.element_mass(ice_of_floe, cut), radius, scenario.structure.speed,
                            scenario.wind.stress());
        models.back().flow_round(ellipses);
    }
    return {models, model_of, lane_widths().back()};
}

PieceWater::PieceWater(const Scenario& scenario, const FloeSet& floes, const IceField& ice)
    : body_{scenario.water.density, scenario.general.gravity, scenario.water.added_mass_in_plane},
      carries_(scenario.water.added_mass_from == WaterFrom::outline),
      radiates_(scenario.water.heave_damping_from == WaterFrom::outline) {
    carried_.resize(ice.elements().size());
    for (std::size_t i = 0; i < floes.size(); ++i)
        draught_.push_back(floes.shape(i).thickness * floes.material(i).ice.density / scenario.water.density);
}

void PieceWater::share_out(const IceField& ice, World& world, WaterLanes& water) {
    if (!carries_ && !radiates_) return;
    if (!ice.is_sheet()) {
        for (int place = 0; place < ice.places(); ++place)
            if (ice.is_there(place)) share_out(place, ice, world, water);
        return;
    }
    piece_order_.clear();
    for (std::size_t i = 0; i < ice.elements().size(); ++i) {
        const int place = ice.elements()[i].floe;
        if (ice.is_there(place) && !ice.rests(place)) piece_order_.push_back(static_cast<int>(i));
    }
    share_out_listed(ice, world, water);
}

void PieceWater::share_out(int floe, const IceField& ice, World& world, WaterLanes& water) {
    if (!carries_ && !radiates_) return;
    piece_order_.resize(static_cast<std::size_t>(ice.elements(floe)));
    std::iota(piece_order_.begin(), piece_order_.end(), ice.first_element(floe));
    share_out_listed(ice, world, water);
}

void PieceWater::share_out_listed(const IceField& ice, World& world, WaterLanes& water) {
    const auto element = [&](int index) -> const IceElement& {
        return ice.elements()[static_cast<std::size_t>(index)];
    };
    std::ranges::sort(piece_order_, {}, [&](int index) { return std::pair(element(index).piece, index); });
    for (auto piece = piece_order_.begin(); piece != piece_order_.end();) {
        const int floe = element(*piece).floe;
        const CutFloe& cut = ice.cut(floe);
        const auto end = std::find_if(piece, piece_order_.end(),
                                      [&, name = element(*piece).piece](int i) { return element(i).piece != name; });
        centres_.clear();
        polygons_.clear();
        of_sheet_.clear();
        for (auto index = piece; index != end; ++index) {
            const CutElement& one = ice.cut_element(element(*index));
            if (ice.is_sheet()) {
                of_sheet_.push_back(one);
                of_sheet_.back().centre = ice.centre(element(*index));
            } else if (cut.squares) {
                centres_.emplace_back(one.centre.x, one.centre.z);
            } else {
                polygons_.push_back(&one);
            }
        }
        for (const CutElement& one : of_sheet_) polygons_.push_back(&one);
        const double draught = draught_[static_cast<std::size_t>(floe)];
        for (const ElementWater& share :
             cut.squares ? water_of_piece(centres_, cut.elements.front().corners.front().x * 2, draught, body_)
                         : water_of_piece(polygons_, draught, body_)) {
            const int index = *piece++;
            const auto at = static_cast<std::size_t>(index);
            if (carries_) world.set_water(element(index).body, carried_[at] = share.carried);
            if (radiates_) water.set_damping(at, share.damping);
        }
    }
}

void PieceWater::archive(StateArchive& state) {
    auto& [body, carries, radiates, draught, carried, piece_order, centres, polygons, of_sheet] = *this;
    state(carried);
}

}  // namespace floes
