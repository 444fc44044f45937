#include "hdf5/columns.hpp"

#include <algorithm>

#include <hdf5_hl.h>

#include "core/contract.hpp"
#include "core/units.hpp"

namespace floes::hdf5 {

namespace {

constexpr hsize_t chunk_size = hsize_t{1} << 16;  // of each of some eighty columns that are open at a time
constexpr std::size_t texts_at_once = 1 << 10;

/// Chunks are written whole, so HDF5 need not hold any.
Handle access_without_cache(const std::string& name) {
    Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, "H5Pcreate", name);
    check(H5Pset_chunk_cache(access.id(), 0, 0, 0), "H5Pset_chunk_cache", name);
    return access;
}

template <class Value>
Handle create_column(hid_t parent, const Label& label, const Dimensions& dimensions, std::optional<Value> missing) {
    const std::vector<hsize_t> sizes = sizes_of(dimensions);
    const Scale& rows = dimensions.front();
    return create_numbers<Value>(parent, label, sizes, missing,
                                 rows.sources().empty()
                                     ? checked_properties(sizes, sizeof(Value), label.name, chunk_size)
                                     : virtual_properties(parent, label.name, sizes, rows),
                                 access_without_cache(label.name).id());
}

Handle create_texts(hid_t parent, const Label& label, const Handle& type, const Scale& rows) {
    const hsize_t size = rows.size();
    return create_dataset(parent, label, type.id(), simple_space(std::span(&size, 1)),
                          rows.sources().empty() ? creation_properties(H5P_DATASET_CREATE)
                                                 : virtual_properties(parent, label.name, std::span(&size, 1), rows));
}

void require_all(hsize_t written, hsize_t rows, const std::string& name) {
    if (written != rows) throw ContractError(fmt::format("{} got {} of its {} rows", name, written, rows));
}

}  // namespace

template <class Value>
Column<Value>::Column(hid_t parent, const Label& label, const Dimensions& dimensions, std::optional<Value> missing)
    : name_(label.name),
      sizes_(sizes_of(dimensions)),
      width_(product(std::span<const hsize_t>(sizes_).subspan(1))),
      rows_at_once_(rows_in_a_chunk(sizes_, sizeof(Value), chunk_size)),
      dataset_(create_column<Value>(parent, label, dimensions, missing)),
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
      dataset_(create_texts(parent, label, type_, dimensions.front())),
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

namespace {

constexpr std::uint32_t shuffle_and_deflate = 0b11;  // the filters before the checksum

Handle create_rows(hid_t parent, const Label& label, std::span<const hsize_t> sizes, const Scale& rows) {
    if (!rows.sources().empty())
        return create_numbers<double>(parent, label, sizes, undefined,
                                      virtual_properties(parent, label.name, sizes, rows));
    std::vector<hsize_t> chunk{1};
    for (const hsize_t size : sizes.subspan(1)) chunk.push_back(std::max<hsize_t>(size, 1));
    return create_numbers<double>(parent, label, sizes, undefined,
                                  compressed_properties(chunk, static_cast<unsigned>(compression_level), label.name));
}

/// Values as a row of a table that is `width` wide.
std::vector<double> filled_up(std::span<const double> values, std::size_t width) {
    std::vector<double> row(width, undefined);
    std::ranges::copy(values.first(std::min(values.size(), width)), row.begin());
    return row;
}

}  // namespace

Rows::Rows(hid_t parent, const Label& label, const Dimensions& dimensions)
    : name_(label.name),
      sizes_(sizes_of(dimensions)),
      width_(product(std::span<const hsize_t>(sizes_).subspan(1))),
      dataset_(create_rows(parent, label, sizes_, dimensions.front())),
      space_(simple_space(sizes_)),
      checksums_(width_ > 0 ? sizes_[0] : 0, checksum(filled_up({}, width_))) {
    attach(dataset_, dimensions, 0, name_);
}

void Rows::write(std::size_t row, std::span<const double> values) {
    if (values.empty() || width_ == 0) return;
    const std::vector<double> whole = filled_up(values, width_);
    checksums_.at(row) = checksum(whole);
    const Handle memory = select_rows(space_, sizes_, row, 1, name_);
    check(H5Dwrite(dataset_.id(), native_type<double>(), memory.id(), space_.id(), H5P_DEFAULT, whole.data()),
          "H5Dwrite", name_);
}

void Rows::write(std::size_t row, const PackedNumbers& values) {
    if (values.count != width_) return write(row, unpack(values));
    if (width_ == 0) return;
    checksums_.at(row) = checksum(values);
    std::vector<hsize_t> first(sizes_.size(), 0);
    first[0] = row;
    Bytes chunk = values.chunk;
    append_fletcher32(chunk);
    const std::uint32_t left_out = values.deflated() ? 0 : shuffle_and_deflate;
    check(H5Dwrite_chunk(dataset_.id(), H5P_DEFAULT, left_out, first.data(), chunk.size(), chunk.data()),
          "H5Dwrite_chunk", name_);
}

void Rows::finish() {
    DatasetDigest digest(DigestKind::rows);
    for (const std::uint32_t one : checksums_) digest.add_row(one);
    write_digest(dataset_.id(), digest.finish(dataset_.id()));
}

namespace {

constexpr unsigned fast_compression = 1;  // frames are written while a run waits

std::vector<hsize_t> with_rows(hsize_t rows, const std::vector<hsize_t>& row) {
    std::vector<hsize_t> sizes{rows};
    sizes.insert(sizes.end(), row.begin(), row.end());
    return sizes;
}

Handle create(hid_t parent, const Label& label, hid_t type, const std::vector<hsize_t>& row, hsize_t chunk_rows) {
    const std::vector<hsize_t> most = with_rows(H5S_UNLIMITED, row);
    const Handle properties = compressed_properties(with_rows(chunk_rows, row), fast_compression, label.name);
    const Handle space(H5Screate_simple(static_cast<int>(most.size()), with_rows(0, row).data(), most.data()), H5Sclose,
                       "H5Screate_simple", label.name);
    return create_dataset(parent, label, type, space, properties);
}

}  // namespace

template <class Value>
Series<Value>::Series(hid_t parent, const Label& label, const Dimensions& row, hsize_t chunk_rows)
    : name_(label.name), row_(sizes_of(row)), dataset_(create(parent, label, stored_type<Value>(), row_, chunk_rows)) {
    attach(dataset_, row, 1, name_);
}

template <class Value>
void Series<Value>::append(std::span<const Value> values) {
    const hsize_t width = product(std::span<const hsize_t>(row_));
    const hsize_t added = values.size() / width;
    if (added == 0) return;
    const std::vector<hsize_t> larger = with_rows(rows_ + added, row_);
    check(H5Dset_extent(dataset_.id(), larger.data()), "H5Dset_extent", name_);
    const Handle there(H5Dget_space(dataset_.id()), H5Sclose, "H5Dget_space", name_);
    const Handle here = select_rows(there, larger, rows_, added, name_);
    check(H5Dwrite(dataset_.id(), native_type<Value>(), here.id(), there.id(), H5P_DEFAULT, values.data()), "H5Dwrite",
          name_);
    digest_.add<Value>(values, width);
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
