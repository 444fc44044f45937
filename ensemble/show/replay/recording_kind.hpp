#pragma once
// What says that an HDF5 file is a recording.

#include "hdf5/file_kind.hpp"

namespace floes {

inline constexpr hdf5::FileKind recording_kind{"floes replay", {1, 4}, 1, "recording of floes replay"};

}  // namespace floes
