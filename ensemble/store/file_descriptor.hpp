#pragma once
// A file descriptor that closes itself, and the system calls of a store that must not lose anything.

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

namespace floes {

class FileDescriptor {
  public:
    explicit FileDescriptor(int value) : value_(value) {}
    FileDescriptor(FileDescriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    ~FileDescriptor() {
        if (value_ >= 0) ::close(value_);
    }

    int get() const { return value_; }

  private:
    int value_;
};

// Each throws, with the path, the call and the system's reason, when the file system refuses: InputError where the path
// cannot be opened, RunError otherwise.

/// open(2); a descriptor that children started by exec do not inherit.
FileDescriptor open_file(const std::filesystem::path& path, int flags);
std::uint64_t file_size(const FileDescriptor& file, const std::filesystem::path& path);
/// Fills `bytes` from `offset` on; false when the file ends before.
bool read_at(const FileDescriptor& file, const std::filesystem::path& path, std::uint64_t offset,
             std::span<std::byte> bytes);
/// One write(2) for all the bytes, and further ones only for what the system left over.
void write_all(const FileDescriptor& file, const std::filesystem::path& path, std::span<const std::byte> bytes);
void truncate_file(const FileDescriptor& file, const std::filesystem::path& path, std::uint64_t size);
/// fdatasync(2): contents and size are on the disk on return.
void sync_data(const FileDescriptor& file, const std::filesystem::path& path);
/// True while `path` leads to this file.
bool is_named(const FileDescriptor& file, const std::filesystem::path& path);
/// fsync(2) of the folder that holds `path`: the name is on the disk on return.
void sync_folder_of(const std::filesystem::path& path);

}  // namespace floes
