#pragma once
// What can be read of a dataset before its digest is compared: its sizes, as far as they are plausible, and texts. Only
// for files inside this room.

#include <cstdint>
#include <string>
#include <vector>

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// Opens a dataset for reading; `name` may be a path. Throws RunError if it does not exist.
Handle open_dataset(hid_t parent, const std::string& name);

/// Its dataspace and its type in the file. Throw RunError if they cannot be read.
Handle stored_space(const Handle& dataset, const std::string& name);
Handle stored_type(const Handle& dataset, const std::string& name);

struct StoredShape {
    std::vector<hsize_t> sizes;
    hsize_t count = 1;       ///< of the values
    hsize_t row_values = 1;  ///< values of one row
    std::size_t value_bytes = 0;
    bool is_text = false;

    hsize_t rows() const { return sizes.empty() ? 1 : sizes.front(); }
};

/// How much of a dataset will be in memory at once.
enum class Portion { whole, row };

/// Throws RunError if the sizes are larger than the file can hold, so that no memory is allocated for a damaged size.
StoredShape shape_of(const Handle& dataset, const std::string& name, Portion portion);

/// All texts of a dataset. Throws RunError if they cannot be read.
std::vector<std::string> texts_of(const Handle& dataset, const std::string& name);

}  // namespace floes::hdf5
