#include "inference/order_quantile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/binomial.hpp>

#include "core/contract.hpp"

namespace floes {

OrderQuantile order_quantile(std::span<const double> values, double quantile) {
    FLOES_EXPECTS(quantile > 0 && quantile < 1);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (!std::isnan(values[k])) order.push_back(k);
    FLOES_EXPECTS(!order.empty());
    std::ranges::stable_sort(order, {}, [&](std::size_t place) { return values[place]; });
    const auto count = static_cast<int>(order.size());
    const int rank = std::clamp(static_cast<int>(std::ceil(quantile * count - 1e-9)), 1, count);
    constexpr double side = 0.025;
    const boost::math::binomial below(count, quantile);
    int low = rank;  // P(fewer than `low` values lie below the quantile) may be 2.5 %
    while (low > 0 && boost::math::cdf(below, low - 1) > side) --low;
    int high = rank;
    while (high <= count && boost::math::cdf(boost::math::complement(below, high - 1)) > side) ++high;
    constexpr double none = std::numeric_limits<double>::infinity();
    const auto value_of = [&](int of_rank) { return values[order[static_cast<std::size_t>(of_rank - 1)]]; };
    return {.place = order[static_cast<std::size_t>(rank - 1)],
            .rank = rank,
            .count = count,
            .low_rank = low,
            .high_rank = high,
            .value = value_of(rank),
            .low = low == 0 ? -none : value_of(low),
            .high = high > count ? none : value_of(high)};
}

}  // namespace floes
