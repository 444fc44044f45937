#pragma once
// Whether a file is as it was written, dataset by dataset.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace floes::hdf5 {

struct DamagedDataset {
    std::string path;
    std::string fault;              ///< "/members/status does not fit its digest"
    bool by_rows = false;           ///< its rows are stored one by one, and stand for themselves
    std::vector<std::size_t> rows;  ///< those that cannot be read; empty although it is damaged: nobody knows which
};

struct FileCheck {
    std::string filetype;      ///< attribute of the root; empty where there is none
    std::string version;       ///< of the layout, "1.8"
    std::size_t datasets = 0;  ///< as far as they could be listed
    bool has_digests = false;  ///< layouts before 1.8, and of records before 1.1, have none
    std::string contents;      ///< the digest over all outside /provenance, as written
    std::string fault;         ///< of the file as a whole; empty where there is none
    std::vector<DamagedDataset> damaged;
    std::string between;  ///< fault of bytes that belong to none of what is stored, where all that is fits its digests

    bool good() const { return fault.empty() && damaged.empty() && between.empty(); }
};

/// Reads the whole file; of a file that has neither digests nor one of the `filetypes`, only what says so. What cannot
/// be read is in the answer; throws InputError only where there is no such file or it is no HDF5 file.
FileCheck check_file(const std::filesystem::path& path, std::span<const std::string_view> filetypes);

}  // namespace floes::hdf5
