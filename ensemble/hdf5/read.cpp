#include "hdf5/read.hpp"

#include <fmt/format.h>

#include <functional>
#include <numeric>

#include "core/error.hpp"

namespace floes::hdf5 {
namespace {

Handle open_attribute(hid_t object, const std::string& name) {
    return Handle(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "H5Aopen", name);
}

Handle open_dataset(hid_t parent, const std::string& name) {
    return Handle(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "H5Dopen", name);
}

std::size_t count_of(const Handle& space, const std::string& name) {
    return static_cast<std::size_t>(
        check(H5Sget_simple_extent_npoints(space.id()), "H5Sget_simple_extent_npoints", name));
}

Handle space_of(const Handle& dataset, const std::string& name) {
    return Handle(H5Dget_space(dataset.id()), H5Sclose, "H5Dget_space", name);
}

}  // namespace

Handle open_for_reading(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) throw InputError(fmt::format("there is no file {}.", path.string()));
    const Handle access = access_without_locks();
    if (H5Fis_hdf5(path.c_str()) <= 0)
        throw InputError(fmt::format("{} is not an HDF5 file; give the .h5 that floes run wrote.", path.string()));
    return Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, "H5Fopen", path.string());
}

bool exists(hid_t parent, const std::string& name) {
    for (std::size_t end = 0; end != std::string::npos;) {  // each folder of the path must be there to be asked
        end = name.find('/', end + 1);
        if (H5Lexists(parent, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    }
    return true;
}

bool has_attribute(hid_t object, const std::string& name) {
    return check(H5Aexists(object, name.c_str()), "H5Aexists", name) > 0;
}

std::string read_text_attribute(hid_t object, const std::string& name) {
    const Handle attribute = open_attribute(object, name);
    const Handle space(H5Aget_space(attribute.id()), H5Sclose, "H5Aget_space", name);
    const Handle type = text_type();
    char* text = nullptr;
    check(H5Aread(attribute.id(), type.id(), &text), "H5Aread", name);
    std::string value = text != nullptr ? text : "";
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, &text);
    return value;
}

std::vector<std::int32_t> read_int_attribute(hid_t object, const std::string& name) {
    const Handle attribute = open_attribute(object, name);
    const Handle space(H5Aget_space(attribute.id()), H5Sclose, "H5Aget_space", name);
    std::vector<std::int32_t> values(count_of(space, name));
    check(H5Aread(attribute.id(), native_type<std::int32_t>(), values.data()), "H5Aread", name);
    return values;
}

template <class Value>
std::vector<Value> read_values(hid_t parent, const std::string& name) {
    const Handle dataset = open_dataset(parent, name);
    std::vector<Value> values(count_of(space_of(dataset, name), name));
    check(H5Dread(dataset.id(), native_type<Value>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "H5Dread", name);
    return values;
}
template std::vector<double> read_values<double>(hid_t, const std::string&);
template std::vector<std::int32_t> read_values<std::int32_t>(hid_t, const std::string&);
template std::vector<std::int8_t> read_values<std::int8_t>(hid_t, const std::string&);

template <class Value>
RowReader<Value>::RowReader(hid_t parent, const std::string& name)
    : name_(name), dataset_(open_dataset(parent, name)), space_(space_of(dataset_, name)) {
    const int dimensions = check(H5Sget_simple_extent_ndims(space_.id()), "H5Sget_simple_extent_ndims", name_);
    sizes_.resize(static_cast<std::size_t>(dimensions));
    check(H5Sget_simple_extent_dims(space_.id(), sizes_.data(), nullptr), "H5Sget_simple_extent_dims", name_);
}

template <class Value>
std::span<const Value> RowReader<Value>::read(std::size_t row, std::size_t rows) {
    if (row + rows > sizes_[0]) throw RunError(fmt::format("{} ends before row {}.", name_, row + rows));
    std::vector<hsize_t> first(sizes_.size(), 0);
    std::vector<hsize_t> count = sizes_;
    first[0] = row;
    count[0] = rows;
    const hsize_t length = std::accumulate(count.begin(), count.end(), hsize_t{1}, std::multiplies{});
    values_.resize(length);
    if (length == 0) return values_;
    check(H5Sselect_hyperslab(space_.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr),
          "H5Sselect_hyperslab", name_);
    const Handle memory(H5Screate_simple(1, &length, nullptr), H5Sclose, "H5Screate_simple", name_);
    check(H5Dread(dataset_.id(), native_type<Value>(), memory.id(), space_.id(), H5P_DEFAULT, values_.data()),
          "H5Dread", name_);
    return values_;
}
template class RowReader<double>;
template class RowReader<float>;
template class RowReader<std::int32_t>;

std::vector<std::string> read_texts(hid_t parent, const std::string& name) {
    const Handle dataset = open_dataset(parent, name);
    const Handle space = space_of(dataset, name);
    const Handle type = text_type();
    std::vector<char*> pointers(count_of(space, name), nullptr);
    check(H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), "H5Dread", name);
    std::vector<std::string> texts;
    for (const char* text : pointers) texts.emplace_back(text != nullptr ? text : "");
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, pointers.data());
    return texts;
}

}  // namespace floes::hdf5
