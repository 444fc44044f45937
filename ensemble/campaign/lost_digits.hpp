#pragma once
// How far apart the numbers of a file are that was written with too few digits.

#include <span>

namespace floes {

/// Between single-precision numbers at the largest of these, if all are such numbers and one of them needs the last bit
/// there; otherwise 0.
double single_precision_step(std::span<const double> numbers);

/// 10, 100, … if all are multiples of it and the largest has five digits or more before its zeros, as rounding to six
/// digits leaves them; otherwise 0.
double decimal_step(std::span<const double> numbers);

}  // namespace floes
