#pragma once
// Digests of a file's pages, appended to an HDF5 file after the part that HDF5 reads. They cover every byte: HDF5 has
// no checksums for texts and for data without chunks, and can crash if these are damaged.
//
//     digest of each page of 512 bytes, the last one shorter (u32, the low half of XXH3-64)
//     floespgs  bytes of a page (u32)  bytes of all pages (u64)  XXH3-64 of all this before it (u64)
//
// All numbers are little endian. A file that another program has changed or repacked has lost them and is read without.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "hdf5/handle.hpp"
#include "store/file_calls.hpp"
#include "store/system.hpp"

namespace floes::hdf5 {

/// Appends the digests to a closed file. Throws RunError if the system refuses.
void append_page_digests(const std::filesystem::path& path);

/// A file with such digests, open for reading.
class CheckedPages {
  public:
    /// None if the file has no digests of pages. Throws DamagedFile if the digests themselves are damaged.
    static std::optional<CheckedPages> open(const std::filesystem::path& path);
    /// The same of a file that another refers to, which may be opened for each dataset again: its digests are read with
    /// the first page, and of one without digests nothing is compared.
    static CheckedPages open_source(const std::filesystem::path& path);

    /// Whether both are of the same file.
    bool is_same_as(const CheckedPages& other) const { return place_ == other.place_; }

    /// Bytes of all pages, which are the file as HDF5 sees it.
    std::uint64_t size() const { return size_; }
    /// Reads `to.size()` bytes from `at` on. Returns false if a page differs from what was written, or at the end of
    /// the file; the bytes are read in any case.
    bool read(std::uint64_t at, std::span<std::byte> to);
    /// The first page that the last read() found damaged, as "bytes 4096 to 4607 are not those that were written".
    const std::string& fault() const { return fault_; }
    /// Reads all pages and returns the fault() of the first damaged one; empty if all are good.
    std::string first_fault();

  private:
    CheckedPages(OpenFile file, std::uint64_t size, bool has_digests);
    static std::optional<CheckedPages> begin(const std::filesystem::path& path);
    void read_digests();

    OpenFile file_;
    FilePlace place_;
    std::uint64_t size_;
    bool compares_;                       ///< it has digests
    std::vector<std::uint32_t> digests_;  ///< none before they are read
    std::vector<bool> good_;              ///< pages that were found good before
    Bytes pages_;
    std::string fault_;
};

// Lets HDF5 read through CheckedPages, so that a damaged byte is an error before HDF5 interprets it. For this module
// only.

/// Makes `access` read the file of these `pages`. The file takes ownership of them when it is opened.
void read_by_pages(const Handle& access, std::optional<CheckedPages>& pages);

/// Reads all pages of an open file: CheckedPages::first_fault(); empty, too, where the file has no digests of them.
std::string first_page_fault(hid_t file);

/// While it exists, numbers from damaged pages of the file of `object` are passed on instead of refused. A page holds
/// parts of several datasets, so only the digest of a dataset shows whether it is this one. Not for texts, because HDF5
/// would follow damaged references to them.
class PassedValues {
  public:
    explicit PassedValues(hid_t object);
    ~PassedValues();
    PassedValues(const PassedValues&) = delete;
    PassedValues& operator=(const PassedValues&) = delete;

  private:
    bool* passes_;
};

// Tests in a child process whether HDF5 crashes over a file. For this module only.

/// Lets a child process read everything that HDF5 parses: headers, indices, attributes and texts. HDF5 1.10 crashes if
/// some of their bytes are damaged, and files of older layouts have no digests that would show this before. Throws
/// DamagedFile if the child crashes or hangs; other damage shows when the file is read. Not for processes under MPI.
void try_out(const std::filesystem::path& path);

}  // namespace floes::hdf5
