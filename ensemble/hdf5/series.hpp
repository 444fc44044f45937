#pragma once
// Datasets that grow while a run goes on. Only for sources of rooms with HDF5 files of their own.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

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

    hsize_t rows() const { return rows_; }

    /// Makes it a scale of its own name.
    void become_scale();
    /// The first dimension of `dataset` is along this scale.
    void scales(hid_t dataset) const;
    hid_t id() const { return dataset_.id(); }

  private:
    std::string name_;
    std::vector<hsize_t> row_;
    hsize_t rows_ = 0;
    Handle dataset_;
};

extern template class Series<float>;
extern template class Series<double>;
extern template class Series<std::int32_t>;
extern template class Series<std::int8_t>;

/// Refills `values` with `count` rows of a dataset from row `first`, row-major. Throws RunError where it ends before.
template <class Value>
void read_block(hid_t parent, const std::string& name, hsize_t first, hsize_t count, std::vector<Value>& values);
extern template void read_block<float>(hid_t, const std::string&, hsize_t, hsize_t, std::vector<float>&);
extern template void read_block<double>(hid_t, const std::string&, hsize_t, hsize_t, std::vector<double>&);
extern template void read_block<std::int32_t>(hid_t, const std::string&, hsize_t, hsize_t, std::vector<std::int32_t>&);

}  // namespace floes::hdf5
