#pragma once
// The result of one member: a row of Table 3, its load histories, its break log and its initial arrangement.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "ice/failure_mode.hpp"
#include "member/member_outputs.hpp"
#include "scenario/floes.hpp"
#include "simulation/record.hpp"
#include "statistics/load_map.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

enum class MemberStatus : std::int8_t { done = 0, failed = 1 };

/// The result of one member. For a failed member only status, reason, arrangement and what was recorded before the
/// failure are valid.
struct MemberResult : MemberOutputs {
    static constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

    MemberStatus status = MemberStatus::done;
    std::string reason;                ///< of a failure, a sentence; empty when done
    std::vector<LevelCount> levels;    ///< of the surge load in the window, in the order of analysis.exceedance_levels
    LoadMap load_map;                  ///< empty: of an earlier version
    LoadHistory history;               ///< from t = 0 to the end of the run, as analysis keeps it
    BedHistory bed;                    ///< likewise, of a bed
    MotionHistory motion;              ///< likewise, of a structure that is not towed straight on
    std::vector<double> line_tension;  ///< largest of each mooring line, N
    std::vector<double> line_broken_at;   ///< s, of each mooring line; NaN: it holds
    std::vector<BreakEvent> breaks;       ///< in order of time, then floe, then joint
    std::vector<PieceArea> piece_areas;   ///< of the floes that are cracked through at the end, by floe
    std::vector<PlanarPose> arrangement;  ///< floe poses at t = 0
    std::vector<double> floe_properties;  ///< properties_of() the floes
    double psi4 = 0;                      ///< of the arrangement
    double wall_time = 0;                 ///< s; provenance only
    double cpu_time = not_measured;       ///< s, of the thread that computed it; provenance only
};

// What a campaign file keeps of single floes where they differ.

struct FloeProperty {
    const char* name;
    double (*of)(const FloeShape&, const Material&);  ///< SI
};

inline constexpr std::array floe_properties{
    FloeProperty{"length", [](const FloeShape& shape, const Material&) { return shape.length; }},
    FloeProperty{"breadth", [](const FloeShape& shape, const Material&) { return shape.breadth; }},
    FloeProperty{"thickness", [](const FloeShape& shape, const Material&) { return shape.thickness; }},
    FloeProperty{"element", [](const FloeShape& shape, const Material&) { return shape.element; }},
    FloeProperty{"density", [](const FloeShape&, const Material& of) { return of.ice.density; }},
    FloeProperty{"elastic_modulus", [](const FloeShape&, const Material& of) { return of.ice.elastic_modulus; }},
    FloeProperty{"bending_strength", [](const FloeShape&, const Material& of) { return of.ice.bending_strength; }},
    FloeProperty{"compressive_strength",
                 [](const FloeShape&, const Material& of) { return of.ice.compressive_strength; }},
    FloeProperty{"shear_strength", [](const FloeShape&, const Material& of) { return of.ice.shear_strength; }},
};

/// A row for each floe, in the order of the list.
std::vector<double> properties_of(const FloeSet& floes);

}  // namespace floes
