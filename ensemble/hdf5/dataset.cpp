#include "hdf5/dataset.hpp"

#include <fcntl.h>
#include <hdf5_hl.h>

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "hdf5/digest.hpp"

namespace floes::hdf5 {

constexpr unsigned creation_order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;

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
    FLOES_EXPECTS(!sizes.empty() && value_bytes > 0);
    const hsize_t row = value_bytes * product(sizes.subspan(1));
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

namespace {

/// HDF5 takes "%" in the names of sources for a pattern.
std::string without_patterns(const std::string& name) {
    std::string plain;
    for (const char letter : name) plain += letter == '%' ? std::string("%%") : std::string(1, letter);
    return plain;
}

}  // namespace

Handle virtual_properties(hid_t parent, const std::string& name, std::span<const hsize_t> sizes, const Scale& rows) {
    Handle properties = creation_properties(H5P_DATASET_CREATE);
    if (std::ranges::find(sizes, hsize_t{0}) != sizes.end()) return properties;
    const std::string group = path_in_file(parent);
    const std::string path = without_patterns(fmt::format("{}/{}", group == "/" ? "" : group, name));
    const Handle here = simple_space(sizes);
    hsize_t first = 0;
    for (const RowSource& source : rows.sources()) {
        if (source.rows == 0) continue;
        const Handle there = select_rows(here, sizes, first, source.rows, name);
        check(
            H5Pset_virtual(properties.id(), here.id(), without_patterns(source.file).c_str(), path.c_str(), there.id()),
            "H5Pset_virtual", name);
        first += source.rows;
    }
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
    if (sizes.empty()) return simple_space(sizes);
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

namespace {

void write_whole(const Handle& dataset, hid_t type, const void* values, const std::string& name) {
    check(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "H5Dwrite", name);
}

std::vector<const char*> pointers_to(std::span<const std::string> texts) {
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    return pointers;
}

template <class Value>
Handle write_numbers(hid_t parent, const Label& label, std::span<const hsize_t> sizes, std::span<const Value> values,
                     std::optional<Value> missing) {
    Handle dataset =
        create_numbers<Value>(parent, label, sizes, missing, checked_properties(sizes, sizeof(Value), label.name));
    write_whole(dataset, native_type<Value>(), values.data(), label.name);
    DatasetDigest digest;
    digest.add<Value>(values, 1);
    write_digest(dataset.id(), digest.finish(dataset.id()));
    return dataset;
}

Handle write_texts(hid_t parent, const Label& label, std::span<const hsize_t> sizes,
                   std::span<const std::string> texts) {
    const Handle type = text_type();
    Handle dataset =
        create_dataset(parent, label, type.id(), simple_space(sizes), creation_properties(H5P_DATASET_CREATE));
    write_whole(dataset, type.id(), pointers_to(texts).data(), label.name);
    DatasetDigest digest;
    digest.add(texts);
    write_digest(dataset.id(), digest.finish(dataset.id()));
    return dataset;
}

Scale as_scale(Handle dataset, hsize_t size, const std::string& name) {
    check(H5DSset_scale(dataset.id(), name.c_str()), "H5DSset_scale", name);
    return Scale(std::move(dataset), size);
}

/// Why a file cannot be made there, in the words of the operating system rather than those of HDF5.
[[noreturn]] void refuse_place(const std::filesystem::path& path) {
    const std::string reason = last_reason();
    const Descriptor tried(::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    if (tried.get() >= 0) {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
        throw RunError(fmt::format("{} cannot be written ({}); has its disk free space?", path.string(), reason));
    }
    throw RunError(fmt::format("{} cannot be written: {}. The folder must exist and permit it.", path.string(),
                               std::strerror(errno)));
}

}  // namespace

Handle create_file(const std::filesystem::path& path) {
    const Handle access = access_for_writing();
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation_properties(H5P_FILE_CREATE).id(), access.id());
    if (file < 0) refuse_place(path);
    return Handle(file, H5Fclose, "H5Fcreate", path.string());
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
    attach(write_numbers<double>(parent, label, sizes_of(dimensions), values, undefined), dimensions, 0, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::string> values) {
    attach(write_texts(parent, label, sizes_of(dimensions), values), dimensions, 0, label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int32_t> values,
                  std::optional<std::int32_t> missing) {
    attach(write_numbers<std::int32_t>(parent, label, sizes_of(dimensions), values, missing), dimensions, 0,
           label.name);
}

void write_values(hid_t parent, const Label& label, const Dimensions& dimensions, std::span<const std::int8_t> values,
                  const Flags& flags) {
    const Handle dataset = write_numbers<std::int8_t>(parent, label, sizes_of(dimensions), values, flags.missing);
    write_flags(dataset, flags);
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

Scale write_index_scale(hid_t parent, const char* name, const char* long_name, std::size_t count, std::size_t first) {
    std::vector<std::int32_t> indices(count);
    std::iota(indices.begin(), indices.end(), static_cast<std::int32_t>(first));
    return write_scale(parent, Label{name, "1", long_name}, indices);
}

void write_text(hid_t parent, const Label& label, const std::string& text) {
    write_texts(parent, label, {}, std::span(&text, 1));
}

}  // namespace floes::hdf5
