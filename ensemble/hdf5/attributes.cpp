#include "hdf5/attributes.hpp"

#include <array>

namespace floes::hdf5 {

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

}  // namespace floes::hdf5
