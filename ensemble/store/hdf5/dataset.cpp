#include "hdf5/dataset.hpp"

#include <hdf5_hl.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace floes::hdf5 {
namespace {

constexpr unsigned creation_order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;

}  // namespace

Handle creation_properties(hid_t kind) {
    Handle properties(H5Pcreate(kind), H5Pclose, "H5Pcreate", "creation properties");
    check(H5Pset_obj_track_times(properties.id(), false), "H5Pset_obj_track_times", "creation properties");
    check(H5Pset_attr_creation_order(properties.id(), creation_order), "H5Pset_attr_creation_order", "properties");
    if (kind != H5P_DATASET_CREATE)
        check(H5Pset_link_creation_order(properties.id(), creation_order), "H5Pset_link_creation_order", "properties");
    return properties;
}

Handle compressed_properties(std::span<const hsize_t> chunk, unsigned level, const std::string& name) {
    Handle properties = creation_properties(H5P_DATASET_CREATE);
    check(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()), "H5Pset_chunk", name);
    check(H5Pset_shuffle(properties.id()), "H5Pset_shuffle", name);
    check(H5Pset_deflate(properties.id(), level), "H5Pset_deflate", name);
    check(H5Pset_fletcher32(properties.id()), "H5Pset_fletcher32", name);
    return properties;
}

hsize_t rows_in_a_chunk(std::span<const hsize_t> sizes, std::size_t value_bytes, hsize_t most_in_a_chunk) {
    const hsize_t row = std::accumulate(sizes.begin() + 1, sizes.end(), hsize_t{value_bytes}, std::multiplies{});
    return std::clamp<hsize_t>(most_in_a_chunk / std::max<hsize_t>(row, 1), 1, std::max<hsize_t>(sizes[0], 1));
}

Handle checked_properties(std::span<const hsize_t> sizes, std::size_t value_bytes, const std::string& name,
                          hsize_t most_in_a_chunk) {
    Handle properties = creation_properties(H5P_DATASET_CREATE);
    if (sizes.empty() || std::ranges::find(sizes, hsize_t{0}) != sizes.end()) return properties;
    std::vector<hsize_t> chunk(sizes.begin(), sizes.end());
    chunk[0] = rows_in_a_chunk(sizes, value_bytes, most_in_a_chunk);
    check(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()), "H5Pset_chunk", name);
    check(H5Pset_fletcher32(properties.id()), "H5Pset_fletcher32", name);
    return properties;
}

Handle create_dataset(hid_t parent, const Label& label, hid_t type, const Handle& space, const Handle& properties,
                      hid_t access) {
    Handle dataset(H5Dcreate2(parent, label.name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), access),
                   H5Dclose, "H5Dcreate", label.name);
    write_attribute(dataset.id(), "units", label.unit);
    write_attribute(dataset.id(), "long_name", label.long_name);
    return dataset;
}

void write_flags(const Handle& dataset, const Flags& flags) {
    write_attribute(dataset.id(), "flag_values", flags.values);
    write_attribute(dataset.id(), "flag_meanings", flags.meanings);
}

Handle select_rows(const Handle& space, std::span<const hsize_t> sizes, hsize_t begin, hsize_t rows,
                   const std::string& name) {
    std::vector<hsize_t> first(sizes.size(), 0);
    std::vector<hsize_t> count(sizes.begin(), sizes.end());
    first[0] = begin;
    count[0] = rows;
    check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr),
          "H5Sselect_hyperslab", name);
    return simple_space(count);
}

std::vector<hsize_t> sizes_of(const Dimensions& dimensions) {
    std::vector<hsize_t> sizes;
    for (const Scale& scale : dimensions) sizes.push_back(scale.size());
    return sizes;
}

void attach(const Handle& dataset, const Dimensions& dimensions, unsigned first, const std::string& name) {
    for (unsigned k = 0; k < dimensions.size(); ++k)
        check(H5DSattach_scale(dataset.id(), dimensions[k].get().id(), first + k), "H5DSattach_scale", name);
}

}  // namespace floes::hdf5
