#pragma once
// What of the scatter of single runs belongs to their arrangement: cases over the same arrangements, in a table of two
// ways without repetition, value = case + arrangement + rest. The share of the arrangement is the intraclass
// correlation: P. E. Shrout and J. L. Fleiss, Psychological Bulletin 86 (1979) 420-428, their ICC(3,1), with the
// interval of F that stands there.

#include <span>
#include <vector>

#include "inference/bootstrap.hpp"

namespace floes {

struct ArrangementShare {
    std::size_t cases = 0;
    std::size_t arrangements = 0;
    double sd = 0;      ///< of one run about the mean of its case, unit of the values
    double share = 0;   ///< of that variance, of arrangements; below 0 by chance where they explain nothing
    Limits interval{};  ///< 95 %
};

/// `values`: a list for each case, with one value for each arrangement, in the same order. Everything is NaN for fewer
/// than two cases or three arrangements, or where nothing scatters. Throws InputError if lists differ in length.
ArrangementShare arrangement_share(std::span<const std::vector<double>> values);

}  // namespace floes
