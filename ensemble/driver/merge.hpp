#pragma once
// One campaign out of parts that were computed apart, each by a run of its own with --part.

#include <filesystem>
#include <span>

namespace floes {

/// Makes the campaign file and its journal of everything that the journals beside `parts` hold. Parts may be
/// unfinished, at work, or overlap; the file is the one that an undisturbed run of the same members gives. Throws
/// InputError when a part cannot be read, when parts belong to different campaigns (the differing keys named), when the
/// output is one of them, or is there already and `overwrite` is not set.
void merge_campaigns(std::span<const std::filesystem::path> parts, const std::filesystem::path& output, bool overwrite);

}  // namespace floes
