// The floes of an arrangement: given one by one, or drawn by the laws of sizes and of the ice.

#include "scenario/floes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/turn.hpp"
#include "scenario/laws.hpp"
#include "scenario/tables.hpp"
#include "shapes/drawn.hpp"
#include "shapes/elements.hpp"

namespace floes {

namespace {

/// A value's place in a table, at the end for a new one. By a tree: a million floes may all differ.
template <class Value>
std::size_t place_of(const Value& value, std::vector<Value>& table, std::map<Value, std::size_t>& places) {
    const auto [place, is_new] = places.emplace(value, table.size());
    if (is_new) table.push_back(value);
    return place->second;
}

}  // namespace

FloeSet gathered(std::span<const SingleFloe> floes) {
    FloeSet set;
    std::map<FloeShape, std::size_t> shapes;
    std::map<Material, std::size_t> materials;
    for (const SingleFloe& one : floes)
        set.floes.push_back(
            {one.pose, place_of(one.shape, set.shapes, shapes), place_of(one.material, set.materials, materials)});
    return set;
}

bool FloeSet::alike() const {
    const auto same = [&](FloeShape shape) {
        shape.pattern = shapes.front().pattern;
        return shape == shapes.front();
    };
    return materials.size() == 1 && std::ranges::all_of(shapes, same);
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

FloeShape sheet_shape(const Scenario& scenario) {
    FloeShape shape = scenario.floe;
    if (scenario.field.endless()) shape.length = scenario.field_length();
    return shape;
}

double computed_floes(const Scenario& scenario) {
    if (!scenario.field.endless()) return scenario.field.floes;
    return scenario.field.floes * (scenario.window_ahead() + scenario.window_behind()) / scenario.field_length();
}

double computed_elements(const Scenario& scenario) {
    if (scenario.arrangement.level()) return sheet_shape(scenario).elements();
    const double floes = computed_floes(scenario);
    if (scenario.sizes.law == SizeLaw::one && !scenario.shapes.from_file()) return scenario.floe.elements() * floes;
    // A few floes tell what their law makes of all: this is asked for every member.
    constexpr int few = 16;
    Scenario sample = scenario;
    sample.field.floes = few;
    double elements = 0;
    for (const FloeShape& shape : floe_sizes(sample)) elements += shape.elements();
    return elements * floes / few;
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

namespace {

/// In single precision, so that it does not show that C libraries differ in the last bits of pow().
double single(double value) {
    return static_cast<float>(value);
}

FloeShape rounded(const Scenario& scenario, double length, double breadth) {
    const double side = element_side(scenario, std::min(length, breadth));
    if (scenario.has_cells()) return {length, breadth, scenario.floe.thickness, side};
    const auto whole = [side](double wanted) {
        const double reached = std::max(1.0, std::round(wanted / side)) * side;
        return std::abs(reached - wanted) <= 1e-9 * wanted ? wanted : reached;  // 0.6 rather than 3 x 0.2 in binary
    };
    return {whole(length), whole(breadth), scenario.floe.thickness, side};
}

/// Length over breadth of floe i: evenly spread whatever the size, since the fractions of multiples of the
/// golden ratio are.
double ratio_of(const Sizes& sizes, std::size_t i) {
    const double place = (static_cast<double>(i) + 0.5) / std::numbers::phi;
    return sizes.least_ratio + (sizes.largest_ratio - sizes.least_ratio) * (place - std::floor(place));
}

/// The diameter, m, that a share of the floes is smaller than.
std::function<double(double)> diameters(const Sizes& sizes) {
    const SizeBounds bounds{sizes.smallest, sizes.largest};
    const bool of_area = sizes.by == SharesOf::area;
    if (sizes.law == SizeLaw::power_law)
        return [=, exponent = sizes.exponent + (of_area ? 2 : 0)](double u) {
            return single(power_law_at(u, exponent, bounds));
        };
    const LognormalSizes stated{sizes.mean, sizes.cov};
    const LognormalSizes law = of_area ? number_law(stated) : stated;
    return [mean = law.mean, factors = cut_off(law, bounds)](double u) { return mean * factors.at(u); };
}

}  // namespace

double element_side(const Scenario& scenario, double breadth) {
    FLOES_EXPECTS(breadth > 0);
    switch (scenario.sizes.element) {
        case ElementSide::of_floe:
            return breadth / scenario.sizes.elements_across;
        case ElementSide::of_ice:
            return single(scenario.sizes.element_share * scenario.characteristic_length());
        default:
            return scenario.floe.element;
    }
}

std::vector<int> listed_counts(const Scenario& scenario) {
    FLOES_EXPECTS(!scenario.sizes.list.empty());
    const std::vector<ListedSize>& list = scenario.sizes.list;
    std::vector<double> wanted;
    for (const ListedSize& one : list)
        wanted.push_back(scenario.sizes.by == SharesOf::area ? one.share / (one.length * one.breadth) : one.share);
    const double sum = std::accumulate(wanted.begin(), wanted.end(), 0.0);
    std::vector<int> counts;
    for (double& floes : wanted) {
        floes *= scenario.field.floes / sum;
        counts.push_back(static_cast<int>(floes));
    }
    // The floes that are left go to the largest remainders.
    std::vector<std::size_t> order(list.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t k) { return wanted[k] - counts[k]; });
    int left = scenario.field.floes - std::accumulate(counts.begin(), counts.end(), 0);
    for (std::size_t k = 0; left > 0; --left, ++k) ++counts[order[k % order.size()]];
    FLOES_ENSURES(std::accumulate(counts.begin(), counts.end(), 0) == scenario.field.floes);
    return counts;
}

std::vector<FloeShape> floe_sizes(const Scenario& scenario) {
    const Sizes& sizes = scenario.sizes;
    const auto floes = static_cast<std::size_t>(scenario.field.floes);
    if (scenario.shapes.from_file()) return traced_shapes(scenario);
    if (scenario.arrangement.level()) return {sheet_shape(scenario)};
    if (sizes.law == SizeLaw::one) return std::vector<FloeShape>(floes, scenario.floe);
    std::vector<FloeShape> shapes;
    if (sizes.law == SizeLaw::list) {
        const std::vector<int> counts = listed_counts(scenario);
        for (std::size_t k = 0; k < counts.size(); ++k)
            shapes.insert(shapes.end(), static_cast<std::size_t>(counts[k]),
                          rounded(scenario, sizes.list[k].length, sizes.list[k].breadth));
        return shapes;
    }
    const std::function<double(double)> diameter_at = diameters(sizes);
    for (std::size_t i = 0; i < floes; ++i) {
        const double diameter = diameter_at((static_cast<double>(i) + 0.5) / static_cast<double>(floes));
        const double stretch = std::sqrt(ratio_of(sizes, i));
        shapes.push_back(rounded(scenario, diameter * stretch, diameter / stretch));
    }
    return shapes;
}

namespace {

/// Which draw of which part.
std::uint64_t of_part(const Scenario& scenario, const Draw& draw) {
    return static_cast<std::uint64_t>(scenario.spread.draw) + (draw.part << 32U);
}

/// The factors of one property, floe after floe.
class PropertyDraws {
  public:
    PropertyDraws(const Spread& spread, const Scenario& scenario, const Draw& draw, StreamId stream)
        : random_(draw.seed, draw.number, stream, of_part(scenario, draw)) {
        if (spread.any()) factors_.emplace(spread.factors());
    }

    /// Size of the next floe; one draw, whether or not there is a law.
    double next() { return at(share()); }

    double share() { return random_.uniform(); }
    double at(double share) const { return factors_ ? factors_->at(share) : 1; }

  private:
    RandomStream random_;
    std::optional<Factors> factors_;
};

void follow_brine(Ice& ice, double salinity, double temperature) {
    const double brine = brine_volume(salinity, temperature);
    scale_strengths(ice, static_cast<float>(flexural_strength(brine) / ice.bending_strength));
    ice.elastic_modulus = static_cast<float>(brine_modulus(brine));
}

}  // namespace

Ice Scenario::mean_ice() const {
    Ice own = ice;
    if (brine.salinity > 0) follow_brine(own, brine.salinity, brine.temperature);
    return own;
}

void scale_strengths(Ice& ice, double factor) {
    for (double* strength : {&ice.bending_strength, &ice.compressive_strength, &ice.shear_strength,
                             &ice.tensile_strength, &ice.torsion_strength, &ice.in_plane_bending_strength})
        *strength *= factor;
}

bool IceSpread::any() const {
    return thickness.any() || strength.any() || elastic_modulus.any() || density.any() || salinity.any() ||
           temperature.any() || weakened > 0;
}

double least_factor(const Spread& spread) {
    return spread.any() ? Factors(spread.factors()).low() : 1;
}

double largest_factor(const Spread& spread) {
    return spread.any() ? Factors(spread.factors()).high() : 1;
}

void draw_ice(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes) {
    const IceSpread& spread = scenario.spread;
    const auto draws = [&](const Spread& one, StreamId stream) { return PropertyDraws(one, scenario, draw, stream); };
    PropertyDraws thickness = draws(spread.thickness, StreamId::ice_thickness);
    PropertyDraws strength = draws(spread.strength, StreamId::ice_strength);
    PropertyDraws modulus = draws(spread.elastic_modulus, StreamId::ice_modulus);
    PropertyDraws density = draws(spread.density, StreamId::ice_density);
    PropertyDraws salinity = draws(spread.salinity, StreamId::ice_salinity);
    PropertyDraws temperature = draws(spread.temperature, StreamId::ice_temperature);
    RandomStream weakened(draw.seed, draw.number, StreamId::weakened_ice, of_part(scenario, draw));
    const double correlation = spread.thickness.any() && spread.strength.any() ? spread.correlation : 0;
    for (SingleFloe& floe : floes) {
        const double of_thickness = thickness.share();
        double of_strength = strength.share();
        if (correlation != 0)
            of_strength = normal_share(correlation * normal_at(of_thickness) +
                                       std::sqrt(1 - correlation * correlation) * normal_at(of_strength));
        const bool within = spread.length > 0;
        if (within)
            floe.material.variation = {spread.length,           draw.seed,        draw.number,
                                       of_part(scenario, draw), spread.thickness, spread.strength,
                                       spread.elastic_modulus,  correlation};
        else
            floe.shape.thickness *= thickness.at(of_thickness);
        Ice& ice = floe.material.ice;
        const double salt = scenario.brine.salinity * salinity.next();
        const double cold = scenario.brine.temperature * temperature.next();
        if (scenario.brine.salinity > 0) follow_brine(ice, salt, cold);
        if (!within) scale_strengths(ice, strength.at(of_strength));
        if (weakened.uniform() < spread.weakened) scale_strengths(ice, spread.weakened_to);
        const double of_modulus = modulus.next();
        if (!within) ice.elastic_modulus *= of_modulus;
        ice.density *= density.next();
    }
}

namespace {

constexpr double shortest_edge = 1e-4;  // of the root of the area; shorter ones go

/// The outline about its centroid, in axes turned by `axis`. `of`: its measures.
void give(FloeShape& shape, Corners outline, const Measures& of, const Corner& axis) {
    shape.outline = in_axes(tidied(outline, shortest_edge * std::sqrt(of.area)), of.centroid, axis);
    const Corner size = size_of(shape.outline);
    shape.length = size.x;
    shape.breadth = size.z;
}

/// Along its long axis, in single precision, so that it does not show that C libraries differ in the last bits.
double yaw_of(const Corner& axis) {
    return static_cast<float>(std::atan2(-axis.z, axis.x));
}

void grow_cells(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes) {
    constexpr int attempts = 20;
    const Field& field = scenario.field;
    const double breadth = 2 * field.half_width;
    const double length = scenario.field_length();
    RandomStream random(draw.seed, draw.number, StreamId::voronoi, 0);
    Shrunk cells;
    bool found = false;
    for (int attempt = 0; attempt < attempts && !found; ++attempt) {
        cells = shrunk_to(voronoi_cells({field.begin, -field.half_width, length, breadth},
                                        static_cast<int>(floes.size()), scenario.shapes.relaxations, random),
                          field.concentration * length * breadth);
        found = std::ranges::all_of(cells.outlines,
                                    [&](const Outline& one) { return is_floe(one, scenario.floe.thickness); });
    }
    if (!found)
        throw InputError(
            "shapes.relaxations = {} left a Voronoi cell that is narrower than the ice is thick after its edges moved "
            "in by {:.4g} m, in each of {} attempts; relax more, raise field.concentration_percent or take larger "
            "floes",
            scenario.shapes.relaxations, cells.offset, attempts);
    check_gap(scenario, cells.offset);
    for (std::size_t i = 0; i < floes.size(); ++i) lie_as(floes[i], cells.outlines[i]);
}

}  // namespace

bool is_floe(Corners outline, double thickness) {
    return outline.size() >= 3 && outline.size() <= most_outline_corners && inner_radius(outline) > thickness / 2;
}

void lie_as(SingleFloe& floe, Corners outline) {
    const Measures measures = measures_of(outline);
    floe.pose = {measures.centroid.x, measures.centroid.z, yaw_of(long_axis(measures))};
    const Turn turn = turn_of(floe.pose.yaw);
    give(floe.shape, outline, measures, {turn.cos, -turn.sin});
}

void check_gap(const Scenario& scenario, double offset) {
    const double clearance = scenario.arrangement.clearance;
    if (offset >= clearance) return;  // from the walls; apart from each other they are twice as far
    throw InputError(
        "Voronoi cells at field.concentration_percent = {:g} are {:.4g} m apart and {:.4g} m from the walls, less than "
        "arrangement.clearance_m = {:g}; lower one of the two",
        100 * scenario.field.concentration, 2 * offset, offset, clearance);
}

std::vector<SingleFloe> floes_as_traced(const Scenario& scenario) {
    const TracedOutlines& traced = scenario.shapes.traced;
    const Corner origin{scenario.field.begin + scenario.arrangement.clearance, 0};
    std::vector<SingleFloe> floes;
    for (const Outline& one : traced.outlines) {
        Outline placed;
        for (const Corner& corner : one) placed.push_back(origin + traced.scale * corner);
        if (area_of(placed) < 0) std::ranges::reverse(placed);
        lie_as(floes.emplace_back(SingleFloe{{}, scenario.floe, scenario.material()}), placed);
    }
    return floes;
}

std::vector<FloeShape> traced_shapes(const Scenario& scenario) {
    const std::vector<SingleFloe> stock = floes_as_traced(scenario);
    std::vector<std::size_t> by_area(stock.size());
    std::iota(by_area.begin(), by_area.end(), std::size_t{0});
    std::ranges::stable_sort(by_area, {}, [&](std::size_t i) { return stock[i].shape.area(); });
    const auto floes = static_cast<std::size_t>(scenario.field.floes);
    std::vector<FloeShape> shapes;
    for (std::size_t i = 0; i < floes && !stock.empty(); ++i)
        shapes.push_back(stock[by_area[(2 * i + 1) * stock.size() / (2 * floes)]].shape);
    return shapes;
}

std::vector<double> traced_added(const TracedOutlines& traced) {
    std::vector<double> added;
    for (std::size_t i = 0; i < traced.areas.size(); ++i)
        added.push_back(std::abs(area_of(traced.outlines[i])) / traced.areas[i] - 1);
    return added;
}

std::string outline_name(const TracedOutlines& traced, std::size_t number) {
    std::istringstream names(traced.names);
    std::string name;
    for (std::size_t k = 0; k <= number; ++k)
        if (!std::getline(names >> std::ws, name, ',')) return fmt::format("outline {}", number + 1);
    return fmt::format("outline {} \"{}\"", number + 1, name);
}

void shape_floes(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes) {
    const Shapes& shapes = scenario.shapes;
    if (shapes.kind == ShapeKind::voronoi && draw.part == 0) grow_cells(scenario, draw, floes);
    if (shapes.kind != ShapeKind::polygon) return;
    RandomStream random(draw.seed, draw.number, StreamId::polygons, draw.part);
    for (SingleFloe& floe : floes) {
        const Outline outline =
            polygon_about(floe.shape.length, floe.shape.breadth, shapes.corners, shapes.irregularity, random);
        const Measures measures = measures_of(outline);
        give(floe.shape, outline, measures, long_axis(measures));
    }
}

namespace {

/// The keys that `columns` names, in its order; each holds a number.
std::vector<const Key*> named_keys(const Keys& keys, const std::string& columns) {
    std::vector<const Key*> named;
    std::istringstream names(columns);
    for (std::string name; std::getline(names, name, ',');) {
        const Key* key = find_key(keys, name);
        const bool number = key != nullptr && std::holds_alternative<NumberField>(key->field) &&
                            key->path != "joint.averaging_s";  // one of the whole field
        if (!number || std::ranges::find(named, key) != named.end()) {
            throw InputError(
                "arrangement.columns = \"{}\" has \"{}\", which is {}; allowed: numbers of [floe], [ice] and [joint], "
                "each once, such as \"floe.length_m,floe.breadth_m,ice.thickness_m\"",
                columns, name, number ? "there twice" : "no such number");
        }
        named.push_back(key);
    }
    return named;
}

std::vector<SingleFloe> given_floes(const Scenario& scenario) {
    const ArrangementRule& rule = scenario.arrangement;
    std::vector<SingleFloe> given;
    if (rule.columns.empty()) {
        for (const PlanarPose& pose : rule.poses) given.push_back({pose, scenario.floe, scenario.material()});
        return given;
    }
    FloeShape shape;
    Material material;
    Keys keys;
    add_floe(keys, shape);
    add_ice(keys, shape, material.ice, material.joint);
    add_joint(keys, material.joint);
    const std::vector<const Key*> columns = named_keys(keys, rule.columns);
    for (std::size_t floe = 0; floe < rule.poses.size(); ++floe) {
        const std::vector<double>& values = rule.values.at(floe);
        if (values.size() != columns.size())
            throw InputError("floe {} has {} values behind its pose and arrangement.columns names {}", floe,
                             values.size(), columns.size());
        shape = scenario.floe;
        material = scenario.material();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const NumberField& field = std::get<NumberField>(columns[i]->field);
            if (!field.range.contains(values[i]))
                throw InputError("floe {} has {} = {}; allowed: {}", floe, columns[i]->path, values[i],
                                 to_text(field.range));
            field.set(values[i] * field.unit);
        }
        given.push_back({rule.poses[floe], shape, material});
    }
    return given;
}

/// Floes of the sizes of the scenario in an order of this arrangement's own, without places unless they were traced.
std::vector<SingleFloe> sized_floes(const Scenario& scenario, const Draw& draw) {
    if (scenario.arrangement.method == ArrangementMethod::traced) return floes_as_traced(scenario);
    if (scenario.arrangement.level()) {  // from the near edge of the field on, about the tow's line
        const FloeShape sheet = sheet_shape(scenario);
        return {{{scenario.field.begin + sheet.length / 2, 0, 0}, sheet, scenario.material()}};
    }
    std::vector<SingleFloe> sized;
    for (const FloeShape& shape : floe_sizes(scenario)) sized.push_back({{}, shape, scenario.material()});
    if (!sizes_may_differ(scenario)) return sized;
    RandomStream random(draw.seed, draw.number, StreamId::floe_sizes, draw.part);
    for (std::size_t left = sized.size(); left > 1; --left)
        std::swap(sized[left - 1].shape, sized[random.below(static_cast<std::uint32_t>(left))].shape);
    return sized;
}

}  // namespace

FloeSet floes_of(const Scenario& scenario, const Draw& draw) {
    const bool given = scenario.arrangement.method == ArrangementMethod::file;
    std::vector<SingleFloe> floes = given ? given_floes(scenario) : sized_floes(scenario, draw);
    if (floes_may_differ(scenario)) {
        shape_floes(scenario, draw, floes);
        draw_ice(scenario, draw, floes);
    }
    for (std::size_t i = 0; i < floes.size(); ++i)
        floes[i].shape.pattern =
            scenario.arrangement.level() ? scenario.pattern_of_sheet(draw.number) : scenario.pattern_of(i);
    return gathered(floes);
}

}  // namespace floes
