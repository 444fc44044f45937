#include "statistics/peaks.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace floes {
namespace {

/// Places of the local maxima above `least`; of a plateau its first.
std::vector<std::size_t> local_maxima(std::span<const double> values, double least) {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const bool risen = k == 0 || values[k] > values[k - 1];
        const bool falls = k + 1 == values.size() || values[k] >= values[k + 1];
        if (risen && falls && values[k] > least) places.push_back(k);
    }
    return places;
}

}  // namespace

std::vector<double> declustered_peaks(std::span<const double> values, std::size_t apart, double least) {
    std::vector<std::size_t> places = local_maxima(values, least);
    std::ranges::stable_sort(places, std::ranges::greater{}, [&](std::size_t place) { return values[place]; });
    std::vector<double> peaks;
    std::set<std::size_t> taken;
    for (const std::size_t place : places) {
        const auto next = taken.lower_bound(place);
        const bool near_next = next != taken.end() && *next - place < apart;
        const bool near_last = next != taken.begin() && place - *std::prev(next) < apart;
        if (near_next || near_last) continue;
        taken.insert(place);
        peaks.push_back(values[place]);
    }
    return peaks;
}

}  // namespace floes
