#pragma once
// What of a run is to be seen where it is largest: the load, or what the moorings of a hull that gives way feel. Its
// history over the steps is the same in the choice of a moment, in strips of pictures and in `floes design --of`.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/simulation.hpp"

namespace floes {

/// In the order of asked_names.
enum class AskedOf : std::uint8_t {
    load,           ///< surge load of the ice, N
    mooring_force,  ///< horizontal resultant of springs, lines and turret, N
    offset,         ///< horizontal, of the turret, without one of the hull's axis, m
    tension         ///< of the line that has most, N
};

inline constexpr std::array<std::string_view, 4> asked_names{"load", "mooring_force", "offset", "tension"};

constexpr std::string_view name_of(AskedOf of) {
    return asked_names.at(static_cast<std::size_t>(of));
}
/// None of another word.
std::optional<AskedOf> asked_of(std::string_view name);

struct Asked {
    AskedOf of = AskedOf::load;
    double averaging = 0;  ///< s, of a running mean of load or mooring force; below a step: of single steps

    /// Offset and tension swing slowly: they are taken as they are.
    bool averaged() const { return averaging > 0 && (of == AskedOf::load || of == AskedOf::mooring_force); }
    /// "load of a step", "mooring force over 1 s", "offset", "line tension".
    std::string words() const;
    /// Over what the largest is meant: "in the window"; of tension "over the run", of which alone files have it.
    std::string_view within() const { return of == AskedOf::tension ? "over the run" : "in the window"; }
    /// SI.
    std::string_view unit() const { return of == AskedOf::offset ? "m" : "N"; }

    friend bool operator==(const Asked&, const Asked&) = default;
};

/// How a hull that gives way moved on its moorings, at the end of each step; all empty of others.
struct HullHistory {
    std::vector<double> mooring_force;  ///< horizontal resultant, N
    std::vector<double> offset;         ///< horizontal, as AskedOf has it, m
    std::vector<double> yaw;            ///< about +y: +z turns to +x, rad
    std::vector<double> tension;        ///< of the line that has most, N; 0 once all have broken, empty without lines

    /// What the last step of the run adds.
    void add_last(const Simulation& run, const Moorings& moorings);
};

/// The mean of `count` values round each, of an even count one more before it than after it; near the ends that of the
/// nearest `count`.
std::vector<double> running_mean(std::span<const double> values, std::size_t count);

/// So many values, `step` s apart, are averaged.
std::size_t averaged_values(const Asked& asked, double step);

/// Why the asked mean is not one of a window, s, of values `step` s apart: it is longer, or shorter than a step. Empty
/// where it is, and where no mean is asked.
std::string averaging_refusal(const Asked& asked, double step, double window);

/// What is asked of histories with values `step` s apart; the mean of `asked.averaging` stands in its middle.
std::vector<double> asked_history(const Asked& asked, std::span<const double> values, double step);
/// Empty where the run has none.
std::vector<double> asked_history(const Asked& asked, const LoadHistory& loads, const HullHistory& hull, double step);

}  // namespace floes
