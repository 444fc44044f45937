#include "hdf5/read.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/utf8.hpp"
#include "hdf5/checked_driver.hpp"
#include "hdf5/damage.hpp"
#include "hdf5/digest.hpp"
#include "hdf5/pages.hpp"
#include "hdf5/stored.hpp"
#include "hdf5/trial.hpp"

namespace floes::hdf5 {
namespace {

constexpr std::size_t most_values_at_once = std::size_t{1} << 26;  // half a gigabyte of doubles

/// Whether the layout of the file gives every dataset a digest.
bool has_digests(hid_t parent) {
    const Handle root(check_read(H5Oopen(parent, "/", H5P_DEFAULT), parent, "its root"), H5Oclose, "H5Oopen", "/");
    return has_attribute(root.id(), contents_attribute);
}

/// The digest of a dataset; files of older layouts have none. Read it before values from damaged pages are passed on:
/// the digest is a text in a heap, and HDF5 crashes if that is damaged.
std::optional<StoredDigest> stored_digest(hid_t parent, const Handle& dataset, const std::string& name) {
    std::optional<StoredDigest> stored = read_digest(dataset.id());
    if (!stored && has_digests(parent)) refuse_damaged(parent, fmt::format("{} has lost its digest", name));
    return stored;
}

/// Compares the stored digest with that of the values that `add` adds.
template <class Add>
void compare(const Handle& dataset, const std::string& name, const std::optional<StoredDigest>& stored,
             const Add& add) {
    if (!stored) return;
    DatasetDigest digest(stored->kind);
    add(digest);
    check_digest(dataset.id(), name, *stored, digest.finish(dataset.id()));
}

}  // namespace

Handle open_for_reading(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) throw InputError(fmt::format("there is no file {}.", path.string()));
    if (H5Fis_hdf5(path.c_str()) <= 0)
        throw InputError(fmt::format("{} is not an HDF5 file; give the .h5 that floes run wrote.", path.string()));
    const Handle access = access_without_locks();
    std::optional<CheckedPages> pages = CheckedPages::open(path);
    if (pages) {
        read_by_pages(access, pages);
    } else {
        try_out(path);
    }
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id());
    if (file < 0) throw DamagedFile(path.string(), fmt::format("HDF5 cannot open it ({})", last_reason()));
    return Handle(file, H5Fclose, "H5Fopen", path.string());
}

bool exists(hid_t parent, const std::string& name) {
    for (std::size_t end = 0; end != std::string::npos;) {  // HDF5 wants each group on the path to exist
        end = name.find('/', end + 1);
        if (check_read(H5Lexists(parent, name.substr(0, end).c_str(), H5P_DEFAULT), parent, name) == 0) return false;
    }
    return true;
}

template <class Value>
std::vector<Value> read_values(hid_t parent, const std::string& name) {
    const Handle dataset = open_dataset(parent, name);
    const StoredShape shape = shape_of(dataset, name, Portion::whole);
    std::vector<Value> values(shape.count);
    if (shape.is_text) refuse_damaged(parent, fmt::format("{} has texts where numbers belong", name));
    const std::optional<StoredDigest> stored = stored_digest(parent, dataset, name);
    const PassedValues until_compared(dataset.id());
    check_read(H5Dread(dataset.id(), native_type<Value>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), parent, name);
    compare(dataset, name, stored, [&](DatasetDigest& digest) {
        if (H5Tequal(stored_type(dataset, name).id(), stored_type<Value>()) <= 0)
            refuse_damaged(parent, fmt::format("{} has another type", name));
        digest.add<Value>(values, shape.row_values);
    });
    return values;
}
template std::vector<double> read_values<double>(hid_t, const std::string&);
template std::vector<std::int32_t> read_values<std::int32_t>(hid_t, const std::string&);
template std::vector<std::int8_t> read_values<std::int8_t>(hid_t, const std::string&);

template <class Value>
RowReader<Value>::RowReader(hid_t parent, const std::string& name)
    : name_(name), dataset_(open_dataset(parent, name)), space_(stored_space(dataset_, name)) {
    const StoredShape shape = shape_of(dataset_, name, Portion::row);
    if (shape.sizes.empty()) refuse_damaged(parent, fmt::format("{} has no rows", name));
    sizes_ = shape.sizes;
    width_ = shape.row_values;
}

template <class Value>
std::span<const Value> RowReader<Value>::read(std::size_t row, std::size_t rows) {
    if (row > sizes_[0] || rows > sizes_[0] - row)
        refuse_damaged(dataset_.id(), fmt::format("{} ends before row {}", name_, row + rows));
    std::vector<hsize_t> first(sizes_.size(), 0);
    std::vector<hsize_t> count = sizes_;
    first[0] = row;
    count[0] = rows;
    const hsize_t length = rows * width_;
    if (length > most_values_at_once)
        refuse_damaged(dataset_.id(), fmt::format("{} rows of {} are too many", rows, name_));
    values_.resize(length);
    if (length == 0) return values_;
    check_read(H5Sselect_hyperslab(space_.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr),
               dataset_.id(), name_);
    const Handle memory = simple_space(std::span(&length, 1));
    check_read(H5Dread(dataset_.id(), native_type<Value>(), memory.id(), space_.id(), H5P_DEFAULT, values_.data()),
               dataset_.id(), fmt::format("row {} of {}", row, name_));
    return values_;
}
template class RowReader<double>;
template class RowReader<float>;
template class RowReader<std::int32_t>;

std::vector<std::string> read_texts(hid_t parent, const std::string& name) {
    const Handle dataset = open_dataset(parent, name);
    std::vector<std::string> texts = texts_of(dataset, name);
    compare(dataset, name, stored_digest(parent, dataset, name),
            [&](DatasetDigest& digest) { digest.add(std::span<const std::string>(texts)); });
    for (const std::string& text : texts)
        if (!is_utf8(text)) refuse_damaged(parent, fmt::format("a text of {} is not UTF-8", name));
    return texts;
}

}  // namespace floes::hdf5
