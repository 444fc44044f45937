#pragma once
// Tests in a child process whether HDF5 crashes over a file. For this room only.

#include <filesystem>

namespace floes::hdf5 {

/// Lets a child process read everything that HDF5 parses: headers, indices, attributes and texts. HDF5 1.10 crashes if
/// some of their bytes are damaged, and files of older layouts have no digests that would show this before. Throws
/// DamagedFile if the child crashes or hangs; other damage shows when the file is read. Not for processes under MPI.
void try_out(const std::filesystem::path& path);

}  // namespace floes::hdf5
