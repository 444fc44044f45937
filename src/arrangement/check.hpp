#pragma once
// The final check of an arrangement: every pair of floes, every wall, the concentration.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arrangement/crowd.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// The outline of each floe in its own axes.
std::vector<Outline> outlines_of(const FloeSet& floes);

/// The same of floes that are rectangles.
std::vector<Rectangle> rectangles(const FloeSet& floes);

/// An outline where it lies, in the world's (x, z).
Outline on_water(Corners outline, const PlanarPose& pose);

/// The outline of each floe where it lies, in the world's (x, z).
std::vector<Outline> outlines_on_water(const FloeSet& floes);

/// The walls of the scenario's ice field: x from field.begin to field_end(), |z| <= half_width.
Walls field_walls(const Scenario& scenario);

struct Fault {
    std::string sentence;
    std::vector<std::size_t> floes = {};  ///< that it is about, as numbers of poses; of most faults none, one or two
};

/// The first fault of floes as an arrangement of the scenario; nothing if there is none. Faults are a different number
/// of floes, a floe closer than the clearance to a wall or to another floe (by more than a nanometre, to allow for
/// rounding), and a concentration whose relative difference from the scenario's exceeds 1e-12 (1e-4 of polygons). Two
/// floes are too close if they overlap with half the clearance added on every side; between a corner and a side this
/// requires up to 1.21 times the clearance.
std::optional<Fault> find_fault(const Scenario& scenario, const FloeSet& floes);

/// The first of outlines about their centroids that is nearer than the clearance (less a nanometre) to an earlier one,
/// or to the sides of `walls`, in words; nothing if none is. Poses and outlines one by one.
std::optional<std::string> nearness_fault(const Walls& walls, std::span<const Outline> outlines,
                                          std::span<const PlanarPose> poses, double clearance);

/// Throws RunError if a part of a field without end that was laid has a fault, which is an error of the program.
void expect_none(const std::optional<std::string>& fault, std::uint64_t part, std::uint32_t arrangement);

}  // namespace floes
