#pragma once
// HDF5's reading through CheckedPages: a damaged byte is an error before HDF5 makes anything of it. For this room only.

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// Makes `access` read files by their digests of pages. Every file that is opened with it must have them.
void read_by_pages(const Handle& access);

}  // namespace floes::hdf5
