#pragma once
// What WAMIT has in common in its files: units, and rows of two motions.

#include <cmath>
#include <utility>

namespace floes {

/// What a WAMIT file does not say; NEMOH's is in SI.
struct WamitUnits {
    double density = 1025;  ///< ρ, kg/m³
    double length = 1;      ///< L, ULEN of the GDF file, m
};

/// How many of two motions (0 to 5) are turns: the powers of the length that WAMIT's units have more.
inline int turns_of(int i, int j) {
    return (i >= 3 ? 1 : 0) + (j >= 3 ? 1 : 0);
}

/// The two motions (0 to 5) of a row of WAMIT, which stand in its columns `where`; `wrong` makes the error of the row.
template <class Wrong>
std::pair<int, int> motions_in(double i, double j, const char* where, const Wrong& wrong) {
    if (i != std::floor(i) || j != std::floor(j) || i < 1 || j < 1)
        throw wrong("has something other than numbers of motions in its {}", where);
    if (i > 6 || j > 6) throw wrong("is of a second body, and one body of six motions is read");
    return {static_cast<int>(i) - 1, static_cast<int>(j) - 1};
}

}  // namespace floes
