#include "hdf5/rows.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "hdf5/dataset.hpp"
#include "hdf5/digest.hpp"
#include "hdf5/fletcher32.hpp"

namespace floes::hdf5 {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t shuffle_and_deflate = 0b11;  // the filters before the checksum

std::vector<hsize_t> sizes_of(const Scale& rows, const Dimensions& columns) {
    std::vector<hsize_t> sizes = sizes_of(columns);
    sizes.insert(sizes.begin(), rows.size());
    return sizes;
}

Handle create_rows(hid_t parent, const Label& label, std::span<const hsize_t> sizes) {
    std::vector<hsize_t> chunk{1};
    for (const hsize_t size : sizes.subspan(1)) chunk.push_back(std::max<hsize_t>(size, 1));
    return create_numbers<double>(parent, label, sizes, nan,
                                  compressed_properties(chunk, static_cast<unsigned>(compression_level), label.name));
}

/// Values as a row of a table that is `width` wide.
std::vector<double> filled_up(std::span<const double> values, std::size_t width) {
    std::vector<double> row(width, nan);
    std::ranges::copy(values.first(std::min(values.size(), width)), row.begin());
    return row;
}

}  // namespace

Rows::Rows(hid_t parent, const Label& label, const Scale& rows, const Dimensions& columns)
    : name_(label.name),
      sizes_(sizes_of(rows, columns)),
      width_(std::accumulate(sizes_.begin() + 1, sizes_.end(), hsize_t{1}, std::multiplies{})),
      dataset_(create_rows(parent, label, sizes_)),
      space_(simple_space(sizes_)),
      checksums_(width_ > 0 ? rows.size() : 0, checksum(filled_up({}, width_))) {
    Dimensions all{rows};
    all.insert(all.end(), columns.begin(), columns.end());
    attach(dataset_, all, 0, name_);
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

}  // namespace floes::hdf5
