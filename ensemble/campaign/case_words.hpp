#pragma once
// What a case is, in words.

#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// "24 floes of 0.6 m x 0.6 m, 0.033 m thick, in cells of 0.2 m, at 75 %, scattered at random", of every law of sizes
/// and shapes.
std::string floe_words(const Scenario& scenario);

/// "towed at 0.1 m/s", "led along a path", or of a structure that gives way its mass, what is free, what holds it and
/// how fast the ice comes.
std::string motion_words(const Scenario& scenario);

/// Sentences that differ in numbers only as one, with the range of each number: "towed at 0.1 to 0.2 m/s". None where
/// they differ in more.
std::optional<std::string> with_ranges(const std::vector<std::string>& sentences);

/// What laws of sizes, shapes and ice came to, and what the hull is, for each case where that is not in its keys: how
/// many floes, their sizes, shares of the area, elements and field, mean and standard deviation of what is drawn in
/// arrangement 0; of a hull that is moored or no profile what it displaces. A case with the words of an earlier one has
/// none; of the points of a design that differ in numbers only, one sentence has the ranges.
std::vector<std::string> case_words(const Campaign& campaign);

}  // namespace floes
