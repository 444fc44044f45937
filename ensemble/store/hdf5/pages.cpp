#include "hdf5/pages.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "hdf5/damage.hpp"
#include "records/file_calls.hpp"

namespace floes::hdf5 {
namespace {

constexpr std::string_view magic = "floespgs";
constexpr std::uint32_t page_bytes = 512;  // as a disk's sectors, so that a damaged one touches few datasets
constexpr std::uint64_t at_once = 2048 * page_bytes;
constexpr std::uint64_t foot_bytes = 8 + 4 + 8 + 8;

std::uint64_t digest_of(std::span<const std::byte> bytes) {
    return digest64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::uint32_t page_digest(std::span<const std::byte> bytes) {
    return static_cast<std::uint32_t>(digest_of(bytes));
}

std::uint64_t pages_in(std::uint64_t bytes) {
    return bytes / page_bytes + (bytes % page_bytes > 0 ? 1 : 0);
}

std::span<const std::byte> page(std::span<const std::byte> bytes, std::uint64_t number) {
    const auto rest = bytes.subspan(number * page_bytes);
    return rest.first(std::min<std::size_t>(rest.size(), page_bytes));
}

}  // namespace

void append_page_digests(const std::filesystem::path& path) {
    const Descriptor file = open_file(path, O_RDWR | O_APPEND);
    const std::uint64_t size = file_size(file, path);
    ByteWriter table;
    Bytes bytes;
    for (std::uint64_t at = 0; at < size; at += at_once) {
        bytes.resize(std::min(at_once, size - at));
        if (!read_at(file, path, at, bytes)) throw RunError(fmt::format("{} became shorter", path.string()));
        for (std::uint64_t k = 0; k < pages_in(bytes.size()); ++k) table.u32(page_digest(page(bytes, k)));
    }
    for (const char letter : magic) table.u8(static_cast<std::uint8_t>(letter));
    table.u32(page_bytes);
    table.u64(size);
    table.u64(digest_of(table.bytes()));
    write_all(file, path, table.bytes());
}

std::optional<CheckedPages> CheckedPages::open(const std::filesystem::path& path) {
    Descriptor file = open_file(path, O_RDONLY);
    const std::uint64_t all = file_size(file, path);
    Bytes foot(foot_bytes);
    if (all < foot_bytes || !read_at(file, path, all - foot_bytes, foot)) return std::nullopt;
    if (std::string_view(reinterpret_cast<const char*>(foot.data()), magic.size()) != magic) return std::nullopt;
    ByteReader in(std::span<const std::byte>(foot).subspan(magic.size()));
    const std::uint32_t bytes_each = in.u32();
    const std::uint64_t size = in.u64();
    const std::uint64_t digest = in.u64();
    const bool fits = bytes_each == page_bytes && size <= all - foot_bytes &&
                      pages_in(size) == (all - foot_bytes - size) / sizeof(std::uint32_t) &&
                      (all - foot_bytes - size) % sizeof(std::uint32_t) == 0;
    Bytes table(fits ? all - size : 0);
    if (!fits || !read_at(file, path, size, table) ||
        digest_of(std::span<const std::byte>(table).first(table.size() - sizeof digest)) != digest)
        throw DamagedFile(path.string(), "the digests of its pages are not those that were written");
    ByteReader digests_in(table);
    std::vector<std::uint32_t> digests(pages_in(size));
    for (std::uint32_t& one : digests) one = digests_in.u32();
    return CheckedPages(std::move(file), path, size, std::move(digests));
}

CheckedPages::CheckedPages(Descriptor file, std::filesystem::path path, std::uint64_t size,
                           std::vector<std::uint32_t> digests)
    : file_(std::move(file)),
      path_(std::move(path)),
      size_(size),
      digests_(std::move(digests)),
      good_(digests_.size(), false) {}

bool CheckedPages::read(std::uint64_t at, std::span<std::byte> to) {
    if (to.empty()) return true;
    const std::uint64_t first = at / page_bytes;
    const std::uint64_t begin = first * page_bytes;
    if (at > size_ || to.size() > size_ - at) {
        fault_ = fmt::format("bytes {} to {} lie behind its end", at, at + to.size() - 1);
        return false;
    }
    pages_.resize(std::min(pages_in(at + to.size()) * page_bytes, size_) - begin);
    if (!read_at(file_, path_, begin, pages_)) {
        fault_ = fmt::format("it ends before byte {}", begin + pages_.size());
        return false;
    }
    std::ranges::copy(std::span(pages_).subspan(at - begin, to.size()), to.begin());
    for (std::uint64_t k = 0; k < pages_in(pages_.size()); ++k) {
        if (good_[first + k]) continue;
        good_[first + k] = page_digest(page(pages_, k)) == digests_[first + k];
        if (good_[first + k]) continue;
        const std::uint64_t from = begin + k * page_bytes;
        fault_ =
            fmt::format("bytes {} to {} are not those that were written", from, std::min(from + page_bytes, size_) - 1);
        return false;
    }
    return true;
}

std::string CheckedPages::first_fault() {
    Bytes bytes;
    for (std::uint64_t at = 0; at < size_; at += at_once) {
        bytes.resize(std::min(at_once, size_ - at));
        if (!read(at, bytes)) return fault_;
    }
    return "";
}

}  // namespace floes::hdf5
