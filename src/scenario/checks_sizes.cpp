// Contradictions within the laws of sizes.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "laws/size_law.hpp"
#include "scenario/keys.hpp"
#include "scenario/sizes.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace {

constexpr double least_mass = 1e-6;  // of a law within its bounds; less is a slip of the pen

void check_list(const Scenario& scenario, Contradictions& found) {
    const std::string key = "sizes.list_m";
    const std::vector<ListedSize>& list = scenario.sizes.list;
    if (list.empty()) {
        found.push_back({{"sizes.law", key},
                         fmt::format("{} needs sizes.list_m = [[length_m, breadth_m, share_percent], ...]",
                                     given(scenario, "sizes.law"))});
        return;
    }
    double sum = 0;
    for (const ListedSize& one : list) sum += one.share;
    if (std::abs(sum - 1) > 1e-6)
        found.push_back(
            {{key}, fmt::format("the shares of {} sum to {:.6g} %; they are to sum to 100 %", key, 100 * sum)});
    if (scenario.sizes.element != ElementSide::given) return;
    const double element = scenario.floe.element;
    for (const ListedSize& one : list) {
        for (const double side : {one.length, one.breadth}) {
            const double ratio = side / element;
            if (std::abs(ratio - std::round(ratio)) <= 1e-9 * ratio && ratio > 0.5) continue;
            found.push_back(
                {{key, "floe.element_m"},
                 fmt::format("{} does not divide the side of {:g} m in {}; the nearest side that does is "
                             "{:.6g}, or take sizes.element = \"of_floe\"",
                             given(scenario, "floe.element_m"), side, key, side / std::max(1.0, std::round(ratio)))});
            return;
        }
    }
}

void check_size_law(const Scenario& scenario, Contradictions& found) {
    const Sizes& sizes = scenario.sizes;
    if (sizes.smallest >= sizes.largest) {
        found.push_back({{"sizes.smallest_m", "sizes.largest_m"},
                         fmt::format("{} is not below {}", given(scenario, "sizes.smallest_m"),
                                     given(scenario, "sizes.largest_m"))});
        return;
    }
    if (sizes.least_ratio > sizes.largest_ratio)
        found.push_back({{"sizes.ratio_lowest", "sizes.ratio_highest"},
                         fmt::format("{} is above {}", given(scenario, "sizes.ratio_lowest"),
                                     given(scenario, "sizes.ratio_highest"))});
    if (sizes.law != SizeLaw::lognormal) return;
    const LognormalSizes law{sizes.mean, sizes.cov};
    const double mass =
        cut_off(sizes.by == SharesOf::area ? number_law(law) : law, {sizes.smallest, sizes.largest}).mass();
    if (mass < least_mass)
        found.push_back({{"sizes.smallest_m", "sizes.largest_m", "sizes.mean_m", "sizes.cov"},
                         fmt::format("{} and {} leave {:.2g} of the lognormal law of {} and {}; take bounds on both "
                                     "sides of most floes",
                                     given(scenario, "sizes.smallest_m"), given(scenario, "sizes.largest_m"), mass,
                                     given(scenario, "sizes.mean_m"), given(scenario, "sizes.cov"))});
}

/// The shortest and the longest side of any floe before it is rounded, m.
std::pair<double, double> extreme_sides(const Sizes& sizes) {
    if (sizes.law != SizeLaw::list)
        return {sizes.smallest / std::sqrt(sizes.largest_ratio), sizes.largest * std::sqrt(sizes.largest_ratio)};
    std::vector<double> sides;
    for (const ListedSize& one : sizes.list) sides.insert(sides.end(), {one.length, one.breadth});
    const auto [shortest, longest] = std::ranges::minmax(sides);
    return {shortest, longest};
}

/// Elements no larger than the smallest floe, and no more of them than a member may have.
void check_size_elements(const Scenario& scenario, Contradictions& found) {
    const Sizes& sizes = scenario.sizes;
    if (sizes.element != ElementSide::of_floe) {
        const auto [shorter, longest] = extreme_sides(sizes);
        const double side = element_side(scenario, shorter);
        const std::string key = sizes.element == ElementSide::given ? "floe.element_m" : "sizes.element_share";
        if (side > shorter * (1 + 1e-9)) {
            found.push_back(
                {{key, "sizes.smallest_m", "sizes.list_m"},
                 fmt::format("{} makes elements of {:.4g} m, larger than the side of {:.4g} m of the smallest "
                             "floe; take smaller elements or larger floes",
                             given(scenario, key), side, shorter)});
            return;
        }
        constexpr double most_along = 1e4;
        if (longest > most_along * side) {
            found.push_back({{key, "sizes.largest_m", "sizes.list_m"},
                             fmt::format("{} makes elements of {:.4g} m, more than {:g} of them along the largest floe",
                                         given(scenario, key), side, most_along)});
            return;
        }
    }
    double elements = 0;
    for (const FloeShape& shape : floe_sizes(scenario)) elements += shape.elements();
    check_element_count(scenario, elements, found);
}

}  // namespace

void check_sizes(const Scenario& scenario, Contradictions& found) {
    const Sizes& sizes = scenario.sizes;
    if (sizes.law == SizeLaw::one) return;
    if (scenario.arrangement.method == ArrangementMethod::file) {
        found.push_back({{"sizes.law", "arrangement.method"},
                         fmt::format("{} does not suit {}; give the sizes as columns of arrangement.file",
                                     given(scenario, "sizes.law"), given(scenario, "arrangement.method"))});
        return;
    }
    if (sizes.law == SizeLaw::list)
        check_list(scenario, found);
    else
        check_size_law(scenario, found);
    if (found.empty()) check_size_elements(scenario, found);
}

}  // namespace floes
