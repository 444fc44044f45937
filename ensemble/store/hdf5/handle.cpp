#include "hdf5/handle.hpp"

#include <string>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes::hdf5 {
namespace {

// The innermost entry of HDF5's error stack says what went wrong.
herr_t keep_description(unsigned, const H5E_error2_t* error, void* data) {
    *static_cast<std::string*>(data) = error->desc != nullptr ? error->desc : "";
    return 0;
}

}  // namespace

std::string last_reason() {
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_description, &reason);
    return reason.empty() ? "no reason given" : reason;
}

void fail(std::string_view call, std::string_view about) {
    throw RunError(fmt::format("{} of {} failed: {}", call, about, last_reason()));
}

void Handle::close(std::string_view call, std::string_view about) {
    check(close_(std::exchange(id_, -1)), call, about);
}

QuietErrors::QuietErrors() {
    // A damaged file can leave HDF5 with objects that it cannot close; it would complain of them when the program ends.
    // All files are closed by then.
    static const bool left_alone = H5dont_atexit() >= 0;
    static_cast<void>(left_alone);
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietErrors::~QuietErrors() {
    H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

Handle access_without_locks() {
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "H5Pcreate", "file access");
    check(H5Pset_file_locking(access.id(), false, true), "H5Pset_file_locking", "file access");
    return access;
}

Handle access_for_writing() {
    Handle access = access_without_locks();
    check(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "H5Pset_libver_bounds", "file access");
    return access;
}

Handle text_type() {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "H5Tcopy", "text type");
    check(H5Tset_size(type.id(), H5T_VARIABLE), "H5Tset_size", "text type");
    check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "H5Tset_cset", "text type");
    return type;
}

}  // namespace floes::hdf5
