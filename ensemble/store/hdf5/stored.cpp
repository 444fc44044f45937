#include "hdf5/stored.hpp"

#include <fmt/format.h>

#include "hdf5/damage.hpp"

namespace floes::hdf5 {
namespace {

constexpr hsize_t most_from_a_byte = 1032;             // the largest factor of deflate
constexpr hsize_t most_unwritten = hsize_t{1} << 26;   // bytes; rows never written take no space
constexpr hsize_t most_in_a_chunk = hsize_t{1} << 28;  // bytes; a row of ten million steps is smaller

/// Bytes of one chunk, for which HDF5 allocates memory; 0 for a dataset without chunks.
hsize_t chunk_bytes(const Handle& dataset, const StoredShape& shape) {
    const Handle properties(H5Dget_create_plist(dataset.id()), H5Pclose, "H5Dget_create_plist", "a dataset");
    if (H5Pget_layout(properties.id()) != H5D_CHUNKED) return 0;
    std::vector<hsize_t> chunk(shape.sizes.size());
    if (H5Pget_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()) < 0) return most_in_a_chunk + 1;
    hsize_t bytes = shape.value_bytes;
    for (const hsize_t size : chunk)
        if (__builtin_mul_overflow(bytes, size, &bytes)) return most_in_a_chunk + 1;
    return bytes;
}

/// Sets the counts; false if they overflow.
bool count(StoredShape& shape) {
    hsize_t bytes = shape.value_bytes;
    for (std::size_t k = 0; k < shape.sizes.size(); ++k) {
        if (k > 0 && __builtin_mul_overflow(shape.row_values, shape.sizes[k], &shape.row_values)) return false;
        if (__builtin_mul_overflow(shape.count, shape.sizes[k], &shape.count)) return false;
        if (__builtin_mul_overflow(bytes, shape.sizes[k], &bytes)) return false;
    }
    return true;
}

bool is_possible(const Handle& dataset, StoredShape& shape, Portion portion) {
    if (shape.value_bytes == 0 || !count(shape)) return false;
    const hsize_t chunk = chunk_bytes(dataset, shape);
    const hsize_t stored = H5Dget_storage_size(dataset.id());
    const hsize_t bytes = shape.count * shape.value_bytes;
    if (chunk > most_in_a_chunk) return false;
    if (chunk == 0 && stored > 0)
        return shape.is_text ? bytes <= stored : bytes == stored;  // texts are stored elsewhere
    const hsize_t wanted = portion == Portion::whole ? bytes : shape.row_values * shape.value_bytes;
    return wanted <= most_unwritten || wanted / most_from_a_byte <= stored;
}

}  // namespace

Handle open_dataset(hid_t parent, const std::string& name) {
    return Handle(check_read(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), parent, name), H5Dclose, "H5Dopen", name);
}

Handle stored_space(const Handle& dataset, const std::string& name) {
    return Handle(check_read(H5Dget_space(dataset.id()), dataset.id(), name), H5Sclose, "H5Dget_space", name);
}

Handle stored_type(const Handle& dataset, const std::string& name) {
    return Handle(check_read(H5Dget_type(dataset.id()), dataset.id(), name), H5Tclose, "H5Dget_type", name);
}

StoredShape shape_of(const Handle& dataset, const std::string& name, Portion portion) {
    const hid_t id = dataset.id();
    const Handle space = stored_space(dataset, name);
    const Handle type = stored_type(dataset, name);
    StoredShape shape;
    shape.sizes.resize(static_cast<std::size_t>(check_read(H5Sget_simple_extent_ndims(space.id()), id, name)));
    check_read(H5Sget_simple_extent_dims(space.id(), shape.sizes.data(), nullptr), id, name);
    shape.is_text = H5Tget_class(type.id()) == H5T_STRING;
    shape.value_bytes = H5Tget_size(type.id());
    if (!is_possible(dataset, shape, portion))
        refuse_damaged(id, fmt::format("{} is said to be larger than what is stored of it", name));
    return shape;
}

std::vector<std::string> texts_of(const Handle& dataset, const std::string& name) {
    const hid_t id = dataset.id();
    const Handle space = stored_space(dataset, name);
    const Handle type = text_type();
    std::vector<char*> pointers(shape_of(dataset, name, Portion::whole).count, nullptr);
    check_read(H5Dread(id, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), id, name);
    std::vector<std::string> texts;
    for (const char* text : pointers) texts.emplace_back(text != nullptr ? text : "");
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, pointers.data());
    return texts;
}

}  // namespace floes::hdf5
