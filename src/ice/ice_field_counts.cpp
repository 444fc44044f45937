// Floes of an IceField that come and go, and its counts.

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "ice/ice_field.hpp"
#include "ice/polygon_floe.hpp"

namespace floes {

int IceField::enter(World& world, const Scenario& scenario, const SingleFloe& floe) {
    const int number = entered_;
    if (const std::shared_ptr<const CutFloe> cut = cut_of(floe.shape))
        add_polygon(world, scenario, floe, cut);
    else
        add_floe(world, scenario, floe, joint_order(grid_of(floe.shape)));
    return place_of(number);
}

void IceField::leave(World& world, int place) {
    Sheet& sheet = floes_[static_cast<std::size_t>(place)];
    const int pieces = pieces_at(sheet);
    left_.broken += sheet.broken ? 1 : 0;
    left_.cracked += sheet.cracked ? 1 : 0;
    left_.split += pieces > 1 ? 1 : 0;
    left_.pieces += pieces;
    add_piece_areas(sheet, left_.areas);
    sheet.there = false;
    for (const Joint& joint : joints_) {
        if (joint.floe != place) continue;
        world.remove_joint(joint.id);
        if (by_stress_) stress_.remove_joint(joint.place);
    }
    std::erase_if(joints_, [&](const Joint& joint) { return joint.floe == place; });
    free_joints_.insert(free_joints_.end(), sheet.joints.begin(), sheet.joints.end());
    std::ranges::sort(free_joints_, std::ranges::greater());
    for (int index = 0; index < sheet.elements(); ++index)
        world.take_out(elements_[static_cast<std::size_t>(sheet.first + index)].body);
}

int IceField::place_of(int number) const {
    const auto at = static_cast<std::size_t>(number);
    if (at < floes_.size() && floes_[at].number == number) return number;  // always, where none leaves
    return static_cast<int>(std::ranges::find(floes_, number, &Sheet::number) - floes_.begin());
}

int IceField::pieces_at(const Sheet& sheet) const {
    std::set<int> pieces;
    for (int index = 0; index < sheet.elements(); ++index)
        pieces.insert(elements_[static_cast<std::size_t>(sheet.first + index)].piece);
    return static_cast<int>(pieces.size());
}

int IceField::broken_floes() const {
    const auto broken = [](const Sheet& sheet) { return sheet.there && sheet.broken; };
    return left_.broken + static_cast<int>(std::ranges::count_if(floes_, broken));
}

int IceField::split_floes() const {
    const auto split = [&](const Sheet& sheet) { return sheet.there && pieces_at(sheet) > 1; };
    return left_.split + static_cast<int>(std::ranges::count_if(floes_, split));
}

int IceField::pieces() const {
    int found = left_.pieces;
    for (const Sheet& sheet : floes_)
        if (sheet.there) found += pieces_at(sheet);
    return found;
}

/// Nothing of a floe in one piece.
void IceField::add_piece_areas(const Sheet& sheet, std::vector<PieceArea>& areas) const {
    const auto first = static_cast<std::size_t>(sheet.first);
    std::map<int, double> of_piece;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sheet.elements()); ++i)
        of_piece[elements_[first + i].piece] +=
            sheet.cut ? sheet.cut->elements[i].area : sheet.grid.element * sheet.grid.element;
    if (of_piece.size() == 1) return;
    for (const auto& [piece, area] : of_piece) areas.push_back({sheet.number, area});
}

std::vector<PieceArea> IceField::piece_areas() const {
    std::vector<PieceArea> areas = left_.areas;
    for (const Sheet& sheet : floes_)
        if (sheet.there) add_piece_areas(sheet, areas);
    std::ranges::stable_sort(areas, {}, &PieceArea::floe);
    return areas;
}

int IceField::cracked_floes() const {
    const auto cracked = [](const Sheet& sheet) { return sheet.there && sheet.cracked; };
    return left_.cracked + static_cast<int>(std::ranges::count_if(floes_, cracked));
}

}  // namespace floes
