#include "hdf5/write.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <hdf5_hl.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <numeric>
#include <optional>

#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "core/undefined.hpp"
#include "hdf5/dataset.hpp"
#include "hdf5/digest.hpp"

namespace floes::hdf5 {
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

Scale write_index_scale(hid_t parent, const char* name, const char* long_name, std::size_t count) {
    std::vector<std::int32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0);
    return write_scale(parent, Label{name, "1", long_name}, indices);
}

void write_text(hid_t parent, const Label& label, const std::string& text) {
    write_texts(parent, label, {}, std::span(&text, 1));
}

}  // namespace floes::hdf5
