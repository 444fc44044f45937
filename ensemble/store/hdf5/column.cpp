#include "hdf5/column.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "hdf5/dataset.hpp"

namespace floes::hdf5 {
namespace {

constexpr hsize_t chunk_bytes = hsize_t{1} << 16;  // of each of some eighty columns that are open at a time
constexpr std::size_t texts_at_once = 1 << 10;

/// Chunks are written whole, so HDF5 need not hold any.
Handle access_without_cache(const std::string& name) {
    Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, "H5Pcreate", name);
    check(H5Pset_chunk_cache(access.id(), 0, 0, 0), "H5Pset_chunk_cache", name);
    return access;
}

template <class Value>
Handle create_column(hid_t parent, const Label& label, std::span<const hsize_t> sizes, std::optional<Value> missing) {
    return create_numbers<Value>(parent, label, sizes, missing,
                                 checked_properties(sizes, sizeof(Value), label.name, chunk_bytes),
                                 access_without_cache(label.name).id());
}

void require_all(hsize_t written, hsize_t rows, const std::string& name) {
    if (written != rows) throw std::logic_error(fmt::format("{} got {} of its {} rows", name, written, rows));
}

}  // namespace

template <class Value>
Column<Value>::Column(hid_t parent, const Label& label, const Dimensions& dimensions, std::optional<Value> missing)
    : name_(label.name),
      sizes_(sizes_of(dimensions)),
      width_(std::accumulate(sizes_.begin() + 1, sizes_.end(), hsize_t{1}, std::multiplies{})),
      rows_at_once_(rows_in_a_chunk(sizes_, sizeof(Value), chunk_bytes)),
      dataset_(create_column<Value>(parent, label, sizes_, missing)),
      space_(simple_space(sizes_)) {
    attach(dataset_, dimensions, 0, name_);
}

template <class Value>
Column<Value>::Column(hid_t parent, const Label& label, const Dimensions& dimensions, const Flags& flags)
    : Column(parent, label, dimensions, static_cast<std::optional<Value>>(flags.missing)) {
    write_flags(dataset_, flags);
}

template <class Value>
void Column<Value>::add(std::span<const Value> values) {
    for (std::size_t taken = 0; width_ > 0 && taken < values.size();) {
        const std::size_t room = rows_at_once_ * width_ - waiting_.size();
        const auto next = values.subspan(taken, std::min(room, values.size() - taken));
        waiting_.insert(waiting_.end(), next.begin(), next.end());
        taken += next.size();
        if (next.size() == room) write();
    }
}

template <class Value>
void Column<Value>::write() {
    if (waiting_.empty()) return;
    const hsize_t rows = waiting_.size() / width_;
    const Handle memory = select_rows(space_, sizes_, written_, rows, name_);
    check(H5Dwrite(dataset_.id(), native_type<Value>(), memory.id(), space_.id(), H5P_DEFAULT, waiting_.data()),
          "H5Dwrite", name_);
    digest_.add<Value>(waiting_, width_);
    written_ += rows;
    waiting_.clear();
}

template <class Value>
void Column<Value>::finish() {
    write();
    if (width_ > 0) require_all(written_, sizes_[0], name_);
    write_digest(dataset_.id(), digest_.finish(dataset_.id()));
}

template class Column<double>;
template class Column<std::int32_t>;
template class Column<std::int8_t>;

TextColumn::TextColumn(hid_t parent, const Label& label, const Dimensions& dimensions)
    : name_(label.name),
      rows_(sizes_of(dimensions).at(0)),
      type_(text_type()),
      dataset_(create_dataset(parent, label, type_.id(), simple_space(std::span(&rows_, 1)),
                              creation_properties(H5P_DATASET_CREATE))),
      space_(simple_space(std::span(&rows_, 1))) {
    attach(dataset_, dimensions, 0, name_);
}

void TextColumn::add(const std::string& text) {
    waiting_.push_back(text);
    if (waiting_.size() == texts_at_once) write();
}

void TextColumn::write() {
    if (waiting_.empty()) return;
    std::vector<const char*> pointers;
    for (const std::string& text : waiting_) pointers.push_back(text.c_str());
    const Handle memory = select_rows(space_, std::span(&rows_, 1), written_, waiting_.size(), name_);
    check(H5Dwrite(dataset_.id(), type_.id(), memory.id(), space_.id(), H5P_DEFAULT, pointers.data()), "H5Dwrite",
          name_);
    digest_.add(waiting_);
    written_ += waiting_.size();
    waiting_.clear();
}

void TextColumn::finish() {
    write();
    require_all(written_, rows_, name_);
    write_digest(dataset_.id(), digest_.finish(dataset_.id()));
}

}  // namespace floes::hdf5
