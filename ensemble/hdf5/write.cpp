#include "hdf5/write.hpp"

#include <hdf5_hl.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include "hdf5/dataset.hpp"

namespace floes::hdf5 {
namespace {

void write_whole(const Handle& dataset, hid_t type, const void* values, const std::string& name) {
    check(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "H5Dwrite", name);
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
    Handle dataset = create_dataset(parent, label, stored_type<Value>(), simple_space(sizes), properties);
    const std::array<hsize_t, 1> one{1};
    if (missing)
        write_attribute_of(dataset.id(), "_FillValue", one, stored_type<Value>(), native_type<Value>(), &*missing);
    write_whole(dataset, native_type<Value>(), values.data(), label.name);
    return dataset;
}

Handle write_texts(hid_t parent, const Label& label, std::span<const hsize_t> sizes,
                   std::span<const std::string> texts) {
    const Handle type = text_type();
    Handle dataset =
        create_dataset(parent, label, type.id(), simple_space(sizes), creation_properties(H5P_DATASET_CREATE));
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
    attach(write_numbers<double>(parent, label, sizes_of(dimensions), values, nan), dimensions, 0, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::string> values) {
    attach(write_texts(parent, label, sizes_of(dimensions), values), dimensions, 0, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int32_t> values,
                  std::int32_t missing) {
    attach(write_numbers<std::int32_t>(parent, label, sizes_of(dimensions), values, missing), dimensions, 0,
           label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions,
                  std::span<const std::int32_t> values) {
    attach(write_numbers<std::int32_t>(parent, label, sizes_of(dimensions), values, {}), dimensions, 0, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int8_t> values,
                  const Flags& flags) {
    const Handle dataset = write_numbers<std::int8_t>(parent, label, sizes_of(dimensions), values, flags.missing);
    write_attribute(dataset.id(), "flag_values", flags.values);
    write_attribute(dataset.id(), "flag_meanings", flags.meanings);
    attach(dataset, dimensions, 0, label.name);
}

Flags flags_of(std::span<const char* const> words, std::optional<std::int8_t> missing) {
    Flags flags{.values = {}, .meanings = {}, .missing = missing};
    for (const char* word : words) {
        flags.meanings += (flags.values.empty() ? "" : " ") + std::string(word);
        flags.values.push_back(static_cast<std::int8_t>(flags.values.size()));
    }
    return flags;
}

Scale write_index_scale(hid_t parent, const char* name, const char* long_name, std::size_t count) {
    std::vector<std::int32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0);
    return write_scale(parent, Label{name, "1", long_name}, indices);
}

void write_text(hid_t parent, const Label& label, const std::string& text) {
    write_texts(parent, label, {}, std::span(&text, 1));
}

namespace {

Handle create_rows(hid_t parent, const Label& label, std::span<const hsize_t> sizes) {
    std::vector<hsize_t> chunk{1};
    for (const hsize_t size : sizes.subspan(1)) chunk.push_back(std::max<hsize_t>(size, 1));
    const Handle properties = compressed_properties(chunk, static_cast<unsigned>(compression_level), label.name);
    check(H5Pset_fill_value(properties.id(), native_type<double>(), &nan), "H5Pset_fill_value", label.name);
    Handle dataset = create_dataset(parent, label, stored_type<double>(), simple_space(sizes), properties);
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
    attach(dataset_, all, 0, name_);
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
