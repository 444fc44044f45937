#include "hdf5/checked_driver.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "hdf5/pages.hpp"

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

/// What HDF5 passes from the file access properties to open().
struct Opening {
    std::optional<CheckedPages>* pages;
};

H5FD_t* open(const char*, unsigned, hid_t access, haddr_t) {
    return caught(
        [access]() -> H5FD_t* {
            const auto* opening = static_cast<const Opening*>(H5Pget_driver_info(access));
            if (opening == nullptr || !*opening->pages) return nullptr;
            std::optional<CheckedPages> pages = std::exchange(*opening->pages, std::nullopt);
            return std::make_unique<OpenFile>(std::move(*pages)).release();
        },
        static_cast<H5FD_t*>(nullptr));
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
