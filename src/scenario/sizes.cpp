#include "scenario/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "laws/size_law.hpp"
#include "scenario/shaped_floes.hpp"

namespace floes {
namespace {

/// In single precision, so that it does not show that C libraries differ in the last bits of pow().
double single(double value) {
    return static_cast<float>(value);
}

/// (E h³ / (12 (1 - ν²) ρ_w g))^¼, m: of the scenario's own ice, so that no draw of the ice changes the elements.
double characteristic_length(const Scenario& scenario) {
    const double nu = scenario.ice.poisson_ratio;
    const double rigidity = scenario.ice.elastic_modulus * std::pow(scenario.floe.thickness, 3) / (12 * (1 - nu * nu));
    return std::pow(rigidity / (scenario.water.density * scenario.general.gravity), 0.25);
}

FloeShape rounded(const Scenario& scenario, double length, double breadth) {
    const double side = element_side(scenario, std::min(length, breadth));
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
    switch (scenario.sizes.element) {
        case ElementSide::of_floe:
            return breadth / scenario.sizes.elements_across;
        case ElementSide::of_ice:
            return single(scenario.sizes.element_share * characteristic_length(scenario));
        default:
            return scenario.floe.element;
    }
}

std::vector<int> listed_counts(const Scenario& scenario) {
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
    return counts;
}

std::vector<FloeShape> floe_sizes(const Scenario& scenario) {
    const Sizes& sizes = scenario.sizes;
    const auto floes = static_cast<std::size_t>(scenario.field.floes);
    if (scenario.shapes.from_file()) return traced_shapes(scenario);
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

}  // namespace floes
