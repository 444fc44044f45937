#include "hdf5/digest.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hdf5/dataset.hpp"
#include "hdf5/pages.hpp"
#include "hdf5/read.hpp"
#include "store/packed_arrays.hpp"

namespace floes::hdf5 {

namespace {

std::uint32_t folded(std::uint32_t sum) {
    return (sum & 0xffff) + (sum >> 16);
}

}  // namespace

void append_fletcher32(Bytes& chunk) {
    constexpr std::size_t most = 360;  // words that can be added before the sums have to be reduced
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    const auto word = [&](std::size_t at) {  // big endian; an odd last byte is the high one
        const auto first = std::to_integer<std::uint32_t>(chunk[at]);
        return first << 8 | (at + 1 < chunk.size() ? std::to_integer<std::uint32_t>(chunk[at + 1]) : 0);
    };
    for (std::size_t at = 0; at < chunk.size();) {
        for (const std::size_t end = std::min(at + 2 * most, chunk.size()); at < end; at += 2) {
            low += word(at);
            high += low;
        }
        low = folded(low);
        high = folded(high);
    }
    ByteWriter sum;
    sum.u32(folded(high) << 16 | folded(low));
    chunk.insert(chunk.end(), sum.bytes().begin(), sum.bytes().end());
}

namespace {

constexpr hsize_t piece_bytes = hsize_t{1} << 22;  // read at once
constexpr hsize_t texts_digested_at_once = hsize_t{1} << 16;
constexpr std::string_view kind_words[]{"values", "rows"};

std::string type_word(hid_t dataset) {
    const Handle type(H5Dget_type(dataset), H5Tclose, "H5Dget_type", "a dataset");
    const H5T_class_t of = H5Tget_class(type.id());
    if (of == H5T_STRING) return "text";
    return fmt::format("{}{}", of == H5T_FLOAT ? 'f' : of == H5T_INTEGER ? 'i' : 'x', H5Tget_size(type.id()));
}

std::vector<hsize_t> sizes_of_stored(hid_t dataset) {
    const Handle space(H5Dget_space(dataset), H5Sclose, "H5Dget_space", "a dataset");
    std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.id()))));
    if (!sizes.empty()) H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr);
    return sizes;
}

/// Calls `use` with the bytes of some rows after another.
template <class Use>
void for_pieces(const Handle& dataset, const std::string& name, const StoredShape& shape, hsize_t rows_at_once,
                const Use& use) {
    const hid_t id = dataset.id();
    const Handle type = stored_type(dataset, name);
    const Handle space = stored_space(dataset, name);
    std::vector<std::byte> bytes;
    for (hsize_t row = 0; row < shape.rows(); row += rows_at_once) {
        const hsize_t rows = std::min(rows_at_once, shape.rows() - row);
        bytes.resize(rows * shape.row_values * shape.value_bytes);
        if (bytes.empty()) return;
        const Handle memory = select_rows(space, shape.sizes, row, rows, name);
        check_read(H5Dread(id, type.id(), memory.id(), space.id(), H5P_DEFAULT, bytes.data()), id, name);
        use(std::span<const std::byte>(bytes));
    }
}

}  // namespace

std::string path_in_file(hid_t object) {
    const auto length = check(H5Iget_name(object, nullptr, 0), "H5Iget_name", "an object");
    std::string path(static_cast<std::size_t>(length) + 1, '\0');
    H5Iget_name(object, path.data(), path.size());
    path.resize(static_cast<std::size_t>(length));
    return path;
}

void DatasetDigest::add(std::span<const std::string> texts) {
    for (const std::string& text : texts) digest_.add_text(text);
}

void DatasetDigest::add_rows(std::span<const double> values, std::size_t width) {
    for (std::size_t row = 0; width > 0 && row < values.size(); row += width)
        add_row(checksum(values.subspan(row, width)));
}

StoredDigest DatasetDigest::finish(hid_t dataset) {
    const std::string about =
        fmt::format("{} {} {}", path_in_file(dataset), type_word(dataset), fmt::join(sizes_of_stored(dataset), "x"));
    digest_.add_text(about);
    return {kind_, digest_.hex()};
}

std::string digest_text(const StoredDigest& digest) {
    return fmt::format("{} {}", kind_words[static_cast<std::size_t>(digest.kind)], digest.hex);
}

void write_digest(hid_t dataset, const StoredDigest& digest) {
    write_attribute(dataset, digest_attribute, digest_text(digest));
}

std::optional<StoredDigest> read_digest(hid_t dataset) {
    if (!has_attribute(dataset, digest_attribute)) return std::nullopt;
    const std::string text = read_text_attribute(dataset, digest_attribute);
    for (const DigestKind kind : {DigestKind::values, DigestKind::rows}) {
        const std::string_view word = kind_words[static_cast<std::size_t>(kind)];
        if (text.starts_with(fmt::format("{} ", word))) return StoredDigest{kind, text.substr(word.size() + 1)};
    }
    refuse_damaged(dataset, fmt::format("{} has a digest of an unknown kind", path_in_file(dataset)));
}

namespace {

/// A column of many members has more texts than memory should hold.
void add_texts(const Handle& dataset, const std::string& name, const StoredShape& shape, DatasetDigest& digest) {
    if (shape.sizes.size() != 1) return digest.add(texts_of(dataset, name));
    const Handle type = text_type();
    const Handle space = stored_space(dataset, name);
    for (hsize_t row = 0; row < shape.rows(); row += texts_digested_at_once) {
        const hsize_t count = std::min(texts_digested_at_once, shape.rows() - row);
        const Handle memory = select_rows(space, shape.sizes, row, count, name);
        std::vector<char*> pointers(count, nullptr);
        check_read(H5Dread(dataset.id(), type.id(), memory.id(), space.id(), H5P_DEFAULT, pointers.data()),
                   dataset.id(), name);
        std::vector<std::string> texts;
        for (const char* text : pointers) texts.emplace_back(text != nullptr ? text : "");
        H5Dvlen_reclaim(type.id(), memory.id(), H5P_DEFAULT, pointers.data());
        digest.add(texts);
    }
}

}  // namespace

StoredDigest digest_of(const Handle& dataset, DigestKind kind) {
    const hid_t id = dataset.id();
    const std::string name = path_in_file(id);
    const StoredShape shape = shape_of(dataset, name, Portion::row);
    DatasetDigest digest(kind);
    if (shape.is_text) {
        add_texts(dataset, name, shape, digest);
    } else if (kind == DigestKind::rows) {
        if (shape.value_bytes != sizeof(double))
            refuse_damaged(id, fmt::format("the values of {} are no doubles", name));
        for_pieces(dataset, name, shape, 1, [&](std::span<const std::byte> row) {
            std::vector<double> values(row.size() / sizeof(double));
            std::ranges::copy(row, std::as_writable_bytes(std::span(values)).begin());
            digest.add<double>(values, values.size());
        });
    } else {
        const PassedValues until_compared(id);
        const hsize_t row_bytes = std::max<hsize_t>(1, shape.row_values * shape.value_bytes);
        for_pieces(dataset, name, shape, std::max<hsize_t>(1, piece_bytes / row_bytes),
                   [&](std::span<const std::byte> bytes) { digest.add_bytes(bytes); });
    }
    return digest.finish(id);
}

void check_digest(hid_t dataset, const std::string& name, const StoredDigest& stored, const StoredDigest& found) {
    if (!(stored == found)) refuse_damaged(dataset, fmt::format("{} does not fit its digest", name));
}

}  // namespace floes::hdf5
