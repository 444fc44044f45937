#pragma once
// How a self-describing HDF5 file is written: names, attributes, and datasets along named dimensions. Only for sources
// of modules with HDF5 files of their own.

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// The names that iterate(visit, names) visits, as H5Literate and H5Aiterate do; Info is the type of their information.
/// Sorted here, because HDF5 itself can crash when it sorts the names of a damaged file.
template <class Info, class Iterate>
std::vector<std::string> names_in_order(const Iterate& iterate) {
    std::vector<std::string> names;
    iterate(
        +[](hid_t, const char* name, const Info*, void* to) -> herr_t {
            static_cast<std::vector<std::string>*>(to)->emplace_back(name);
            return 0;
        },
        &names);
    std::ranges::sort(names);
    return names;
}

// The name, unit and dimensions of a dataset.

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

/// The rows that another file has of a dimension.
struct RowSource {
    std::string file;  ///< relative to the folder of the file that refers to it
    hsize_t rows = 0;
};

/// A dimension, named by the dataset that lists its coordinates.
class Scale {
  public:
    Scale(Handle dataset, hsize_t size) : dataset_(std::move(dataset)), size_(size) {}
    hid_t id() const { return dataset_.id(); }
    hsize_t size() const { return size_; }

    /// Where the rows of datasets along it lie, one source after another, under the same path; none: in this file.
    const std::vector<RowSource>& sources() const { return sources_; }
    void lies_in(std::vector<RowSource> sources) { sources_ = std::move(sources); }

  private:
    Handle dataset_;
    hsize_t size_;
    std::vector<RowSource> sources_;
};

using Dimensions = std::vector<std::reference_wrapper<const Scale>>;

// Attributes of files, groups and datasets.

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

// How datasets are created, of fixed size and growing. Only for files inside this module.

inline constexpr hsize_t cached_chunk_bytes = hsize_t{1} << 20;  ///< what HDF5's cache of chunks holds

/// Creation properties of a file, group or dataset: order of creation is kept, no times are stored.
Handle creation_properties(hid_t kind);

/// The same for a dataset of numbers that is written whole, in chunks with checksums, which every reader verifies. No
/// chunks without dimensions or with one of size 0.
Handle checked_properties(std::span<const hsize_t> sizes, std::size_t value_bytes, const std::string& name,
                          hsize_t most_in_a_chunk = cached_chunk_bytes);

/// The same for a dataset whose rows lie in the sources of that scale (HDF5's virtual layout).
Handle virtual_properties(hid_t parent, const std::string& name, std::span<const hsize_t> sizes, const Scale& rows);

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

/// Selects rows of `space`, which has these sizes, and returns the dataspace of their values in memory. A single value
/// is one row.
Handle select_rows(const Handle& space, std::span<const hsize_t> sizes, hsize_t begin, hsize_t rows,
                   const std::string& name);

std::vector<hsize_t> sizes_of(const Dimensions& dimensions);

/// 1 of none.
template <class Size>
Size product(std::span<const Size> sizes) {
    return std::accumulate(sizes.begin(), sizes.end(), Size{1}, std::multiplies{});
}

/// Attaches a scale to each dimension from number `first` on.
void attach(const Handle& dataset, const Dimensions& dimensions, unsigned first, const std::string& name);

/// The flags of an enumeration that counts from 0 in the order of `words`.
Flags flags_of(std::span<const char* const> words, std::optional<std::int8_t> missing = {});

/// Creates a file, or empties an existing one. Order of creation is kept, no times are stored.
Handle create_file(const std::filesystem::path& path);
Handle create_group(hid_t parent, const std::string& name);

Scale write_scale(hid_t parent, const Label& label, std::span<const std::int32_t> coordinates);
Scale write_scale(hid_t parent, const Label& label, std::span<const double> coordinates);
Scale write_scale(hid_t parent, const Label& label, std::span<const std::string> coordinates);

/// Writes a dimension scale of `count` numbers from `first` on.
Scale write_index_scale(hid_t parent, const char* name, const char* long_name, std::size_t count,
                        std::size_t first = 0);

/// Writes values in row-major order over the dimensions. For doubles, NaN is the missing value.
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const double> values);
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::string> values);
/// `missing`: the number that stands for a missing value.
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int32_t> values,
                  std::optional<std::int32_t> missing = {});
void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int8_t> values,
                  const Flags& flags);
/// Writes one text, without dimensions.
void write_text(hid_t parent, const Label& label, const std::string& text);

}  // namespace floes::hdf5
