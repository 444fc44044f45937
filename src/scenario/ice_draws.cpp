#include "scenario/ice_draws.hpp"

#include <cmath>
#include <optional>

#include "core/random.hpp"
#include "laws/brine.hpp"

namespace floes {
namespace {

/// Which draw of which part.
std::uint64_t of_part(const Scenario& scenario, const Draw& draw) {
    return static_cast<std::uint64_t>(scenario.spread.draw) + (draw.part << 32U);
}

/// The factors of one property, floe after floe.
class PropertyDraws {
  public:
    PropertyDraws(const Spread& spread, const Scenario& scenario, const Draw& draw, StreamId stream)
        : random_(draw.seed, draw.number, stream, of_part(scenario, draw)) {
        if (spread.any()) factors_.emplace(spread.factors());
    }

    /// Of the next floe; one draw, whether or not there is a law.
    double next() { return at(share()); }

    double share() { return random_.uniform(); }
    double at(double share) const { return factors_ ? factors_->at(share) : 1; }

  private:
    RandomStream random_;
    std::optional<Factors> factors_;
};

void scale_strengths(Ice& ice, double factor) {
    for (double* strength : {&ice.bending_strength, &ice.compressive_strength, &ice.shear_strength,
                             &ice.tensile_strength, &ice.torsion_strength, &ice.in_plane_bending_strength})
        *strength *= factor;
}

void follow_brine(Ice& ice, double salinity, double temperature) {
    const double brine = brine_volume(salinity, temperature);
    scale_strengths(ice, static_cast<float>(flexural_strength(brine) / ice.bending_strength));
    ice.elastic_modulus = static_cast<float>(brine_modulus(brine));
}

}  // namespace

bool IceSpread::any() const {
    return thickness.any() || strength.any() || elastic_modulus.any() || density.any() || salinity.any() ||
           temperature.any() || weakened > 0;
}

double least_factor(const Spread& spread) {
    return spread.any() ? Factors(spread.factors()).low() : 1;
}

double largest_factor(const Spread& spread) {
    return spread.any() ? Factors(spread.factors()).high() : 1;
}

void draw_ice(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes) {
    const IceSpread& spread = scenario.spread;
    const auto draws = [&](const Spread& one, StreamId stream) { return PropertyDraws(one, scenario, draw, stream); };
    PropertyDraws thickness = draws(spread.thickness, StreamId::ice_thickness);
    PropertyDraws strength = draws(spread.strength, StreamId::ice_strength);
    PropertyDraws modulus = draws(spread.elastic_modulus, StreamId::ice_modulus);
    PropertyDraws density = draws(spread.density, StreamId::ice_density);
    PropertyDraws salinity = draws(spread.salinity, StreamId::ice_salinity);
    PropertyDraws temperature = draws(spread.temperature, StreamId::ice_temperature);
    RandomStream weakened(draw.seed, draw.number, StreamId::weakened_ice, of_part(scenario, draw));
    const double correlation = spread.thickness.any() && spread.strength.any() ? spread.correlation : 0;
    for (SingleFloe& floe : floes) {
        const double of_thickness = thickness.share();
        double of_strength = strength.share();
        if (correlation != 0)
            of_strength = normal_share(correlation * normal_at(of_thickness) +
                                       std::sqrt(1 - correlation * correlation) * normal_at(of_strength));
        floe.shape.thickness *= thickness.at(of_thickness);
        Ice& ice = floe.material.ice;
        const double salt = scenario.brine.salinity * salinity.next();
        const double cold = scenario.brine.temperature * temperature.next();
        if (scenario.brine.salinity > 0) follow_brine(ice, salt, cold);
        scale_strengths(ice, strength.at(of_strength));
        if (weakened.uniform() < spread.weakened) scale_strengths(ice, spread.weakened_to);
        ice.elastic_modulus *= modulus.next();
        ice.density *= density.next();
    }
}

}  // namespace floes
