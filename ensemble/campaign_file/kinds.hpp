#pragma once
// What says that an HDF5 file is a campaign file, or a piece of one, and of which layout.

#include "hdf5/handle.hpp"

namespace floes {

inline constexpr hdf5::FileKind campaign_kind{"floes campaign", {1, 19}, 14, "campaign of floes"};

/// Pieces came with layout 1.19.
inline constexpr hdf5::FileKind piece_kind{"floes piece of a campaign", campaign_kind.version, 19,
                                           "piece of a campaign file of floes"};

}  // namespace floes
