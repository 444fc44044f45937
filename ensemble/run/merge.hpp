#pragma once
// Merges parts, each computed by a separate run with --part, into one campaign.

#include <filesystem>
#include <span>

#include "run/parts.hpp"

namespace floes {

/// Makes the campaign file and its journal from everything in the journals beside `parts`, and from what `output` has
/// already: a merge takes what is new. Parts may be unfinished, still running, or overlapping. The file equals that of
/// an undisturbed run of the same members, which a stop rule ends. Returns what was read. `overwrite`: what `output`
/// has is replaced. Throws InputError if a part cannot be read, if parts or output belong to different campaigns
/// (naming the keys that differ), if the output is one of the parts or is being written, or if it has no journal.
Parts merge_campaigns(std::span<const std::filesystem::path> parts, const std::filesystem::path& output,
                      bool overwrite);

}  // namespace floes
