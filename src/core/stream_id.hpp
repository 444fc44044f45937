#pragma once
// Every use of random numbers has a name here. Never change a number: that would change the arrangements.

#include <cstdint>

namespace floes {

enum class StreamId : std::uint32_t {
    monte_carlo = 1,      ///< trial moves of the hard-rectangle Monte Carlo
    lattice_jitter = 2,   ///< shifts and turns of the jittered lattice
    bootstrap = 3,        ///< resampling of arrangements in statistics
    goodness_of_fit = 4,  ///< samples from a fitted distribution
    latin_hypercube = 5,  ///< points of a design
    sobol_shift = 6,      ///< the random digital shift of a design's Sobol sequence
};

}  // namespace floes
