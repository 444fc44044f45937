#include "hdf5/series.hpp"

#include <hdf5_hl.h>

#include <functional>
#include <numeric>

#include "hdf5/dataset.hpp"

namespace floes::hdf5 {
namespace {

constexpr unsigned fast_compression = 1;  // frames are written while a run waits

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
    const std::vector<hsize_t> most = with_rows(H5S_UNLIMITED, row);
    const Handle properties = compressed_properties(with_rows(chunk_rows, row), fast_compression, label.name);
    return create_dataset(parent, label, type, space_of(with_rows(0, row), most.data(), label.name), properties);
}

hsize_t product(std::span<const hsize_t> sizes) {
    return std::accumulate(sizes.begin(), sizes.end(), hsize_t{1}, std::multiplies{});
}

}  // namespace

template <class Value>
Series<Value>::Series(hid_t parent, const Label& label, const Dimensions& row, hsize_t chunk_rows)
    : name_(label.name), row_(sizes_of(row)), dataset_(create(parent, label, stored_type<Value>(), row_, chunk_rows)) {
    attach(dataset_, row, 1, name_);
}

template <class Value>
void Series<Value>::append(std::span<const Value> values) {
    const hsize_t added = values.size() / product(row_);
    if (added == 0) return;
    const std::vector<hsize_t> larger = with_rows(rows_ + added, row_);
    check(H5Dset_extent(dataset_.id(), larger.data()), "H5Dset_extent", name_);
    const Handle there(H5Dget_space(dataset_.id()), H5Sclose, "H5Dget_space", name_);
    const std::vector<hsize_t> first = with_rows(rows_, std::vector<hsize_t>(row_.size(), 0));
    const std::vector<hsize_t> count = with_rows(added, row_);
    check(H5Sselect_hyperslab(there.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr),
          "H5Sselect_hyperslab", name_);
    const Handle here = space_of(count, nullptr, name_);
    check(H5Dwrite(dataset_.id(), native_type<Value>(), here.id(), there.id(), H5P_DEFAULT, values.data()), "H5Dwrite",
          name_);
    digest_.add<Value>(values, product(row_));
    rows_ += added;
}

template <class Value>
void Series<Value>::finish() {
    write_digest(dataset_.id(), digest_.finish(dataset_.id()));
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

}  // namespace floes::hdf5
