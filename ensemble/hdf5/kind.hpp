#pragma once
// What kind of file it is, and of which layout: the attributes at the root of every HDF5 file of floes. Only for
// sources of rooms with HDF5 files of their own.

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

struct FileKind {
    std::string_view filetype;   ///< attribute
    std::array<int, 2> version;  ///< of the layout, {major, minor}: a new minor only adds names
    std::string_view what;       ///< as a message names it: "campaign of floes"
};

/// Title, filetype, version and software.
void write_kind(hid_t file, const FileKind& kind, const std::string& title);

bool is_of_kind(hid_t file, const FileKind& kind);

/// Throws InputError when the file is of another kind, or its major version is not this program's.
void check_kind(hid_t file, const FileKind& kind, const std::filesystem::path& path);

}  // namespace floes::hdf5
