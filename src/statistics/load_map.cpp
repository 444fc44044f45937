#include "statistics/load_map.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/contract.hpp"
#include "core/state_archive.hpp"

namespace floes {
namespace {

constexpr std::size_t quarter = LoadMap::angles / 4;

/// Tangents of 10, 20, … 80 degrees.
constexpr std::array<double, quarter - 1> tangents{0.17632698070846498, 0.36397023426620234, 0.57735026918962573,
                                                   0.83909963117728,    1.1917535925942099,  1.7320508075688772,
                                                   2.7474774194546216,  5.6712818196177093};

std::vector<double> scaled(std::span<const double> sums, std::size_t steps) {
    std::vector<double> means(sums.begin(), sums.end());
    for (double& mean : means) mean /= static_cast<double>(steps);
    return means;
}

}  // namespace

std::size_t angle_bin(double ahead, double across) {
    const double x = std::abs(ahead);
    const double z = std::abs(across);
    const auto from_axis =
        static_cast<std::size_t>(std::ranges::count_if(tangents, [&](double tangent) { return z >= tangent * x; }));
    const std::size_t from_ahead = ahead > 0 ? from_axis : 2 * quarter - 1 - from_axis;
    return across >= 0 ? 2 * quarter + from_ahead : 2 * quarter - 1 - from_ahead;
}

void ContactBins::add(double ahead, double up, double across, double surge, double normal) {
    const double share = std::clamp((up - bottom_) * bins_a_metre_, 0.0, LoadMap::heights - 0.5);
    const std::size_t bin = static_cast<std::size_t>(share) * LoadMap::angles + angle_bin(ahead, across);
    surge_[bin] += surge;
    normal_[bin] += normal;
}

LoadMap ContactBins::means(std::size_t steps) const {
    FLOES_EXPECTS(steps >= 1);
    return {scaled(surge_, steps), scaled(normal_, steps), {}};
}

void ContactBins::archive(StateArchive& state) {
    auto& [bottom, bins_a_metre, surge, normal] = *this;
    state(surge, normal);
}

}  // namespace floes
