#pragma once
// How datasets are created, of fixed size and growing. Only for files inside this room.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hdf5/attributes.hpp"
#include "hdf5/label.hpp"

namespace floes::hdf5 {

inline constexpr hsize_t cached_chunk_bytes = hsize_t{1} << 20;  ///< what HDF5's cache of chunks holds

/// Creation properties of a file, group or dataset: order of creation is kept, no times are stored.
Handle creation_properties(hid_t kind);

/// The same for a dataset of numbers that is written whole, in chunks with checksums, which every reader verifies. No
/// chunks without dimensions or with one of size 0.
Handle checked_properties(std::span<const hsize_t> sizes, std::size_t value_bytes, const std::string& name,
                          hsize_t most_in_a_chunk = cached_chunk_bytes);

/// Rows in a chunk of at most this many bytes, at least one, for a dataset of these sizes.
hsize_t rows_in_a_chunk(std::span<const hsize_t> sizes, std::size_t value_bytes, hsize_t most_in_a_chunk);

/// The same for a dataset whose chunks are compressed at `level` and then get a checksum.
Handle compressed_properties(std::span<const hsize_t> chunk, unsigned level, const std::string& name);

/// Creates a dataset with its unit and long name. `access`: its access properties until the handle is closed.
Handle create_dataset(hid_t parent, const Label& label, hid_t type, const Handle& space, const Handle& properties,
                      hid_t access = H5P_DEFAULT);

/// Declares the number that stands for a missing value, to HDF5 (fill value) and to others (CF _FillValue).
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

/// Selects rows of `space`, which has these sizes, and returns the dataspace of their values in memory.
Handle select_rows(const Handle& space, std::span<const hsize_t> sizes, hsize_t begin, hsize_t rows,
                   const std::string& name);

std::vector<hsize_t> sizes_of(const Dimensions& dimensions);

/// Attaches a scale to each dimension from number `first` on.
void attach(const Handle& dataset, const Dimensions& dimensions, unsigned first, const std::string& name);

}  // namespace floes::hdf5
