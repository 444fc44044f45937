#pragma once
// Whether HDF5 survives a file. For this room only.

#include <filesystem>

namespace floes::hdf5 {

/// Lets a child process read all that HDF5 parses by itself: headers, indices, attributes and texts. HDF5 1.10 crashes
/// over some damaged bytes of these, and files of older layouts have no digests that would show them before. Throws
/// DamagedFile where the child crashes or hangs; what else is wrong shows when the file is read. Not in a process under
/// MPI.
void try_out(const std::filesystem::path& path);

}  // namespace floes::hdf5
