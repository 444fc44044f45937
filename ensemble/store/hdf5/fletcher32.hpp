#pragma once
// The checksum that HDF5's filter Fletcher32 puts behind each chunk, for chunks that are written past the filters. HDF5
// itself computes it only inside. For this room only.

#include "core/bytes.hpp"

namespace floes::hdf5 {

/// Appends the checksum of `chunk`, four bytes, to it.
void append_fletcher32(Bytes& chunk);

}  // namespace floes::hdf5
