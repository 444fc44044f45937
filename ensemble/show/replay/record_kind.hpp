#pragma once
// What says that an HDF5 file is a record.

#include "hdf5/file_kind.hpp"

namespace floes {

inline constexpr hdf5::FileKind record_kind{"floes replay", {1, 1}, "record of floes replay"};

}  // namespace floes
