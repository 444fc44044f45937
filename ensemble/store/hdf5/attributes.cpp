#include "hdf5/attributes.hpp"

#include <fmt/format.h>

#include <array>

#include "hdf5/damage.hpp"
#include "hdf5/names.hpp"

namespace floes::hdf5 {
namespace {

constexpr hssize_t most_values = 1 << 16;  // an attribute of floes has a few

Handle open_attribute(hid_t object, const std::string& name) {
    const std::string about = fmt::format("the attribute {}", name);
    return Handle(check_read(H5Aopen(object, name.c_str(), H5P_DEFAULT), object, about), H5Aclose, "H5Aopen", about);
}

std::size_t count_of(const Handle& attribute, const std::string& name) {
    const Handle space(check_read(H5Aget_space(attribute.id()), attribute.id(), name), H5Sclose, "H5Aget_space", name);
    const hssize_t count = check_read(H5Sget_simple_extent_npoints(space.id()), attribute.id(), name);
    if (count > most_values) refuse_damaged(attribute.id(), fmt::format("the attribute {} is too large", name));
    return static_cast<std::size_t>(count);
}

}  // namespace

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

bool has_attribute(hid_t object, const std::string& name) {
    return check_read(H5Aexists(object, name.c_str()), object, fmt::format("the attribute {}", name)) > 0;
}

std::string read_text_attribute(hid_t object, const std::string& name) {
    const Handle attribute = open_attribute(object, name);
    if (count_of(attribute, name) != 1) refuse_damaged(object, fmt::format("the attribute {} is no single text", name));
    const Handle space(H5Aget_space(attribute.id()), H5Sclose, "H5Aget_space", name);
    const Handle type = text_type();
    char* text = nullptr;
    check_read(H5Aread(attribute.id(), type.id(), &text), object, fmt::format("the attribute {}", name));
    std::string value = text != nullptr ? text : "";
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, &text);
    return value;
}

std::vector<std::int32_t> read_int_attribute(hid_t object, const std::string& name) {
    const Handle attribute = open_attribute(object, name);
    std::vector<std::int32_t> values(count_of(attribute, name));
    check_read(H5Aread(attribute.id(), native_type<std::int32_t>(), values.data()), object,
               fmt::format("the attribute {}", name));
    return values;
}

std::vector<std::string> attribute_names(hid_t object) {
    return names_in_order<H5A_info_t>([object](auto* visit, void* names) {
        hsize_t at = 0;
        check_read(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, &at, visit, names), object, "its attributes");
    });
}

}  // namespace floes::hdf5
