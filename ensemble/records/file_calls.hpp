#pragma once
// The system calls of a store that must not lose anything.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "core/descriptor.hpp"

namespace floes {

// Each throws, with the path, the call and the system's reason, when the file system refuses: InputError where the path
// cannot be opened, RunError otherwise.

/// open(2); a descriptor that children started by exec do not inherit.
Descriptor open_file(const std::filesystem::path& path, int flags);
std::uint64_t file_size(const Descriptor& file, const std::filesystem::path& path);
/// Fills `bytes` from `offset` on; false when the file ends before.
bool read_at(const Descriptor& file, const std::filesystem::path& path, std::uint64_t offset,
             std::span<std::byte> bytes);
/// One write(2) for all the bytes, and further ones only for what the system left over.
void write_all(const Descriptor& file, const std::filesystem::path& path, std::span<const std::byte> bytes);
void truncate_file(const Descriptor& file, const std::filesystem::path& path, std::uint64_t size);
/// fdatasync(2): contents and size are on the disk on return.
void sync_data(const Descriptor& file, const std::filesystem::path& path);
/// True while `path` leads to this file.
bool is_named(const Descriptor& file, const std::filesystem::path& path);
/// fsync(2) of the folder that holds `path`: the name is on the disk on return.
void sync_folder_of(const std::filesystem::path& path);

}  // namespace floes
