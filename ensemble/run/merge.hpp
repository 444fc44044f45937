#pragma once
// Merges parts, each computed by a separate run with --part, into one campaign.

#include <filesystem>
#include <functional>
#include <span>

#include "store/journal.hpp"

namespace floes {

/// Is told what was found in the journal of each part.
using OnPart = std::function<void(const std::filesystem::path& journal, const JournalContents& contents)>;

/// Makes the campaign file and its journal from everything in the journals beside `parts`. Parts may be unfinished,
/// still running, or overlapping; the file equals that of an undisturbed run of the same members. Throws InputError if
/// a part cannot be read, if parts belong to different campaigns (naming the keys that differ), if the output is one of
/// the parts, or if it exists and `overwrite` is not set.
void merge_campaigns(std::span<const std::filesystem::path> parts, const std::filesystem::path& output, bool overwrite,
                     const OnPart& on_part);

}  // namespace floes
