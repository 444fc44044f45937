#include "theory/hybrid.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

HybridModel::HybridModel(const IceHull& hull, const LevelIce& ice, double concentration, double floe_length,
                         double speed)
    : hull_(hull), ice_(ice), concentration_(concentration), floe_length_(floe_length), speed_(speed) {
    limit_stress(1);  // throws for a hull without a load
}

HybridModel HybridModel::with(const KprCoefficients& coefficients) const {
    HybridModel model = *this;
    model.coefficients_ = coefficients;
    return model;
}

HybridModel HybridModel::crossing_at(double elastic_modulus) const {
    const double unit_load = with({.static_part = 1}).limit_momentum();
    return with({.static_part = limit_stress(elastic_modulus).total() / unit_load});
}

LindqvistLoad HybridModel::limit_stress(double elastic_modulus) const {
    LevelIce ice = ice_;
    ice.elastic_modulus = elastic_modulus;
    const LindqvistLoad level = lindqvist_load(hull_, ice, speed_);
    return {concentration_ * level.crushing, concentration_ * level.bending, concentration_ * level.submergence};
}

double HybridModel::limit_momentum() const {
    return kpr_load(coefficients_, hull_, ice_, floe_length_, speed_).total();
}

double HybridModel::load(double elastic_modulus) const {
    return std::min(limit_stress(elastic_modulus).total(), limit_momentum());
}

std::optional<double> HybridModel::crossing() const {
    const LindqvistLoad soft = limit_stress(1);  // bending at E is that at 1 Pa over √E
    const double excess = limit_momentum() - (soft.crushing + soft.submergence);
    if (!(excess > 0)) return std::nullopt;
    return std::pow(soft.bending / excess, 2);
}

}  // namespace floes
