#pragma once
// The hybrid model of Uto et al. (2015) as the paper uses it: the mean load is the smaller of the load that breaks the
// floes (limit stress, Lindqvist) and the load that pushes them aside (limit momentum, KPR). R_F = min(R_LS, R_LM),
// R_LS = IC R_LF (Eq. (6)), R_LM = R_SF (Eq. (7)).

#include <optional>
#include <span>
#include <vector>

#include "scenario/scenario.hpp"
#include "theory/level_ice.hpp"

namespace floes {

class HybridModel {
  public:
    /// `ice` without its modulus, which is the argument of the functions below. `concentration` IC in (0, 1],
    /// `floe_length` m, `speed` m/s. Throws InputError as lindqvist_load() does.
    HybridModel(const IceHull& hull, const LevelIce& ice, double concentration, double floe_length, double speed);

    /// The same with the KPR static coefficient k1 that makes both limits cross at a modulus (Pa), k2 = k3 = 0: one
    /// free constant from one known value, which is a calibration and not a test. At model speed the other two parts
    /// are below 1 % of the static one.
    HybridModel crossing_at(double elastic_modulus) const;
    HybridModel with(const KprCoefficients& coefficients) const;

    LindqvistLoad limit_stress(double elastic_modulus) const;  ///< R_LS by component, N; E in Pa, > 0
    double limit_momentum() const;                             ///< R_LM, N
    double load(double elastic_modulus) const;                 ///< R_F, N

    /// The modulus (Pa) at which both limits are equal: floes break above it. Empty if R_LM is below R_LS at any E.
    std::optional<double> crossing() const;

    const KprCoefficients& coefficients() const { return coefficients_; }

  private:
    IceHull hull_;
    LevelIce ice_;
    double concentration_;
    double floe_length_;
    double speed_;
    KprCoefficients coefficients_;
};

// The hybrid model over the elastic modulus for a scenario: Fig. 8.

/// Loads at one modulus, N.
struct HybridPoint {
    double elastic_modulus = 0;        ///< Pa
    double characteristic_length = 0;  ///< of a floating plate of this modulus, m
    LindqvistLoad limit_stress;        ///< by component
    double limit_momentum = 0;
    double load = 0;  ///< the smaller of the two limits
};

struct HybridCurve {
    IceHull hull;
    KprCoefficients coefficients;
    std::vector<HybridPoint> points;
    std::optional<double> crossing;  ///< Pa; none when floes are pushed aside at any modulus
};

/// The ship dimensions of Lindqvist's formula for a body of revolution: breadth and length are the waterline diameter,
/// the ice meets the wall squarely (α = 90 degrees), and the wall angle is the one just above the waterline (Table 2).
/// Throws InputError if the wall is vertical or overhangs there.
IceHull hull_of(const Scenario& scenario);

/// The ice of the scenario's floes, without a modulus.
LevelIce level_ice_of(const Scenario& scenario);

/// The model without KPR coefficients. Throws InputError as hull_of() and lindqvist_load() do.
HybridModel hybrid_model(const Scenario& scenario);

/// The curve at these moduli (Pa, > 0), in their order.
HybridCurve hybrid_curve(const Scenario& scenario, const HybridModel& model, std::span<const double> moduli);

}  // namespace floes
