#include "hdf5/series.hpp"

#include <hdf5_hl.h>

#include <functional>
#include <numeric>

namespace floes::hdf5 {
namespace {

constexpr unsigned fast_compression = 1;  // frames are written while a run waits

template <class Value>
hid_t kept_type();
template <>
hid_t kept_type<float>() {
    return H5T_IEEE_F32LE;
}
template <>
hid_t kept_type<double>() {
    return H5T_IEEE_F64LE;
}
template <>
hid_t kept_type<std::int32_t>() {
    return H5T_STD_I32LE;
}
template <>
hid_t kept_type<std::int8_t>() {
    return H5T_STD_I8LE;
}

std::vector<hsize_t> with_rows(hsize_t rows, const std::vector<hsize_t>& row) {
    std::vector<hsize_t> sizes{rows};
    sizes.insert(sizes.end(), row.begin(), row.end());
    return sizes;
}

Handle space_of(std::span<const hsize_t> sizes, const hsize_t* most, const std::string& name) {
    return Handle(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), most), H5Sclose, "H5Screate_simple",
                  name);
}

Handle create(hid_t parent, const Label& label, hid_t type, const std::vector<hsize_t>& row, hsize_t chunk_rows) {
    const std::vector<hsize_t> none = with_rows(0, row);
    const std::vector<hsize_t> most = with_rows(H5S_UNLIMITED, row);
    const std::vector<hsize_t> chunk = with_rows(chunk_rows, row);
    const Handle space = space_of(none, most.data(), label.name);
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "H5Pcreate", label.name);
    check(H5Pset_obj_track_times(properties.id(), false), "H5Pset_obj_track_times", label.name);
    check(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()), "H5Pset_chunk", label.name);
    check(H5Pset_shuffle(properties.id()), "H5Pset_shuffle", label.name);
    check(H5Pset_deflate(properties.id(), fast_compression), "H5Pset_deflate", label.name);
    check(H5Pset_fletcher32(properties.id()), "H5Pset_fletcher32", label.name);
    Handle dataset(H5Dcreate2(parent, label.name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                   H5Dclose, "H5Dcreate", label.name);
    write_attribute(dataset.id(), "units", label.unit);
    write_attribute(dataset.id(), "long_name", label.long_name);
    return dataset;
}

std::vector<hsize_t> sizes_of(const Dimensions& row) {
    std::vector<hsize_t> sizes;
    for (const Scale& scale : row) sizes.push_back(scale.size());
    return sizes;
}

hsize_t product(std::span<const hsize_t> sizes) {
    return std::accumulate(sizes.begin(), sizes.end(), hsize_t{1}, std::multiplies{});
}

/// The part of `dataset` from row `first`, selected in a space of the file.
Handle rows_of(const Handle& dataset, hsize_t first, hsize_t count, std::vector<hsize_t>& sizes,
               const std::string& name) {
    Handle space(H5Dget_space(dataset.id()), H5Sclose, "H5Dget_space", name);
    sizes.resize(
        static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.id()), "H5Sget_simple_extent_ndims", name)));
    check(H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr), "H5Sget_simple_extent_dims", name);
    if (sizes.empty() || first + count > sizes.front()) fail("reading beyond the end", name);
    sizes.front() = count;
    std::vector<hsize_t> begin(sizes.size(), 0);
    begin.front() = first;
    check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, begin.data(), nullptr, sizes.data(), nullptr),
          "H5Sselect_hyperslab", name);
    return space;
}

}  // namespace

template <class Value>
Series<Value>::Series(hid_t parent, const Label& label, const Dimensions& row, hsize_t chunk_rows)
    : name_(label.name), row_(sizes_of(row)), dataset_(create(parent, label, kept_type<Value>(), row_, chunk_rows)) {
    for (unsigned k = 0; k < row.size(); ++k)
        check(H5DSattach_scale(dataset_.id(), row[k].get().id(), k + 1), "H5DSattach_scale", name_);
}

template <class Value>
void Series<Value>::append(std::span<const Value> values) {
    const hsize_t added = values.size() / product(row_);
    if (added == 0) return;
    const std::vector<hsize_t> larger = with_rows(rows_ + added, row_);
    check(H5Dset_extent(dataset_.id(), larger.data()), "H5Dset_extent", name_);
    std::vector<hsize_t> sizes;
    const Handle there = rows_of(dataset_, rows_, added, sizes, name_);
    const Handle here = space_of(sizes, nullptr, name_);
    check(H5Dwrite(dataset_.id(), native_type<Value>(), here.id(), there.id(), H5P_DEFAULT, values.data()), "H5Dwrite",
          name_);
    rows_ += added;
}

template <class Value>
void Series<Value>::become_scale() {
    check(H5DSset_scale(dataset_.id(), name_.c_str()), "H5DSset_scale", name_);
}

template <class Value>
void Series<Value>::scales(hid_t dataset) const {
    check(H5DSattach_scale(dataset, dataset_.id(), 0), "H5DSattach_scale", name_);
}

template class Series<float>;
template class Series<double>;
template class Series<std::int32_t>;
template class Series<std::int8_t>;

template <class Value>
void read_block(hid_t parent, const std::string& name, hsize_t first, hsize_t count, std::vector<Value>& values) {
    const Handle dataset(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "H5Dopen", name);
    std::vector<hsize_t> sizes;
    const Handle there = rows_of(dataset, first, count, sizes, name);
    const Handle here = space_of(sizes, nullptr, name);
    values.resize(product(sizes));
    if (values.empty()) return;
    check(H5Dread(dataset.id(), native_type<Value>(), here.id(), there.id(), H5P_DEFAULT, values.data()), "H5Dread",
          name);
}
template void read_block<float>(hid_t, const std::string&, hsize_t, hsize_t, std::vector<float>&);
template void read_block<double>(hid_t, const std::string&, hsize_t, hsize_t, std::vector<double>&);
template void read_block<std::int32_t>(hid_t, const std::string&, hsize_t, hsize_t, std::vector<std::int32_t>&);

}  // namespace floes::hdf5
