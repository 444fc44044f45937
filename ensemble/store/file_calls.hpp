#pragma once
// Durable files: what programs do with the calls of a system.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "store/system.hpp"

namespace floes {

// If the file system refuses, each throws with the path, the call and the system's reason: InputError if the path
// cannot be opened, RunError otherwise.

/// open(2) with close-on-exec.
OpenFile open_file(const std::filesystem::path& path, int flags, const System& system = this_system());
std::uint64_t file_size(const OpenFile& file);
/// When it was written last, s since 1970 by the clock of the file system.
double modified_at(const OpenFile& file);
/// Fills `bytes` from `offset` on; false if the file is too short.
bool read_at(const OpenFile& file, std::uint64_t offset, std::span<std::byte> bytes);
/// One write(2) for all bytes, and further ones only after a partial write.
void write_all(const OpenFile& file, std::span<const std::byte> bytes);
void truncate_file(const OpenFile& file, std::uint64_t size);
/// fdatasync(2): on return contents and size are on the disk. If it fails, nobody reads what is not.
void sync_data(const OpenFile& file);
/// Device and number: equal for two open files of one file.
using FilePlace = std::pair<std::uint64_t, std::uint64_t>;
FilePlace place_of(const OpenFile& file);
/// True while `path` still refers to this file.
bool is_named(const OpenFile& file, const std::filesystem::path& path);
/// fsync(2) of the folder that holds `path`: on return the name is on the disk.
void sync_folder_of(const std::filesystem::path& path, const System& system = this_system());

/// Whether there is something at the path.
bool is_there(const std::filesystem::path& path, const System& system = this_system());
/// What is thrown where a file could not be written by other means.
RunError not_written(const std::filesystem::path& path, const std::string& why);

/// Takes the file away that it names, unless it was renamed or never made.
class AsideFile {
  public:
    explicit AsideFile(std::filesystem::path path) : path_(std::move(path)) {}
    AsideFile(const AsideFile&) = delete;
    AsideFile& operator=(const AsideFile&) = delete;
    ~AsideFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Where there is nothing, nothing happens.
void remove_file(const std::filesystem::path& path, const System& system = this_system());
/// The folder that holds `path`.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// The file that a path means: what its links point to, also where that is not there yet.
std::filesystem::path target_of(std::filesystem::path path);

/// Gives the file at `aside` the name `path`, in place of what had it, and syncs the folder. Both in one folder; where
/// `path` is a link it stays one, and what it points to is replaced, on another file system too.
void rename_into_place(const std::filesystem::path& aside, const std::filesystem::path& path,
                       const System& system = this_system());

/// Has `write` make a file at `aside`, brings it to the disk, and renames it into place: at every moment, and after a
/// power cut, `path` is the old file or the new one, whole. Throws what `write` does; `aside` is removed then.
void replace_file(const std::filesystem::path& path, const std::filesystem::path& aside,
                  const std::function<void(const std::filesystem::path& aside)>& write,
                  const System& system = this_system());

}  // namespace floes
