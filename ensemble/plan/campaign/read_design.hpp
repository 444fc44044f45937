#pragma once
// From [[design.axis]] blocks to a checked design. For this room only.

#include <map>
#include <string>
#include <vector>

#include "campaign/design.hpp"
#include "keys/read.hpp"

namespace floes {

/// Where each key was last set, for messages: path -> "table3.toml:12".
using Origins = std::map<std::string, std::string>;

inline constexpr const char* axis_block = "design.axis";

/// Puts the axes of the blocks named axis_block into `design`, whose table has been read, and checks it as a whole:
/// keys of a scenario, each once; values, or from below to, that each key takes; points that the method wants; no more
/// than most_cases points. Gives the axes' places by key. Throws InputError, one sentence.
Origins read_axes(const std::vector<Block>& blocks, const Origins& origins, const std::string& file, Spelling spelling,
                  Design& design);

}  // namespace floes
