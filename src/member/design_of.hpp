#pragma once
// What a design value can be of: the load, and how a structure gives way under it and what then holds it.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "member/member_outputs.hpp"
#include "scenario/scenario.hpp"
#include "shapes/moorings.hpp"
#include "simulation/record.hpp"

namespace floes {

/// All but the load are of structures that give way.
struct DesignOf {
    std::string_view word;     ///< of the option --of, and of stop.of
    std::string_view title;    ///< "Design offset"
    std::string_view largest;  ///< "offset along the surge load"
    std::string_view noun;     ///< of one value: "offset"
    std::string_view unit;     ///< SI
    /// At the end of a step; null of the load, which members average.
    double (*value)(const Moorings& moorings, const MotionHistory& motion, std::size_t step) = nullptr;
    /// It is of structures that give way in one of them, and its peaks are their longest natural period apart.
    std::array<Motion, 2> motions{Motion::surge, Motion::surge};
    bool part = false;  ///< along one axis, of what another is the whole of: told where it is asked for
    bool (*has)(const Moorings& moorings) = nullptr;  ///< whether a structure has it; null: each has

    /// Whether members of the scenario have it.
    bool is_of(const Scenario& scenario) const;
    /// "surge or sway": the motions that it is of.
    std::string motion_words() const;
    /// Of the scale, by Froude.
    int power() const { return unit == "N" ? 3 : unit == "m" ? 1 : 0; }
    /// For people, who are shown angles in degrees.
    std::string_view shown_unit() const { return unit == "rad" ? "°" : unit; }
    double shown_factor() const { return unit == "rad" ? 1 / unit::degree : 1; }
};

/// The first one is the load.
extern const std::array<DesignOf, 12> design_ofs;

/// Without the load: Response k of a member is of the k-th of them.
inline std::span<const DesignOf> response_kinds() {
    return std::span(design_ofs).subspan(1);
}

/// The one of this word; nullptr where there is none.
const DesignOf* find_design_of(std::string_view word);

/// What the member has of it; nullptr of the load, and of members that have no responses.
const Response* response_of(const MemberOutputs& outputs, const DesignOf& of);

/// s, the longest natural period of the motions that it follows from; 0 where they are held, and of the load.
double period_of(const Scenario& scenario, const DesignOf& of);

/// s, between its peaks that count as two: not below analysis.peak_separation, the natural period, and the time in
/// which the hull's own damping, that of waves included, lets a swing fall to 1/e, since the swings of one event are
/// one. Without damping of its own only the ice lets it fade.
double separation_of(const Scenario& scenario, const DesignOf& of);

/// In the window, one of each of response_kinds(), not measured where the scenario has none of it; empty of structures
/// that do not give way. `motion`: of every step of the run.
std::vector<Response> responses_of(const Scenario& scenario, const MotionHistory& motion);

}  // namespace floes
