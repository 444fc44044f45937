#pragma once
// How datasets are made, whole ones and growing ones. Only for files inside this room.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hdf5/attributes.hpp"
#include "hdf5/label.hpp"

namespace floes::hdf5 {

inline constexpr hsize_t cached_chunk_bytes = hsize_t{1} << 20;  ///< what HDF5's cache of chunks holds

/// Of a file, group or dataset: order of creation is kept, no times are stored.
Handle creation_properties(hid_t kind);

/// The same of a dataset of numbers that is written whole, in chunks with checksums, of which every reader makes use.
/// Without dimensions, or with one of size 0, there is nothing that a chunk could hold.
Handle checked_properties(std::span<const hsize_t> sizes, std::size_t value_bytes, const std::string& name,
                          hsize_t most_in_a_chunk = cached_chunk_bytes);

/// Rows in a chunk of at most this many bytes, at least one, for a dataset of these sizes.
hsize_t rows_in_a_chunk(std::span<const hsize_t> sizes, std::size_t value_bytes, hsize_t most_in_a_chunk);

/// The same of a dataset whose chunks are compressed at `level`, and then given a checksum.
Handle compressed_properties(std::span<const hsize_t> chunk, unsigned level, const std::string& name);

/// With its unit and long name. `access`: how it is accessed until the handle is closed.
Handle create_dataset(hid_t parent, const Label& label, hid_t type, const Handle& space, const Handle& properties,
                      hid_t access = H5P_DEFAULT);

/// Says both to HDF5, as the fill value, and to others (CF _FillValue) which number stands for a missing value.
template <class Value>
Handle create_numbers(hid_t parent, const Label& label, std::span<const hsize_t> sizes, std::optional<Value> missing,
                      Handle properties, hid_t access = H5P_DEFAULT) {
    if (missing)
        check(H5Pset_fill_value(properties.id(), native_type<Value>(), &*missing), "H5Pset_fill_value", label.name);
    Handle dataset = create_dataset(parent, label, stored_type<Value>(), simple_space(sizes), properties, access);
    const std::array<hsize_t, 1> one{1};
    if (missing)
        write_attribute_of(dataset.id(), "_FillValue", one, stored_type<Value>(), native_type<Value>(), &*missing);
    return dataset;
}

void write_flags(const Handle& dataset, const Flags& flags);

/// Selects rows of `space`, which has these sizes, and gives the space of their values in memory.
Handle select_rows(const Handle& space, std::span<const hsize_t> sizes, hsize_t begin, hsize_t rows,
                   const std::string& name);

std::vector<hsize_t> sizes_of(const Dimensions& dimensions);

/// A scale for each dimension from number `first` on.
void attach(const Handle& dataset, const Dimensions& dimensions, unsigned first, const std::string& name);

}  // namespace floes::hdf5
