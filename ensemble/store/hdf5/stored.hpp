#pragma once
// What is stored of a dataset: sizes, as far as they can be believed, and texts, before any digest is compared. Only
// for files inside this room.

#include <cstdint>
#include <string>
#include <vector>

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// Opens a dataset for reading; `name` may be a path. Throws RunError where there is none.
Handle open_dataset(hid_t parent, const std::string& name);

/// Its dataspace and its type in the file. Throw RunError where they cannot be read.
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

/// What of a dataset is to be in memory at once.
enum class Portion { whole, row };

/// Throws RunError where the sizes are more than the file can hold, so that a damaged size never asks for memory.
StoredShape shape_of(const Handle& dataset, const std::string& name, Portion portion);

/// All texts of a dataset of texts. Throws RunError where they cannot be read.
std::vector<std::string> texts_of(const Handle& dataset, const std::string& name);

}  // namespace floes::hdf5
