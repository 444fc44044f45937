#pragma once
// The paper's channel with a scattered field, and figures of many arrangements.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "arrangement/arrangement.hpp"

namespace floes {

inline Scenario scattered_scenario(double concentration = 0.75) {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::scattered;
    scenario.field.concentration = concentration;
    return scenario;
}

/// Of polygons, which break by their joints' moments.
inline Scenario polygon_scenario(ShapeKind kind, double concentration, int floes) {
    Scenario scenario = scattered_scenario(concentration);
    scenario.field.floes = floes;
    scenario.shapes.kind = kind;
    scenario.joint.failure = JointFailure::moment;
    return scenario;
}

inline double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

inline double error_of_mean(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values) squares += std::pow(value - mean(values), 2);
    const auto count = static_cast<double>(values.size());
    return std::sqrt(squares / count / (count - 1));
}

/// Figures of arrangements: [figure][arrangement].
using Figures = std::vector<std::vector<double>>;

template <class Measure>
Figures figures_of(const Scenario& scenario, int count, Measure measure) {
    Figures figures;
    for (int number = 0; number < count; ++number) {
        const std::vector<double> values = measure(make_arrangement(scenario, 1, static_cast<std::uint32_t>(number)));
        figures.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) figures[i].push_back(values[i]);
    }
    return figures;
}

}  // namespace floes
