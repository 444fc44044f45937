#pragma once
// Sobol indices from Saltelli's points: the share of an output's variance due to each input.

#include <span>
#include <vector>

#include "inference/bootstrap.hpp"

namespace floes {

/// The output at Saltelli's points, over n base points j: at A_j, at B_j, and at A_j with input i taken from B_j.
struct SaltelliValues {
    std::vector<double> a;                ///< n
    std::vector<double> b;                ///< n
    std::vector<std::vector<double>> ab;  ///< inputs x n
};

/// An index with its BCa bootstrap interval over base points; NaN where undefined.
struct SobolIndex {
    double estimate;
    Limits interval;
};

struct SobolIndices {
    std::vector<SobolIndex> first;  ///< share of the variance that an input explains by itself, one for each input
    std::vector<SobolIndex> total;  ///< … including interactions with the others
};

/// With y - mean in place of y, and V the population variance of all y_A and y_B:
///   first  S_i = mean(y_B (y_ABi - y_A)) / V    A. Saltelli et al., Comput. Phys. Commun. 181 (2010) 259-270, (b)
///   total  T_i = mean((y_A - y_ABi)²) / (2 V)   M. J. W. Jansen, Comput. Phys. Commun. 117 (1999) 35-43
/// as in scipy.stats.sobol_indices. All NaN if V is 0 or there is no base point. Intervals are those of bca_interval(),
/// which treats base points as independent; for a Sobol sequence, which fills space more evenly, they are too wide.
/// Throws InputError if the sizes differ or a value is not finite.
SobolIndices sobol_indices(const SaltelliValues& values, const BootstrapOptions& options = {});

// What of the scatter of single runs belongs to their arrangement: cases over the same arrangements, in a table of two
// ways without repetition, value = case + arrangement + rest. The share of the arrangement is the intraclass
// correlation: P. E. Shrout and J. L. Fleiss, Psychological Bulletin 86 (1979) 420-428, their ICC(3,1), with the
// interval of F that stands there.

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
