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
#include "core/descriptor.hpp"

namespace floes::hdf5 {

/// Appends the digests to a closed file. Throws RunError if the system refuses.
void append_page_digests(const std::filesystem::path& path);

/// A file with such digests, open for reading.
class CheckedPages {
  public:
    /// None if the file has no digests of pages. Throws DamagedFile if the digests themselves are damaged.
    static std::optional<CheckedPages> open(const std::filesystem::path& path);

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
    CheckedPages(Descriptor file, std::filesystem::path path, std::uint64_t size, std::vector<std::uint32_t> digests);

    Descriptor file_;
    std::filesystem::path path_;
    std::uint64_t size_;
    std::vector<std::uint32_t> digests_;
    std::vector<bool> good_;  ///< pages that were found good before
    Bytes pages_;
    std::string fault_;
};

}  // namespace floes::hdf5
