#pragma once
// Attributes of files, groups and datasets. Only for sources of rooms with HDF5 files of their own.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

void write_attribute(hid_t object, const std::string& name, const std::string& value);
void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, std::uint64_t value);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int8_t> values);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int32_t> values);

/// Writes an attribute of any type; `sizes` is empty for a single value.
void write_attribute_of(hid_t object, const std::string& name, std::span<const hsize_t> sizes, hid_t stored,
                        hid_t native, const void* value);

bool has_attribute(hid_t object, const std::string& name);
/// The value of an attribute that is one text. Both throw RunError if there is no such attribute or it has another
/// type.
std::string read_text_attribute(hid_t object, const std::string& name);
std::vector<std::int32_t> read_int_attribute(hid_t object, const std::string& name);
/// The names of all attributes, in alphabetical order.
std::vector<std::string> attribute_names(hid_t object);

/// A dataspace of these sizes; without sizes, of a single value.
Handle simple_space(std::span<const hsize_t> sizes);

}  // namespace floes::hdf5
