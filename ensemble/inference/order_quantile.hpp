#pragma once
// The member that stands for a quantile, by the order of the members' values, whatever their distribution.

#include <span>
#include <vector>

namespace floes {

/// Ranks count from 1, the least value. The quantile of all members that could be drawn lies between the values of two
/// ranks with at least 95 %: the number of n values below it is binomial, and each side is left out with 2.5 % at most.
struct OrderQuantile {
    std::size_t place = 0;  ///< of the value in what was given
    int rank = 0;           ///< ceil(quantile n): so large a share of the values does not exceed it
    int count = 0;          ///< n, of values that are numbers
    int low_rank = 0;       ///< 0: so few values have no lower end
    int high_rank = 0;      ///< n + 1: they have no upper end
    double value = 0;
    double low = 0;   ///< minus infinity without a lower end
    double high = 0;  ///< infinity without an upper end
};

/// `quantile` in (0, 1). NaN are left out; expects a number among the values. Of equal values the first has the lower
/// rank.
OrderQuantile order_quantile(std::span<const double> values, double quantile);

}  // namespace floes
