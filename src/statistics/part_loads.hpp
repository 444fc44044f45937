#pragma once
// Loads on the parts of a structure.

#include <array>
#include <vector>

#include "statistics/averaged_load.hpp"

namespace floes {

/// Of the steps of the window.
struct PartLoad {
    double mean = 0;        ///< surge load, N
    double sd = 0;          ///< population standard deviation of the surge load, N
    double maximum = 0;     ///< largest surge load, N
    double mean_sway = 0;   ///< N, towards +z
    double mean_heave = 0;  ///< N, upwards
    /// Mean of the segment maxima of the surge load's running means over each averaging time, N.
    std::vector<double> mean_maximum{};
    /// The same of the sum of the magnitudes of the normal forces, N: what presses on its surface, whichever way the
    /// surface faces. Over an area it is the pressure averaged over that.
    std::vector<double> normal_maximum{};
};

/// What acts on a part at every step of the window, as averaged_load() takes it, N.
struct PartHistory {
    std::vector<double> surge, sway, heave, normal;

    std::array<std::vector<double>*, 4> all() { return {&surge, &sway, &heave, &normal}; }
};

PartLoad part_load(const PartHistory& part, const Averaging& how);

}  // namespace floes
