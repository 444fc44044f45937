#pragma once
// What a campaign is, in words: its cases, and what is allowed but odd.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "core/words.hpp"

namespace floes {

/// "24 floes of 0.6 m x 0.6 m, 0.033 m thick, in cells of 0.2 m, at 75 %, scattered at random", of every law of sizes
/// and shapes.
Words floe_words(const Scenario& scenario);

/// "the drift turns by 30°", between its most different headings; empty of a path that does not turn, or of a table.
Words turn_words(const Path& path);

/// Length and width of the hull at the calm water, m.
Vec2 waterline_size(const Shape& shape);

/// "towed at 0.1 m/s", "led along a path", or of a structure that gives way its mass, what is free, what holds it and
/// how fast the ice comes.
Words motion_words(const Scenario& scenario);

/// What laws of sizes, shapes and ice came to, and what the hull is, for each case where that is not in its keys: how
/// many floes, their sizes, shares of the area, elements and field, mean and standard deviation of what is drawn in
/// arrangement 0; of a hull that is moored or no profile what it displaces. A case with the words of an earlier one has
/// none; of the points of a design that differ in numbers only, one sentence has the ranges.
std::vector<std::string> case_words(const Campaign& campaign);

/// "No hull is stated: …" where some case has the default hull and says neither that nor that it is about the paper;
/// empty otherwise.
std::string hull_remark(const Campaign& campaign);

// What is allowed but odd.

/// Fewest natural periods of a hull that gives way in a window: with fewer, its largest offset is one swing, and it has
/// no design value.
inline constexpr double fewest_periods = 3;

/// A sentence for each oddity, which quotes the case that has it most and names or counts the others:
/// elements no smaller than the characteristic length l_c = (E T³ / (12 (1 - ν²) ρ_w g))^(1/4) of the ice, within which
/// it bends and breaks (the paper's advice, with ν = 0.3); elements thicker than wide; hardly any ice; a strength that
/// no ice has; ice that crushes more easily than it bends; few sweeps; long steps; a gap between structure and bank of
/// less than two floes; a structure that is hardly heavier than a floe; one that weighs more or less than the water
/// that it displaces; added mass by a number and by a matrix; a window that begins before the hull meets the ice; and
/// one of less than `fewest_periods`.
std::vector<std::string> advice(const Campaign& campaign);

}  // namespace floes
