#pragma once
// The same scene at another size, by Froude's law: lengths, strengths, moduli and pressures times s, times and speeds
// times the square root of s, so that masses and forces are s³ times as large. With s a power of 4 every number keeps
// its bits but for the exponent.

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "scenario/keys.hpp"

namespace floes::test {

/// What a key is multiplied with: its unit is the end of its name. 1 without a unit.
inline double froude_factor(std::string_view name, double s) {
    const double root = std::sqrt(s);
    const std::map<std::string, double> factors{{"m", s},   {"s", root}, {"m_s", root},   {"m_s2", 1},
                                                {"kPa", s}, {"MPa", s},  {"N", s * s * s}};
    std::string longest;
    double factor = 1;
    for (const auto& [unit, by] : factors) {
        if (name.ends_with("_" + unit) && unit.size() > longest.size()) {
            longest = unit;
            factor = by;
        }
    }
    return factor;
}

inline void scale(const RowsField& field, double s) {
    std::vector<std::vector<double>> rows = field.get();
    for (std::vector<double>& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) row[i] *= froude_factor(field.columns[i].name, s);
    }
    field.set(rows);
}

inline Scenario scaled(Scenario scenario, double s) {
    for (const Key& key : describe(scenario)) {
        if (key.derived()) continue;  // scaled with what it says
        const double factor = froude_factor(key.path, s);
        if (const auto* number = std::get_if<NumberField>(&key.field)) number->set(factor * number->get());
        if (const auto* numbers = std::get_if<NumbersField>(&key.field)) {
            for (double& value : *numbers->values) value *= factor;
        }
        if (const auto* rows = std::get_if<RowsField>(&key.field)) scale(*rows, s);
    }
    return scenario;
}

inline std::vector<PlanarPose> scaled(std::vector<PlanarPose> poses, double s) {
    for (PlanarPose& pose : poses) {
        pose.x *= s;
        pose.z *= s;
    }
    return poses;
}

}  // namespace floes::test
