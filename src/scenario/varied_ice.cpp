#include "scenario/varied_ice.hpp"

#include <cmath>
#include <numbers>

#include "core/contract.hpp"
#include "core/random.hpp"

namespace floes {

constexpr int waves = 256;

VariedIce::VariedIce(const IceVariation& variation) : correlation_(variation.correlation) {
    FLOES_EXPECTS(variation.length > 0);
    const std::array<const Spread*, count> spreads{&variation.thickness, &variation.strength,
                                                   &variation.elastic_modulus};
    RandomStream random(variation.seed, variation.arrangement, StreamId::level_ice, variation.draw);
    const auto draw_normal = [&] { return normal_at(random.uniform() + 0x1p-54) / variation.length; };
    for (std::size_t property = 0; property < count; ++property) {
        if (spreads[property]->any()) laws_[property].emplace(spreads[property]->factors());
        for (int i = 0; i < waves; ++i) {
            const double x = draw_normal();
            const double z = draw_normal();
            waves_[property].push_back({{x, z}, random.uniform(0, 2 * std::numbers::pi)});
        }
    }
}

double VariedIce::normal(Property property, const Corner& place) const {
    double sum = 0;
    for (const Wave& wave : waves_[property])
        sum += std::cos(wave.number.x * place.x + wave.number.z * place.z + wave.phase);
    // In single precision, so that it does not show that C libraries differ in the last bits of cos().
    return static_cast<float>(std::sqrt(2.0 / waves) * sum);
}

VariedIce::Factors VariedIce::at(const Corner& place) const {
    const auto factor = [&](Property property, double z) { return laws_[property]->at(normal_share(z)); };
    Factors here;
    const double of_thickness = laws_[thickness] ? normal(thickness, place) : 0;
    if (laws_[thickness]) here.thickness = factor(thickness, of_thickness);
    if (laws_[strength])
        here.strength = factor(strength, correlation_ * of_thickness +
                                             std::sqrt(1 - correlation_ * correlation_) * normal(strength, place));
    if (laws_[elastic_modulus]) here.elastic_modulus = factor(elastic_modulus, normal(elastic_modulus, place));
    return here;
}

PlacedIce::PlacedIce(const SingleFloe& floe) : whole_(floe) {
    if (floe.material.variation.length > 0) varied_.emplace(floe.material.variation);
}

const SingleFloe& PlacedIce::at(const Corner& place) {
    if (!varied_) return whole_;
    const VariedIce::Factors factors = varied_->at(place);
    here_ = whole_;
    here_.shape.thickness *= factors.thickness;
    scale_strengths(here_.material.ice, factors.strength);
    here_.material.ice.elastic_modulus *= factors.elastic_modulus;
    return here_;
}

}  // namespace floes
