#pragma once
// System calls for durable files.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "core/descriptor.hpp"

namespace floes {

// If the file system refuses, each throws with the path, the call and the system's reason: InputError if the path
// cannot be opened, RunError otherwise.

/// open(2) with close-on-exec.
Descriptor open_file(const std::filesystem::path& path, int flags);
std::uint64_t file_size(const Descriptor& file, const std::filesystem::path& path);
/// When it was written last, s since 1970 by the clock of the file system.
double modified_at(const Descriptor& file, const std::filesystem::path& path);
/// Fills `bytes` from `offset` on; false if the file is too short.
bool read_at(const Descriptor& file, const std::filesystem::path& path, std::uint64_t offset,
             std::span<std::byte> bytes);
/// One write(2) for all bytes, and further ones only after a partial write.
void write_all(const Descriptor& file, const std::filesystem::path& path, std::span<const std::byte> bytes);
void truncate_file(const Descriptor& file, const std::filesystem::path& path, std::uint64_t size);
/// fdatasync(2): on return contents and size are on the disk.
void sync_data(const Descriptor& file, const std::filesystem::path& path);
/// True while `path` still refers to this file.
bool is_named(const Descriptor& file, const std::filesystem::path& path);
/// fsync(2) of the folder that holds `path`: on return the name is on the disk.
void sync_folder_of(const std::filesystem::path& path);

/// The file that a path means: what its links point to, also where that is not there yet.
std::filesystem::path target_of(std::filesystem::path path);

/// Gives the file at `aside` the name `path`, in place of what had it, and syncs the folder. Both in one folder; where
/// `path` is a link it stays one, and what it points to is replaced, on another file system too.
void rename_into_place(const std::filesystem::path& aside, const std::filesystem::path& path);

}  // namespace floes
