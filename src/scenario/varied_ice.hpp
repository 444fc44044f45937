#pragma once
// Ice that varies within a floe: thickness, strength and modulus as random fields with a correlation length.
//
// Behind each property is a normal field of N waves (Shinozuka 1971, from memory),
//
//   Z(x) = √(2/N) ∑ cos(k_i · x + φ_i),   k_i normal with the standard deviation 1/a in either direction, φ_i even,
//
// whose correlation is exp(-r²/(2 a²)) at a distance r, on average over draws. The factor at x is that which a share
// Φ(Z) of the property's law is below. A field is a function of its draw and the place: no grid, no order.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/vector.hpp"
#include "scenario/floes.hpp"
#include "scenario/laws.hpp"
#include "scenario/scenario.hpp"

namespace floes {

class VariedIce {
  public:
    /// variation.length > 0
    explicit VariedIce(const IceVariation& variation);

    struct Factors {
        double thickness = 1;
        double strength = 1;  ///< of all strengths
        double elastic_modulus = 1;
    };

    /// At a place in the axes of the floe, m from its centroid.
    Factors at(const Corner& place) const;

  private:
    struct Wave {
        Corner number;  ///< 1/m
        double phase;   ///< rad
    };
    enum Property : std::size_t { thickness, strength, elastic_modulus, count };

    double normal(Property property, const Corner& place) const;

    std::array<std::optional<floes::Factors>, count> laws_;
    std::array<std::vector<Wave>, count> waves_;
    double correlation_;
};

/// A floe as it is at a place: all of it, where it does not vary.
class PlacedIce {
  public:
    explicit PlacedIce(const SingleFloe& floe);

    /// In the axes of the floe, m from its centroid. Valid until the next call.
    const SingleFloe& at(const Corner& place);

  private:
    SingleFloe whole_, here_;
    std::optional<VariedIce> varied_;
};

}  // namespace floes
