#pragma once
// Loads on the parts of a structure.

#include <span>
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
};

/// Loads of one part at every step of the window, as averaged_load() takes it.
PartLoad part_load(std::span<const double> surge, std::span<const double> sway, std::span<const double> heave,
                   const Averaging& how);

}  // namespace floes
