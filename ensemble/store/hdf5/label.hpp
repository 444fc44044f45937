#pragma once
// The name, unit and dimensions of a dataset. Only for sources of rooms with HDF5 files of their own.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// The attributes of every dataset.
struct Label {
    std::string name;
    std::string unit;
    std::string long_name;
};

/// The meanings of the small integers of a dataset (CF flag_values, flag_meanings).
struct Flags {
    std::vector<std::int8_t> values;
    std::string meanings;                     ///< one word per value, separated by spaces
    std::optional<std::int8_t> missing = {};  ///< stands for a missing value
};

/// A dimension, named by the dataset that lists its coordinates.
class Scale {
  public:
    Scale(Handle dataset, hsize_t size) : dataset_(std::move(dataset)), size_(size) {}
    hid_t id() const { return dataset_.id(); }
    hsize_t size() const { return size_; }

  private:
    Handle dataset_;
    hsize_t size_;
};

using Dimensions = std::vector<std::reference_wrapper<const Scale>>;

}  // namespace floes::hdf5
