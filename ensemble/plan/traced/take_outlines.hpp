#pragma once
// From a file of traced floes to the outlines of a campaign.

#include <string>

#include "scenario/scenario.hpp"

namespace floes {

/// The longest file of outlines, bytes.
inline constexpr std::size_t longest_outline_file = 32 << 20;

/// Gives `traced` the outlines of the file that its path and unit describe: convex, of at most 16 corners, with their
/// areas in the file and their names; and empties its path. `text`: of the file; `file`, ending in .geojson, .json or
/// .csv, begins the messages. Throws InputError, a sentence each: as read_geojson() and read_outline_csv() do, and for
/// outlines that enclose no area or cross themselves, names that are there twice, and sizes that are those of degrees.
void take_outlines(TracedOutlines& traced, const std::string& text, const std::string& file);

}  // namespace floes
