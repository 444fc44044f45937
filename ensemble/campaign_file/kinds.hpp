#pragma once
// What says that an HDF5 file is a campaign file, or a piece of one, and of which layout.

#include "hdf5/handle.hpp"

namespace floes {

inline constexpr hdf5::FileKind campaign_kind{"floes campaign", {1, 19}, 14, "campaign of floes"};

/// Pieces are read with the layout that they were written with.
inline constexpr hdf5::FileKind piece_kind{"floes piece of a campaign", campaign_kind.version, campaign_kind.version[1],
                                           "piece of a campaign file of floes"};

}  // namespace floes
