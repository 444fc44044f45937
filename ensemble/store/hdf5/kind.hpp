#pragma once
// The attributes of the root of every HDF5 file of floes, which identify its kind. Only for sources of rooms
// with HDF5 files of their own.

#include <filesystem>
#include <string>

#include "hdf5/file_kind.hpp"
#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// Writes title, filetype, version and software.
void write_kind(hid_t file, const FileKind& kind, const std::string& title);

bool is_of_kind(hid_t file, const FileKind& kind);

/// Throws InputError if the file is of another kind or another major version.
void check_kind(hid_t file, const FileKind& kind, const std::filesystem::path& path);

}  // namespace floes::hdf5
