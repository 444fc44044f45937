#pragma once
// Whether a file of floes is as it was written: a campaign file, a record of a replay or a journal.

#include <filesystem>
#include <string>
#include <vector>

#include "store/journal.hpp"

namespace floes {

enum class FileState { good, damaged, not_of_floes, newer, open_elsewhere };

struct FileVerdict {
    std::string file = {};
    std::string kind = {};  ///< "campaign file", "record", "journal"; empty where it is none of these
    FileState state = FileState::good;
    std::string counts = {};               ///< what was checked: "84 datasets", "12 members, 2 sessions"
    std::string digest = {};               ///< over the contents of an HDF5 file; empty where it has none
    std::vector<std::string> notes = {};   ///< sentences: what is worth knowing about a good file
    std::vector<std::string> faults = {};  ///< sentences: what is damaged, one a dataset or part of a journal
    std::string whole = {};                ///< a sentence: which members are still good
    std::string remedy = {};               ///< a sentence: what to do
};

/// Reads the whole file. Damage is reported in the result, not thrown.
FileVerdict verify_file(const std::filesystem::path& path);

/// The same of a journal whose `contents` were read already.
FileVerdict judge_journal(const std::filesystem::path& path, const JournalContents& contents);

}  // namespace floes
