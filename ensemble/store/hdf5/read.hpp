#pragma once
// Reading named datasets and attributes of an HDF5 file. Only for sources of rooms with HDF5 files of their own.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hdf5/attributes.hpp"

namespace floes::hdf5 {

/// Opens an HDF5 file for reading. Throws InputError if the file does not exist or is not an HDF5 file.
Handle open_for_reading(const std::filesystem::path& path);

/// Whether an object of that name exists; `name` may be a path.
bool exists(hid_t parent, const std::string& name);

/// All values of a dataset, row-major; `name` may be a path. Throws RunError if it does not exist or does not match its
/// digest.
template <class Value>
std::vector<Value> read_values(hid_t parent, const std::string& name);
extern template std::vector<double> read_values<double>(hid_t, const std::string&);
extern template std::vector<std::int32_t> read_values<std::int32_t>(hid_t, const std::string&);
extern template std::vector<std::int8_t> read_values<std::int8_t>(hid_t, const std::string&);

/// A dataset that is read a few rows at a time. Value: double, float or int32. HDF5 verifies the checksum of each
/// chunk; the digest covers all rows and is not compared.
template <class Value>
class RowReader {
  public:
    /// `name` may be a path. Throws RunError if there is no such dataset.
    RowReader(hid_t parent, const std::string& name);
    /// Values of one row.
    std::size_t width() const { return width_; }
    std::size_t rows() const { return static_cast<std::size_t>(sizes_.at(0)); }
    /// The values of `count` rows from `row` on, row-major; valid until the next call. Throws RunError past the end.
    std::span<const Value> read(std::size_t row, std::size_t count = 1);

  private:
    std::string name_;
    Handle dataset_;
    Handle space_;
    std::vector<hsize_t> sizes_;
    std::size_t width_;
    std::vector<Value> values_;
};
extern template class RowReader<double>;
extern template class RowReader<float>;
extern template class RowReader<std::int32_t>;

/// The same for texts, which are UTF-8.
std::vector<std::string> read_texts(hid_t parent, const std::string& name);

}  // namespace floes::hdf5
