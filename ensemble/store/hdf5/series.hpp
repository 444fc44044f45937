#pragma once
// Datasets that grow during a run. Only for sources of rooms with HDF5 files of their own.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hdf5/digest.hpp"
#include "hdf5/write.hpp"

namespace floes::hdf5 {

/// A compressed dataset with checksums whose first dimension grows by whole rows. Value: float, double, int32 or int8.
template <class Value>
class Series {
  public:
    /// row: the dimensions of one row, none for one number a row. chunk_rows: rows that are compressed together.
    Series(hid_t parent, const Label& label, const Dimensions& row, hsize_t chunk_rows);

    /// Adds values.size() / (values of a row) rows.
    void append(std::span<const Value> values);
    void append(const Value& value) { append(std::span(&value, 1)); }

    /// Writes the digest of the dataset. Call it after the last row.
    void finish();

    hsize_t rows() const { return rows_; }

    /// Makes it a dimension scale with its own name.
    void become_scale();
    /// The first dimension of `dataset` is along this scale.
    void scales(hid_t dataset) const;
    hid_t id() const { return dataset_.id(); }

  private:
    std::string name_;
    std::vector<hsize_t> row_;
    hsize_t rows_ = 0;
    Handle dataset_;
    DatasetDigest digest_;
};

extern template class Series<float>;
extern template class Series<double>;
extern template class Series<std::int32_t>;
extern template class Series<std::int8_t>;

}  // namespace floes::hdf5
