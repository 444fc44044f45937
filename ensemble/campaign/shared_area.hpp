#pragma once
// How much of a traced floe lies in another one.

#include <cstddef>
#include <span>
#include <string>

#include "campaign/outline_file.hpp"
#include "shapes/polygon.hpp"

namespace floes {

/// Of a hole: what may lie outside of its floe or in another hole.
inline constexpr double most_beside = 0.01;

/// Of the smaller of two floes: what may lie in the other one, as where neighbours were traced roughly.
inline constexpr double most_shared = 0.5;

/// How much of what `of` encloses lies in what `other` encloses, as a share, along lines through `of`. Of several rings
/// a point lies within where it lies in an odd number of them, so holes are none of it.
double share_within(std::span<const Outline> of, std::span<const Outline> other);

/// Throws InputError, beginning with where the second of the two is: for a hole that lies outside of its floe or in
/// another hole, by more than most_beside; and for two floes that share more than most_shared of the smaller, whatever
/// their names. `file`: of all; it is refused where so many boxes overlap that to look takes more than some seconds.
void refuse_shared_area(std::span<const TracedFloe> floes, const std::string& file);

}  // namespace floes
