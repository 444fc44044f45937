#pragma once
// What says that an HDF5 file is a campaign file.

#include "hdf5/file_kind.hpp"

namespace floes {

inline constexpr hdf5::FileKind campaign_kind{"floes campaign", {1, 14}, 8, "campaign of floes"};

}  // namespace floes
