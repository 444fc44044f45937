#pragma once
// From a file of traced floes to the outlines of a campaign.

#include <string>
#include <vector>

#include "scenario/scenario.hpp"
#include "shapes/polygon.hpp"

namespace floes {

/// One floe of the file: corners (x, -y) in its own unit, without the one that closes a ring.
struct TracedFloe {
    std::string name;   ///< empty: it has none
    std::string where;  ///< begins messages: file, and line or feature
    Outline ring;
    std::vector<Outline> holes;
};

/// Numbers of a file above which it is refused.
inline constexpr std::size_t most_outlines = 10'000;
inline constexpr std::size_t most_ring_corners = 5'000;
inline constexpr std::size_t most_file_corners = 200'000;

/// The longest file of outlines, bytes.
inline constexpr std::size_t longest_outline_file = 32 << 20;

/// Gives `traced` the outlines of the file that its path and unit describe: of at most 16 corners, or 32 where they
/// have bays, with their areas in the file and their names; and empties its path. `text`: of the file; `file`, ending
/// in .geojson, .json or .csv, begins the messages. Throws InputError, a sentence each: for what is no such
/// file or was cut off, for outlines that enclose no area or cross themselves, names that are there twice, floes that
/// share area and rings that are no holes (campaign/shared_area.hpp), sizes that are those of degrees, and coordinates
/// of so few digits that the area of a floe may be off by more than a tenth.
void take_outlines(TracedOutlines& traced, const std::string& text, const std::string& file);

}  // namespace floes
