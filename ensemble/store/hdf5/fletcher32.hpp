#pragma once
// The checksum that HDF5's filter Fletcher32 appends to each chunk, for chunks that are written without the filters;
// HDF5 does not export its own function. For this room only.

#include "core/bytes.hpp"

namespace floes::hdf5 {

/// Appends the checksum of `chunk`, four bytes, to it.
void append_fletcher32(Bytes& chunk);

}  // namespace floes::hdf5
