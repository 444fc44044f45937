#include "scenario/floes.hpp"

#include <algorithm>
#include <map>

namespace floes {
namespace {

/// Finds a value's place in a table, at the end for a new one. By a tree: a million floes may all differ.
template <class Value>
class Places {
  public:
    std::size_t of(const Value& value, std::vector<Value>& table) {
        const auto [place, is_new] = places_.emplace(value, table.size());
        if (is_new) table.push_back(value);
        return place->second;
    }

  private:
    std::map<Value, std::size_t> places_;
};

}  // namespace

FloeSet gathered(std::span<const SingleFloe> floes) {
    FloeSet set;
    Places<FloeShape> shapes;
    Places<Material> materials;
    for (const SingleFloe& one : floes)
        set.floes.push_back({one.pose, shapes.of(one.shape, set.shapes), materials.of(one.material, set.materials)});
    return set;
}

std::vector<PlanarPose> FloeSet::poses() const {
    std::vector<PlanarPose> found;
    for (const Floe& floe : floes) found.push_back(floe.pose);
    return found;
}

FloeSet floes_at(const Scenario& scenario, std::span<const PlanarPose> poses) {
    FloeSet set{{scenario.floe}, {scenario.material()}, {}};
    for (const PlanarPose& pose : poses) set.floes.push_back({pose});
    return set;
}

bool floes_may_differ(const Scenario& scenario) {
    return sizes_may_differ(scenario) || scenario.shapes.any() || scenario.spread.any() || scenario.brine.salinity > 0;
}

bool sizes_may_differ(const Scenario& scenario) {
    return !scenario.arrangement.columns.empty() || scenario.sizes.law != SizeLaw::one || scenario.shapes.from_file();
}

double computed_floes(const Scenario& scenario) {
    if (!scenario.field.endless()) return scenario.field.floes;
    return scenario.field.floes * (scenario.window_ahead() + scenario.window_behind()) / scenario.field_length();
}

double covered_area(const FloeSet& floes) {
    std::vector<double> count(floes.shapes.size());
    for (const Floe& floe : floes.floes) ++count[floe.shape];
    double area = 0;
    for (std::size_t i = 0; i < count.size(); ++i) {
        const FloeShape& shape = floes.shapes[i];
        area += shape.is_polygon() ? count[i] * shape.area() : count[i] * shape.length * shape.breadth;
    }
    return area;
}

double element_count(const FloeSet& floes) {
    double count = 0;
    for (const Floe& floe : floes.floes) count += floes.shapes[floe.shape].elements();
    return count;
}

double largest_side(const FloeSet& floes) {
    double side = 0;
    for (const FloeShape& shape : floes.shapes) side = std::max({side, shape.length, shape.breadth});
    return side;
}

}  // namespace floes
