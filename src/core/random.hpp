#pragma once
// Counter-based random numbers: a draw is a pure function of the stream and the number of its earlier draws, so any
// rank, thread and order gives the same numbers. Generator: Philox4x32-10, J. K. Salmon et al., "Parallel random
// numbers: as easy as 1, 2, 3", SC11 (2011), from the Random123 library.
//
// A Philox block has a counter of 128 bits; arrangement, stream, geometry and draw need 192. So one block, keyed by the
// campaign's seed, turns (arrangement, stream, geometry) into the 64-bit key of the stream, and under that key the
// counter is (draw, arrangement, stream): two streams of one geometry always differ, those of two geometries unless two
// 64-bit keys happen to be equal.

#include <array>
#include <cstdint>

namespace floes {

/// Every use of random numbers has a name here. A number once given stays: changing it changes the arrangements.
enum class StreamId : std::uint32_t {
    monte_carlo = 1,      ///< trial moves of the hard-rectangle Monte Carlo
    lattice_jitter = 2,   ///< shifts and turns of the jittered lattice
    bootstrap = 3,        ///< resampling of arrangements in statistics
    goodness_of_fit = 4,  ///< samples from a fitted distribution
    latin_hypercube = 5,  ///< points of a design
    sobol_shift = 6,      ///< the random digital shift of a design's Sobol sequence
    scattering = 7,       ///< first poses of scattered floes, and those of floes that are thrown again
    ordering = 8,         ///< trial moves of the Monte Carlo that orders scattered floes
    floe_sizes = 9,       ///< which floe has which size, where they differ
    ice_thickness = 10,   ///< factors of single floes, here and below
    ice_strength = 11,
    ice_modulus = 12,
    ice_density = 13,
    ice_salinity = 14,
    ice_temperature = 15,
    weakened_ice = 16,  ///< which floes are weaker than the others
    level_ice = 17,     ///< waves of the random fields within level ice
    voronoi = 20,       ///< points whose Voronoi cells are floes
    polygons = 21,      ///< corners of single floes
    elements = 22,      ///< points whose Voronoi cells are the elements of a floe
};

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// One block of Philox4x32-10: the four random words of a counter under a key.
PhiloxCounter philox(const PhiloxCounter& counter, const PhiloxKey& key);

/// The random numbers of one purpose in one arrangement of one field geometry.
class RandomStream {
  public:
    /// seed: of the campaign; arrangement: its number; geometry: geometry_key() of the scenario.
    RandomStream(std::uint64_t seed, std::uint32_t arrangement, StreamId stream, std::uint64_t geometry);

    /// Uniform in [0, 1), a multiple of 2^-53. One draw.
    double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

    /// Uniform between low and high. One draw.
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform in 0 … n - 1 without bias, n >= 1. One draw, rarely more (D. Lemire, ACM TOMACS 29(1), 2019).
    std::uint32_t below(std::uint32_t n);

    /// Number of 64-bit words handed out so far.
    std::uint64_t draws() const { return draws_; }

  private:
    std::uint64_t next() {
        if (draws_ % words_.size() == 0) refill();
        return words_[draws_++ % words_.size()];
    }
    void refill();

    PhiloxKey key_;
    std::uint32_t arrangement_;
    std::uint32_t stream_;
    std::uint64_t draws_ = 0;
    std::array<std::uint64_t, 8>
        words_{};  // four blocks at a time: they are independent, so the processor overlaps them
};

}  // namespace floes
