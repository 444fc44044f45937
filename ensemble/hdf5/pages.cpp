#include "hdf5/pages.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/trial.hpp"
#include "hdf5/read.hpp"

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
    FLOES_EXPECTS(number < pages_in(bytes.size()));
    const auto rest = bytes.subspan(number * page_bytes);
    return rest.first(std::min<std::size_t>(rest.size(), page_bytes));
}

[[noreturn]] void refuse_digests(const std::filesystem::path& path) {
    throw DamagedFile(path.string(), "the digests of its pages are not those that were written");
}

}  // namespace

void append_page_digests(const std::filesystem::path& path) {
    const OpenFile file = open_file(path, O_RDWR | O_APPEND);
    const std::uint64_t size = file_size(file);
    ByteWriter table;
    Bytes bytes;
    for (std::uint64_t at = 0; at < size; at += at_once) {
        bytes.resize(std::min(at_once, size - at));
        if (!read_at(file, at, bytes)) throw RunError(fmt::format("{} became shorter", path.string()));
        for (std::uint64_t k = 0; k < pages_in(bytes.size()); ++k) table.u32(page_digest(page(bytes, k)));
    }
    for (const char letter : magic) table.u8(static_cast<std::uint8_t>(letter));
    table.u32(page_bytes);
    table.u64(size);
    table.u64(digest_of(table.bytes()));
    write_all(file, table.bytes());
}

std::optional<CheckedPages> CheckedPages::begin(const std::filesystem::path& path) {
    OpenFile file = open_file(path, O_RDONLY);
    const std::uint64_t all = file_size(file);
    Bytes foot(foot_bytes);
    if (all < foot_bytes || !read_at(file, all - foot_bytes, foot)) return std::nullopt;
    if (std::string_view(reinterpret_cast<const char*>(foot.data()), magic.size()) != magic) return std::nullopt;
    ByteReader in(std::span<const std::byte>(foot).subspan(magic.size()));
    const std::uint32_t bytes_each = in.u32();
    const std::uint64_t size = in.u64();
    const bool fits = bytes_each == page_bytes && size <= all - foot_bytes &&
                      pages_in(size) == (all - foot_bytes - size) / sizeof(std::uint32_t) &&
                      (all - foot_bytes - size) % sizeof(std::uint32_t) == 0;
    if (!fits) refuse_digests(path);
    return CheckedPages(std::move(file), size, true);
}

std::optional<CheckedPages> CheckedPages::open(const std::filesystem::path& path) {
    std::optional<CheckedPages> pages = begin(path);
    if (pages) pages->read_digests();
    return pages;
}

CheckedPages CheckedPages::open_source(const std::filesystem::path& path) {
    if (std::optional<CheckedPages> pages = begin(path)) return std::move(*pages);
    OpenFile file = open_file(path, O_RDONLY);
    const std::uint64_t size = file_size(file);
    return {std::move(file), size, false};
}

CheckedPages::CheckedPages(OpenFile file, std::uint64_t size, bool has_digests)
    : file_(std::move(file)), place_(place_of(file_)), size_(size), compares_(has_digests) {}

void CheckedPages::read_digests() {
    if (!compares_ || !digests_.empty()) return;
    Bytes table(file_size(file_) - size_);
    std::uint64_t digest = 0;
    if (!read_at(file_, size_, table)) refuse_digests(file_.path());
    const std::span<const std::byte> bytes(table);
    ByteReader last(bytes.last(sizeof digest));
    digest = last.u64();
    if (digest_of(bytes.first(bytes.size() - sizeof digest)) != digest) refuse_digests(file_.path());
    ByteReader in(table);
    digests_.resize(pages_in(size_));
    for (std::uint32_t& one : digests_) one = in.u32();
    good_.assign(digests_.size(), false);
}

bool CheckedPages::read(std::uint64_t at, std::span<std::byte> to) {
    if (to.empty()) return true;
    read_digests();
    const std::uint64_t first = at / page_bytes;
    const std::uint64_t begin = first * page_bytes;
    if (at > size_ || to.size() > size_ - at) {
        fault_ = fmt::format("bytes {} to {} lie behind its end", at, at + to.size() - 1);
        return false;
    }
    pages_.resize(std::min(pages_in(at + to.size()) * page_bytes, size_) - begin);
    if (!read_at(file_, begin, pages_)) {
        fault_ = fmt::format("it ends before byte {}", begin + pages_.size());
        return false;
    }
    std::ranges::copy(std::span(pages_).subspan(at - begin, to.size()), to.begin());
    for (std::uint64_t k = 0; compares_ && k < pages_in(pages_.size()); ++k) {
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

#if H5_VERS_MAJOR > 1 || H5_VERS_MINOR >= 13
#include <H5FDdevelop.h>
#endif

namespace floes::hdf5 {
namespace {

/// HDF5 passes a pointer to its own part, which comes first, to every function.
struct OpenFile : H5FD_t {
    explicit OpenFile(CheckedPages opened) : H5FD_t{}, pages(std::move(opened)) {}
    CheckedPages pages;
    bool passes_values = false;
    haddr_t end_of_allocated = 0;
};

OpenFile& mine(H5FD_t* file) {
    return *static_cast<OpenFile*>(file);
}
const OpenFile& mine(const H5FD_t* file) {
    return *static_cast<const OpenFile*>(file);
}

void report(const std::string& fault) {
    H5Epush2(H5E_DEFAULT, __FILE__, "CheckedPages::read", __LINE__, H5E_ERR_CLS, H5E_IO, H5E_READERROR, "%s",
             fault.c_str());
}

// No exception may pass through HDF5, which is C.
template <class Action, class Value>
Value caught(const Action& action, Value otherwise) {
    try {
        return action();
    } catch (const std::exception& error) {
        report(error.what());
        return otherwise;
    }
}

/// What HDF5 passes from the file access properties to open(). It passes none of them on to the sources of a virtual
/// dataset.
struct Opening {
    std::optional<CheckedPages>* pages;
};

H5FD_t* open(const char* path, unsigned, hid_t access, haddr_t) {
    return caught(
        [&]() -> H5FD_t* {
            const QuietErrors quiet;
            const auto* opening = static_cast<const Opening*>(H5Pget_driver_info(access));
            if (opening == nullptr) return std::make_unique<OpenFile>(CheckedPages::open_source(path)).release();
            if (!*opening->pages) return nullptr;
            std::optional<CheckedPages> pages = std::exchange(*opening->pages, std::nullopt);
            return std::make_unique<OpenFile>(std::move(*pages)).release();
        },
        static_cast<H5FD_t*>(nullptr));
}

/// 0 for the same file, which HDF5 then has open once.
int compare(const H5FD_t* one, const H5FD_t* other) {
    if (mine(one).pages.is_same_as(mine(other).pages)) return 0;
    return std::less<>()(one, other) ? -1 : 1;
}

herr_t close(H5FD_t* file) {
    const std::unique_ptr<OpenFile> ended(&mine(file));
    return 0;
}

haddr_t get_eoa(const H5FD_t* file, H5FD_mem_t) {
    return mine(file).end_of_allocated;
}

herr_t set_eoa(H5FD_t* file, H5FD_mem_t, haddr_t end) {
    mine(file).end_of_allocated = end;
    return 0;
}

haddr_t get_eof(const H5FD_t* file, H5FD_mem_t) {
    return mine(file).pages.size();
}

/// Whether data of a damaged page are passed to HDF5 nevertheless. A page holds parts of several datasets, and the
/// message should name the right one. Headers have checksums, which HDF5 verifies before it uses more than sizes of
/// them.
bool may_have(const OpenFile& file, H5FD_mem_t of) {
    return of == H5FD_MEM_OHDR || (of == H5FD_MEM_DRAW && file.passes_values);
}

herr_t read(H5FD_t* file, H5FD_mem_t of, hid_t, haddr_t at, std::size_t size, void* to) {
    CheckedPages& pages = mine(file).pages;
    // HDF5 guesses the length of the superblock and reads past the end of a tiny file; it gets zeros there.
    const auto inside = static_cast<std::size_t>(std::min<haddr_t>(size, pages.size() - std::min(at, pages.size())));
    const std::span bytes(static_cast<std::byte*>(to), size);
    std::ranges::fill(bytes.subspan(inside), std::byte{0});
    const bool good = caught([&] { return pages.read(at, bytes.first(inside)); }, false);
    if (good || may_have(mine(file), of)) return 0;
    report(pages.fault());
    return -1;
}

herr_t get_handle(H5FD_t* file, hid_t, void** handle) {
    *handle = file;
    return 0;
}

herr_t write(H5FD_t*, H5FD_mem_t, hid_t, haddr_t, std::size_t, const void*) {
    return -1;  // files are opened for reading only
}

H5FD_class_t driver_class() {
    H5FD_class_t of{};
#if H5_VERS_MAJOR > 1 || H5_VERS_MINOR >= 13
    of.version = H5FD_CLASS_VERSION;
    of.value = static_cast<H5FD_class_value_t>(511);  // of the range for drivers that are not registered with HDF5
#endif
    of.name = "floes_pages";
    of.maxaddr = HADDR_MAX / 2;
    of.fc_degree = H5F_CLOSE_WEAK;
    of.fapl_size = sizeof(Opening);
    of.open = open;
    of.close = close;
    of.cmp = compare;
    of.get_eoa = get_eoa;
    of.set_eoa = set_eoa;
    of.get_eof = get_eof;
    of.get_handle = get_handle;
    of.read = read;
    of.write = write;
    std::ranges::fill(of.fl_map, H5FD_MEM_DEFAULT);
    return of;
}

hid_t driver() {
    static const H5FD_class_t of = driver_class();
    static const hid_t registered = check(H5FDregister(&of), "H5FDregister", "the driver of checked pages");
    return registered;
}

/// None if the file of `object` is not read through checked pages.
OpenFile* open_file_of(hid_t object) {
    const Handle file(H5Iget_file_id(object), H5Fclose, "H5Iget_file_id", "a dataset");
    const Handle access(H5Fget_access_plist(file.id()), H5Pclose, "H5Fget_access_plist", "a file");
    if (H5Pget_driver(access.id()) != driver()) return nullptr;
    void* handle = nullptr;
    check(H5Fget_vfd_handle(file.id(), H5P_DEFAULT, &handle), "H5Fget_vfd_handle", "a file");
    return &mine(static_cast<H5FD_t*>(handle));
}

}  // namespace

void read_by_pages(const Handle& access, std::optional<CheckedPages>& pages) {
    const Opening opening{&pages};
    check(H5Pset_driver(access.id(), driver(), &opening), "H5Pset_driver", "file access");
}

std::string first_page_fault(hid_t file) {
    OpenFile* const opened = open_file_of(file);
    return opened == nullptr ? "" : opened->pages.first_fault();
}

PassedValues::PassedValues(hid_t object) : passes_(nullptr) {
    OpenFile* const file = open_file_of(object);
    if (file == nullptr) return;
    passes_ = &file->passes_values;
    *passes_ = true;
}

PassedValues::~PassedValues() {
    if (passes_ != nullptr) *passes_ = false;
}

}  // namespace floes::hdf5
namespace floes::hdf5 {

namespace {

void read_structure(const std::filesystem::path& path) {
    const Handle access = access_without_locks();
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, "H5Fopen", path.string());
    for (const std::string& name : paths_of(file.id()).datasets) {
        try {
            const Handle dataset = open_dataset(file.id(), name);
            if (shape_of(dataset, name, Portion::row).is_text) texts_of(dataset, name);
        } catch (const DamagedFile&) {
            continue;  // HDF5 reported an error instead of crashing
        }
    }
    contents_digests(file.id());
}

}  // namespace

void try_out(const std::filesystem::path& path) {
    if (const int signal = signal_of_trial([&] { read_structure(path); }); signal != 0)
        throw DamagedFile(path.string(), fmt::format("HDF5 cannot read it (it ends with signal {})", signal));
}

}  // namespace floes::hdf5
