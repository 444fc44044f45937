#pragma once
// HDF5 identifiers that close themselves, and calls whose failures become exceptions. Only for sources of modules with
// HDF5 files of their own. Not thread-safe.

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <hdf5.h>

#include "core/error.hpp"

namespace floes::hdf5 {

/// HDF5's description of the last call that failed.
std::string last_reason();

/// Throws RunError with the call, its object and HDF5's own reason.
[[noreturn]] void fail(std::string_view call, std::string_view about);

/// The result of an HDF5 call that returns a negative value on failure.
template <class Value>
Value check(Value value, std::string_view call, std::string_view about) {
    if (value < 0) fail(call, about);
    return value;
}

/// An identifier with the function that closes it.
class Handle {
  public:
    using Close = herr_t (*)(hid_t);

    Handle(hid_t id, Close close_id, std::string_view call, std::string_view about)
        : id_(check(id, call, about)), close_(close_id) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle& operator=(Handle&&) = delete;
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }

    hid_t id() const { return id_; }
    /// Closes now and throws on failure, which a destructor cannot: buffered data reach the file when it is closed.
    void close(std::string_view call, std::string_view about);

  private:
    hid_t id_;
    Close close_;
};

/// While it exists, HDF5 prints no error stacks, because failures are reported as exceptions.
class QuietErrors {
  public:
    QuietErrors();
    ~QuietErrors();
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;

  private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// File access without HDF5's own locks: campaign files never change in place, and some cluster file systems do not
/// support locks.
Handle access_without_locks();

/// The same for a new file, in the format of HDF5 1.10: its superblock, headers and indices of chunks have checksums.
Handle access_for_writing();

/// The types of a double, float, int32, int8 or uint64 in memory, and in a file.
template <class Value>
hid_t native_type() {
    if constexpr (std::same_as<Value, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::same_as<Value, float>) return H5T_NATIVE_FLOAT;
    if constexpr (std::same_as<Value, std::int32_t>) return H5T_NATIVE_INT32;
    if constexpr (std::same_as<Value, std::int8_t>) return H5T_NATIVE_INT8;
    if constexpr (std::same_as<Value, std::uint64_t>) return H5T_NATIVE_UINT64;
}
template <class Value>
hid_t stored_type() {
    if constexpr (std::same_as<Value, double>) return H5T_IEEE_F64LE;
    if constexpr (std::same_as<Value, float>) return H5T_IEEE_F32LE;
    if constexpr (std::same_as<Value, std::int32_t>) return H5T_STD_I32LE;
    if constexpr (std::same_as<Value, std::int8_t>) return H5T_STD_I8LE;
    if constexpr (std::same_as<Value, std::uint64_t>) return H5T_STD_U64LE;
}

/// Text of any length in UTF-8.
Handle text_type();

// Errors about a file that differs from what was written. Only for sources of modules with HDF5 files of their own.

/// "PATH is damaged: FAULT.", and what to do.
class DamagedFile : public RunError {
  public:
    DamagedFile(std::string_view path, std::string_view fault);
    const std::string& fault() const { return fault_; }

  private:
    std::string fault_;
};

/// Throws DamagedFile. `object`: the file or anything in it.
[[noreturn]] void refuse_damaged(hid_t object, std::string_view fault);

/// The same for an object called `name` that HDF5 cannot read, with HDF5's own reason.
[[noreturn]] void refuse_unreadable(hid_t object, const std::string& name);

/// The value of a call that reads `name`, which is in the file of `object`.
template <class Value>
Value check_read(Value value, hid_t object, const std::string& name) {
    if (value < 0) refuse_unreadable(object, name);
    return value;
}

// The kind of an HDF5 file and its layout version.

struct FileKind {
    std::string_view filetype;   ///< attribute of the root
    std::array<int, 2> version;  ///< of the layout, {major, minor}: a new minor only adds names
    int oldest_minor;            ///< that can be read
    std::string_view what;       ///< as a message names it: "campaign of floes"
};

// The attributes of the root of every HDF5 file of floes, which identify its kind. Only for sources of modules
// with HDF5 files of their own.

/// Writes title, filetype, version and software.
void write_kind(hid_t file, const FileKind& kind, const std::string& title);

bool is_of_kind(hid_t file, const FileKind& kind);

/// Throws InputError if the file is of another kind or another major version.
void check_kind(hid_t file, const FileKind& kind, const std::filesystem::path& path);

}  // namespace floes::hdf5
