#pragma once
// How datasets are made, whole ones and growing ones. Only for files inside this room.

#include <span>
#include <string>
#include <vector>

#include "hdf5/label.hpp"

namespace floes::hdf5 {

/// Of a file, group or dataset: order of creation is kept, no times are stored.
Handle creation_properties(hid_t kind);

/// The same of a dataset of numbers that is written whole, in chunks with checksums, of which every reader makes use.
/// Without dimensions, or with one of size 0, there is nothing that a chunk could hold.
Handle checked_properties(std::span<const hsize_t> sizes, std::size_t value_bytes, const std::string& name);

/// The same of a dataset whose chunks are compressed at `level`, and then given a checksum.
Handle compressed_properties(std::span<const hsize_t> chunk, unsigned level, const std::string& name);

/// With its unit and long name.
Handle create_dataset(hid_t parent, const Label& label, hid_t type, const Handle& space, const Handle& properties);

std::vector<hsize_t> sizes_of(const Dimensions& dimensions);

/// A scale for each dimension from number `first` on.
void attach(const Handle& dataset, const Dimensions& dimensions, unsigned first, const std::string& name);

}  // namespace floes::hdf5
