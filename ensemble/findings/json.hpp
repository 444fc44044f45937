#pragma once
// The parts of the JSON that `floes summarize` prints. For this room only.

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "findings/findings.hpp"

namespace floes {

using Json = nlohmann::ordered_json;  // keys in the order of writing

/// null where undefined.
inline Json json_number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

inline Json json_estimate(double estimate, double low, double high) {
    return {{"estimate", json_number(estimate)}, {"low", json_number(low)}, {"high", json_number(high)}};
}

inline Json json_limits(const Limits& limits) {
    return {{"low", json_number(limits.low)}, {"high", json_number(limits.high)}};
}

Json summary_as_json(const Summary& summary, Reference reference);
Json extremes_as_json(const Summary& summary, const std::vector<CaseExtremes>& extremes, bool exceedance);
Json levels_as_json(const Summary& summary, const std::vector<LevelRow>& rows);
Json steady_as_json(const Summary& summary, const SteadyReport& steady);
Json points_as_json(const DesignPoints& points);
Json sensitivity_as_json(const Sensitivity& found);
Json pairs_as_json(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options);

}  // namespace floes
