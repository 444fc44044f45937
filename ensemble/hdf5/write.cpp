#include "hdf5/write.hpp"

#include <hdf5_hl.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

namespace floes::hdf5 {
namespace {

constexpr unsigned creation_order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;

template <class Value>
hid_t stored_type();
template <>
hid_t stored_type<double>() {
    return H5T_IEEE_F64LE;
}
template <>
hid_t stored_type<std::int32_t>() {
    return H5T_STD_I32LE;
}
template <>
hid_t stored_type<std::int8_t>() {
    return H5T_STD_I8LE;
}
template <>
hid_t stored_type<std::uint64_t>() {
    return H5T_STD_U64LE;
}

Handle creation_properties(hid_t kind) {
    Handle properties(H5Pcreate(kind), H5Pclose, "H5Pcreate", "creation properties");
    check(H5Pset_obj_track_times(properties.id(), false), "H5Pset_obj_track_times", "creation properties");
    check(H5Pset_attr_creation_order(properties.id(), creation_order), "H5Pset_attr_creation_order", "properties");
    if (kind != H5P_DATASET_CREATE)
        check(H5Pset_link_creation_order(properties.id(), creation_order), "H5Pset_link_creation_order", "properties");
    return properties;
}

Handle simple_space(std::span<const hsize_t> sizes) {
    if (sizes.empty()) return Handle(H5Screate(H5S_SCALAR), H5Sclose, "H5Screate", "a single value");
    return Handle(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose, "H5Screate_simple",
                  "values");
}

void write_attribute_of(hid_t object, const std::string& name, std::span<const hsize_t> sizes, hid_t stored,
                        hid_t native, const void* value) {
    const Handle space = simple_space(sizes);
    const Handle attribute(H5Acreate2(object, name.c_str(), stored, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "H5Acreate", name);
    check(H5Awrite(attribute.id(), native, value), "H5Awrite", name);
}

void write_label(hid_t dataset, const Label& label) {
    write_attribute(dataset, "units", label.unit);
    write_attribute(dataset, "long_name", label.long_name);
}

Handle create_dataset(hid_t parent, const Label& label, hid_t type, std::span<const hsize_t> sizes,
                      const Handle& properties) {
    const Handle space = simple_space(sizes);
    Handle dataset(H5Dcreate2(parent, label.name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                   H5Dclose, "H5Dcreate", label.name);
    write_label(dataset.id(), label);
    return dataset;
}

void write_whole(const Handle& dataset, hid_t type, const void* values, const std::string& name) {
    check(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "H5Dwrite", name);
}

std::vector<hsize_t> sizes_of(const Dimensions& dimensions) {
    std::vector<hsize_t> sizes;
    for (const Scale& scale : dimensions) sizes.push_back(scale.size());
    return sizes;
}

void attach(const Handle& dataset, const Dimensions& dimensions, const std::string& name) {
    for (unsigned k = 0; k < dimensions.size(); ++k)
        check(H5DSattach_scale(dataset.id(), dimensions[k].get().id(), k), "H5DSattach_scale", name);
}

std::vector<hsize_t> sizes_of(const Scale& rows, const Dimensions& columns) {
    std::vector<hsize_t> sizes = sizes_of(columns);
    sizes.insert(sizes.begin(), rows.size());
    return sizes;
}

std::vector<const char*> pointers_to(std::span<const std::string> texts) {
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    return pointers;
}

// A dataset of numbers; with a missing value both HDF5's fill and CF's _FillValue say so.
template <class Value>
Handle write_numbers(hid_t parent, const Label& label, std::span<const hsize_t> sizes, std::span<const Value> values,
                     std::optional<Value> missing) {
    const Handle properties = creation_properties(H5P_DATASET_CREATE);
    if (missing)
        check(H5Pset_fill_value(properties.id(), native_type<Value>(), &*missing), "H5Pset_fill_value", label.name);
    Handle dataset = create_dataset(parent, label, stored_type<Value>(), sizes, properties);
    const std::array<hsize_t, 1> one{1};
    if (missing)
        write_attribute_of(dataset.id(), "_FillValue", one, stored_type<Value>(), native_type<Value>(), &*missing);
    write_whole(dataset, native_type<Value>(), values.data(), label.name);
    return dataset;
}

Handle write_texts(hid_t parent, const Label& label, std::span<const hsize_t> sizes,
                   std::span<const std::string> texts) {
    const Handle type = text_type();
    Handle dataset = create_dataset(parent, label, type.id(), sizes, creation_properties(H5P_DATASET_CREATE));
    write_whole(dataset, type.id(), pointers_to(texts).data(), label.name);
    return dataset;
}

Scale as_scale(Handle dataset, hsize_t size, const std::string& name) {
    check(H5DSset_scale(dataset.id(), name.c_str()), "H5DSset_scale", name);
    return Scale(std::move(dataset), size);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Handle create_file(const std::filesystem::path& path) {
    const Handle access = access_without_locks();
    return Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation_properties(H5P_FILE_CREATE).id(), access.id()),
                  H5Fclose, "H5Fcreate", path.string());
}

Handle create_group(hid_t parent, const std::string& name) {
    return Handle(
        H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation_properties(H5P_GROUP_CREATE).id(), H5P_DEFAULT),
        H5Gclose, "H5Gcreate", name);
}

void write_attribute(hid_t object, const std::string& name, const std::string& value) {
    const Handle type = text_type();
    const char* text = value.c_str();
    write_attribute_of(object, name, {}, type.id(), type.id(), &text);
}

void write_attribute(hid_t object, const std::string& name, double value) {
    write_attribute_of(object, name, {}, stored_type<double>(), native_type<double>(), &value);
}

void write_attribute(hid_t object, const std::string& name, std::uint64_t value) {
    write_attribute_of(object, name, {}, stored_type<std::uint64_t>(), native_type<std::uint64_t>(), &value);
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::int8_t> values) {
    const std::array<hsize_t, 1> sizes{values.size()};
    write_attribute_of(object, name, sizes, stored_type<std::int8_t>(), native_type<std::int8_t>(), values.data());
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::int32_t> values) {
    const std::array<hsize_t, 1> sizes{values.size()};
    write_attribute_of(object, name, sizes, stored_type<std::int32_t>(), native_type<std::int32_t>(), values.data());
}

Scale write_scale(hid_t parent, const Label& label, std::span<const std::int32_t> coordinates) {
    const std::array<hsize_t, 1> sizes{coordinates.size()};
    return as_scale(write_numbers<std::int32_t>(parent, label, sizes, coordinates, {}), sizes[0], label.name);
}

Scale write_scale(hid_t parent, const Label& label, std::span<const double> coordinates) {
    const std::array<hsize_t, 1> sizes{coordinates.size()};
    return as_scale(write_numbers<double>(parent, label, sizes, coordinates, {}), sizes[0], label.name);
}

Scale write_scale(hid_t parent, const Label& label, std::span<const std::string> coordinates) {
    const std::array<hsize_t, 1> sizes{coordinates.size()};
    return as_scale(write_texts(parent, label, sizes, coordinates), sizes[0], label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const double> values) {
    attach(write_numbers<double>(parent, label, sizes_of(dimensions), values, nan), dimensions, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::string> values) {
    attach(write_texts(parent, label, sizes_of(dimensions), values), dimensions, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int32_t> values,
                  std::int32_t missing) {
    attach(write_numbers<std::int32_t>(parent, label, sizes_of(dimensions), values, missing), dimensions, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions,
                  std::span<const std::int32_t> values) {
    attach(write_numbers<std::int32_t>(parent, label, sizes_of(dimensions), values, {}), dimensions, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int8_t> values,
                  const Flags& flags) {
    const Handle dataset = write_numbers<std::int8_t>(parent, label, sizes_of(dimensions), values, flags.missing);
    write_attribute(dataset.id(), "flag_values", flags.values);
    write_attribute(dataset.id(), "flag_meanings", flags.meanings);
    attach(dataset, dimensions, label.name);
}

void write_text(hid_t parent, const Label& label, const std::string& text) {
    write_texts(parent, label, {}, std::span(&text, 1));
}

namespace {

Handle create_rows(hid_t parent, const Label& label, std::span<const hsize_t> sizes) {
    std::vector<hsize_t> chunk{1};
    for (const hsize_t size : sizes.subspan(1)) chunk.push_back(std::max<hsize_t>(size, 1));
    const Handle properties = creation_properties(H5P_DATASET_CREATE);
    check(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()), "H5Pset_chunk", label.name);
    check(H5Pset_shuffle(properties.id()), "H5Pset_shuffle", label.name);
    check(H5Pset_deflate(properties.id(), static_cast<unsigned>(compression_level)), "H5Pset_deflate", label.name);
    check(H5Pset_fill_value(properties.id(), native_type<double>(), &nan), "H5Pset_fill_value", label.name);
    Handle dataset = create_dataset(parent, label, stored_type<double>(), sizes, properties);
    const std::array<hsize_t, 1> one{1};
    write_attribute_of(dataset.id(), "_FillValue", one, stored_type<double>(), native_type<double>(), &nan);
    return dataset;
}

}  // namespace

Rows::Rows(hid_t parent, const Label& label, const Scale& rows, const Dimensions& columns)
    : name_(label.name),
      sizes_(sizes_of(rows, columns)),
      width_(std::accumulate(sizes_.begin() + 1, sizes_.end(), hsize_t{1}, std::multiplies{})),
      dataset_(create_rows(parent, label, sizes_)),
      space_(simple_space(sizes_)) {
    Dimensions all{rows};
    all.insert(all.end(), columns.begin(), columns.end());
    attach(dataset_, all, name_);
}

void Rows::write(std::size_t row, std::span<const double> values) {
    std::vector<hsize_t> first(sizes_.size(), 0);
    std::vector<hsize_t> count = sizes_;
    first[0] = row;
    count[0] = 1;
    if (count.size() == 2) count[1] = std::min<hsize_t>(values.size(), width_);
    const std::array<hsize_t, 1> length{std::min<hsize_t>(values.size(), width_)};
    if (length[0] == 0) return;
    check(H5Sselect_hyperslab(space_.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr),
          "H5Sselect_hyperslab", name_);
    const Handle memory = simple_space(length);
    check(H5Dwrite(dataset_.id(), native_type<double>(), memory.id(), space_.id(), H5P_DEFAULT, values.data()),
          "H5Dwrite", name_);
}

void Rows::write(std::size_t row, const PackedNumbers& values) {
    if (values.count != width_) return write(row, unpack(values));
    std::vector<hsize_t> first(sizes_.size(), 0);
    first[0] = row;
    const std::uint32_t left_out = values.deflated() ? 0 : 0b11;  // of the two filters
    check(H5Dwrite_chunk(dataset_.id(), H5P_DEFAULT, left_out, first.data(), values.chunk.size(), values.chunk.data()),
          "H5Dwrite_chunk", name_);
}

void write_rows(hid_t parent, const Label& label, const Scale& rows, const Scale& columns,
                const std::function<std::span<const double>(std::size_t)>& row_values) {
    Rows table(parent, label, rows, {columns});
    for (std::size_t row = 0; row < rows.size(); ++row) table.write(row, row_values(row));
}

}  // namespace floes::hdf5
