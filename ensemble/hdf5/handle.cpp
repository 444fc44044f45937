#include "hdf5/handle.hpp"

#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "hdf5/dataset.hpp"
#include "hdf5/read.hpp"
#include "store/session.hpp"

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
    // Where the operating system refused, only its words are for people: "... error message = 'No space left on
    // device'".
    constexpr std::string_view words = "error message = '";
    if (const std::size_t at = reason.find(words); at != std::string::npos) {
        const std::size_t first = at + words.size();
        return reason.substr(first, reason.find('\'', first) - first);
    }
    return reason.empty() ? "no reason given" : reason;
}

void fail(std::string_view call, std::string_view about) {
    throw RunError(fmt::format("{} of {} failed: {}", call, about, last_reason()));
}

void Handle::close(std::string_view call, std::string_view about) {
    check(close_(std::exchange(id_, -1)), call, about);
}

QuietErrors::QuietErrors() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietErrors::~QuietErrors() {
    H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

namespace {

/// H5Pset_file_locking() does not reach the sources of virtual datasets, and HDF5 gives NaN for one that is open
/// without locks already. A variable of the environment does, which HDF5 reads when it is used first; it is set for
/// that moment only, before there are threads, so that programs that this one starts do not inherit it.
bool open_without_locks() {
    constexpr const char* name = "HDF5_USE_FILE_LOCKING";
    const char* const given = std::getenv(name);
    const std::string before = given == nullptr ? "" : given;
    ::setenv(name, "FALSE", 1);
    // A damaged file can leave HDF5 with objects that it cannot close; it would complain of them when the program ends.
    // All files are closed by then.
    const bool is_told = H5dont_atexit() >= 0 && H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_FILE) >= 0;
    if (given == nullptr) ::unsetenv(name);
    if (given != nullptr) ::setenv(name, before.c_str(), 1);
    return is_told;
}

[[maybe_unused]] const bool told_hdf5 = open_without_locks();

}  // namespace

Handle access_without_locks() {
    return {H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "H5Pcreate", "file access"};
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

namespace {

constexpr std::string_view remedy =
    "Restore it from a copy, or make it anew: a campaign file from the journal beside it (floes run CONFIG.toml -o "
    "FILE.h5 --resume), a record by floes replay. floes verify says what of it is whole.";

std::string path_of(hid_t object) {
    const auto length = H5Fget_name(object, nullptr, 0);
    if (length <= 0) return "the file";
    std::string path(static_cast<std::size_t>(length) + 1, '\0');
    H5Fget_name(object, path.data(), path.size());
    path.resize(static_cast<std::size_t>(length));
    return path;
}

}  // namespace

DamagedFile::DamagedFile(std::string_view path, std::string_view fault)
    : RunError(fmt::format("{} is damaged: {}. {}", path, fault, remedy)), fault_(fault) {}

void refuse_damaged(hid_t object, std::string_view fault) {
    throw DamagedFile(path_of(object), fault);
}

void refuse_unreadable(hid_t object, const std::string& name) {
    const std::string reason = last_reason();  // before further calls change it
    refuse_damaged(object, fmt::format("{} cannot be read (HDF5: {})", name, reason));
}

void write_kind(hid_t file, const FileKind& kind, const std::string& title) {
    const std::vector<std::int32_t> version(kind.version.begin(), kind.version.end());
    write_attribute(file, "title", title);
    write_attribute(file, "Conventions", std::string("CF-1.8"));
    write_attribute(file, "filetype", std::string(kind.filetype));
    write_attribute(file, "version", version);
    write_attribute(file, "software", std::string("floes"));
    write_attribute(file, "softwareVersion", floes_version());
}

bool is_of_kind(hid_t file, const FileKind& kind) {
    return has_attribute(file, "filetype") && read_text_attribute(file, "filetype") == kind.filetype;
}

void check_kind(hid_t file, const FileKind& kind, const std::filesystem::path& path) {
    if (!is_of_kind(file, kind))
        throw InputError(fmt::format("{} is an HDF5 file, but no {}.", path.string(), kind.what));
    const std::vector<std::int32_t> version = read_int_attribute(file, "version");
    if (version.size() != kind.version.size() || version[0] != kind.version[0])
        throw InputError(
            fmt::format("{} has layout version {}, and this program reads version {}. Use the version of "
                        "floes that wrote it.",
                        path.string(), version.empty() ? 0 : version[0], kind.version[0]));
    if (version[1] < kind.oldest_minor)
        throw InputError(fmt::format(
            "{} has layout {}.{}, of floes 2.0.0 or before, which this program does not read any more; floes "
            "2.0.0 does.",
            path.string(), version[0], version[1]));
}

}  // namespace floes::hdf5
