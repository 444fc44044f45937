#pragma once
// Checks a file dataset by dataset against its digests.

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
    bool by_rows = false;           ///< its rows are stored one by one and can be used without the others
    std::vector<std::size_t> rows;  ///< rows that cannot be read; empty for a damaged dataset if they are unknown
};

struct FileCheck {
    std::string filetype;      ///< attribute of the root; empty where there is none
    std::string version;       ///< of the layout, "1.8"
    std::size_t datasets = 0;  ///< that could be listed
    bool has_digests = false;  ///< layouts before 1.8, and of records before 1.1, have none
    std::string contents;      ///< the digest over all outside /provenance, as written
    std::string fault;         ///< of the file as a whole; empty if there is none
    std::vector<DamagedDataset> damaged;
    std::string between;  ///< fault of bytes that belong to no dataset, if all datasets are good

    bool good() const { return fault.empty() && damaged.empty() && between.empty(); }
};

/// Reads the whole file; if it has no digests and none of the `filetypes`, only the attributes that show this. Damage
/// is part of the result; throws InputError only if the file does not exist or is not an HDF5 file.
FileCheck check_file(const std::filesystem::path& path, std::span<const std::string_view> filetypes);

}  // namespace floes::hdf5
