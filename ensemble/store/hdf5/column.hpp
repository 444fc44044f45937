#pragma once
// Datasets with a known number of rows, which are added in order, so that at most one chunk of each is in memory.
// Only for sources of rooms with HDF5 files of their own.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hdf5/digest.hpp"
#include "hdf5/label.hpp"

namespace floes::hdf5 {

/// A dataset of numbers like those of write_values(). Value: double, int32 or int8.
template <class Value>
class Column {
  public:
    /// The first of the dimensions is that of the rows. `missing`: the number that stands for a missing value.
    Column(hid_t parent, const Label& label, const Dimensions& dimensions, std::optional<Value> missing = {});
    /// The same for an enumeration.
    Column(hid_t parent, const Label& label, const Dimensions& dimensions, const Flags& flags);

    /// Adds whole rows, in row-major order.
    void add(std::span<const Value> values);
    void add(const Value& value) { add(std::span(&value, 1)); }
    /// Call it after the last row: writes the remaining rows and the digest. Throws std::logic_error if rows are
    /// missing.
    void finish();

  private:
    void write();

    std::string name_;
    std::vector<hsize_t> sizes_;
    hsize_t width_;  ///< values in a row
    hsize_t rows_at_once_;
    hsize_t written_ = 0;  ///< rows
    Handle dataset_;
    Handle space_;
    std::vector<Value> waiting_;  ///< rows of a chunk that is not full yet
    DatasetDigest digest_;
};

extern template class Column<double>;
extern template class Column<std::int32_t>;
extern template class Column<std::int8_t>;

/// A dataset with one text per row.
class TextColumn {
  public:
    TextColumn(hid_t parent, const Label& label, const Dimensions& dimensions);
    void add(const std::string& text);
    /// As above.
    void finish();

  private:
    void write();

    std::string name_;
    hsize_t rows_;
    hsize_t written_ = 0;
    Handle type_;
    Handle dataset_;
    Handle space_;
    std::vector<std::string> waiting_;
    DatasetDigest digest_;
};

}  // namespace floes::hdf5
