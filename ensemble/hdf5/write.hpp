#pragma once
// Writes a self-describing HDF5 file like those of netCDF-4: labelled datasets with named dimension scales.
// Only for sources of modules with HDF5 files of their own.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hdf5/dataset.hpp"

namespace floes::hdf5 {

/// The flags of an enumeration that counts from 0 in the order of `words`.
Flags flags_of(std::span<const char* const> words, std::optional<std::int8_t> missing = {});

/// Creates a file, or empties an existing one. Order of creation is kept, no times are stored.
Handle create_file(const std::filesystem::path& path);
Handle create_group(hid_t parent, const std::string& name);

Scale write_scale(hid_t parent, const Label& label, std::span<const std::int32_t> coordinates);
Scale write_scale(hid_t parent, const Label& label, std::span<const double> coordinates);
Scale write_scale(hid_t parent, const Label& label, std::span<const std::string> coordinates);

/// Writes a dimension scale 0, 1, …, count - 1.
Scale write_index_scale(hid_t parent, const char* name, const char* long_name, std::size_t count);

/// Writes values in row-major order over the dimensions. For doubles, NaN is the missing value.
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const double> values);
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::string> values);
/// `missing`: the number that stands for a missing value.
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int32_t> values,
                  std::int32_t missing);
/// The same for values none of which is missing.
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int32_t> values);
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int8_t> values,
                  const Flags& flags);
/// Writes one text, without dimensions.
void write_text(hid_t parent, const Label& label, const std::string& text);

}  // namespace floes::hdf5
