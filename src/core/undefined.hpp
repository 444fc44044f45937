#pragma once

#include <limits>

namespace floes {

// A value that is not known or cannot be: NaN in files and arrays, an empty cell in tables.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace floes
