#pragma once
// Digests of datasets, and the checksum of HDF5's filter Fletcher32, whose function HDF5 does not export.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "core/bytes.hpp"
#include "core/digest.hpp"
#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// Appends the checksum of `chunk`, four bytes, to it.
void append_fletcher32(Bytes& chunk);

// Digests of datasets. They cover what HDF5's own checksums do not, and show whether two files have the same contents.
// They are made of the contents, not of how HDF5 stores them, and are the attribute `digest` of each dataset. Only for
// sources of modules with HDF5 files of their own.
//
//     values  XXH3-128 of all values, row-major, little endian; of texts the length of each (u64) and its bytes
//     rows    XXH3-128 of the Adler-32 (u32) of each row's bytes, shuffled: of tables whose rows come packed
//
// and in both, at the end, path, type and sizes of the dataset.

inline constexpr const char* digest_attribute = "digest";
/// Attribute of the root: the digest over everything outside /provenance.
inline constexpr const char* contents_attribute = "contents_digest";

enum class DigestKind { values, rows };

struct StoredDigest {
    DigestKind kind = DigestKind::values;
    std::string hex;
    friend bool operator==(const StoredDigest&, const StoredDigest&) = default;
};

/// Computed while values are written or read.
class DatasetDigest {
  public:
    explicit DatasetDigest(DigestKind kind = DigestKind::values) : kind_(kind) {}

    void add_bytes(std::span<const std::byte> values) { digest_.add(values); }
    /// Adds whole rows of `width` values.
    template <class Value>
    void add(std::span<const Value> values, std::size_t width) {
        if constexpr (std::is_same_v<Value, double>) {
            if (kind_ == DigestKind::rows) return add_rows(values, width);
        }
        add_bytes(std::as_bytes(values));
    }
    void add(std::span<const std::string> texts);
    /// For the kind `rows`: adds the checksum() of the next row.
    void add_row(std::uint32_t checksum) { add_bytes(std::as_bytes(std::span(&checksum, 1))); }

    /// Adds path, type and sizes of the dataset and returns the complete digest.
    StoredDigest finish(hid_t dataset);

  private:
    void add_rows(std::span<const double> values, std::size_t width);

    DigestKind kind_;
    StreamingDigest digest_;
};

/// The path of a group or dataset in its file.
std::string path_in_file(hid_t object);

/// As the attribute has it: "values" or "rows", and the digits.
std::string digest_text(const StoredDigest& digest);
void write_digest(hid_t dataset, const StoredDigest& digest);

/// The stored digest; none if the dataset is of an older layout or was added by another program.
std::optional<StoredDigest> read_digest(hid_t dataset);

/// The digest of a dataset as it is stored now, read piece by piece. Throws RunError where it cannot be read.
StoredDigest digest_of(const Handle& dataset, DigestKind kind);

/// Throws RunError unless the digests are equal.
void check_digest(hid_t dataset, const std::string& name, const StoredDigest& stored, const StoredDigest& found);

}  // namespace floes::hdf5
