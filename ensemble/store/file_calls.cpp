#include "store/file_calls.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {
namespace {

[[noreturn]] void refuse(const char* call, const std::filesystem::path& path, int error) {
    throw RunError(fmt::format("{} of {} failed: {}. Is the disk full, or the file system unavailable?", call,
                               path.string(), std::strerror(error)));
}

}  // namespace

Descriptor open_file(const std::filesystem::path& path, int flags) {
    const int value = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
    if (value < 0)
        throw InputError(fmt::format("{} cannot be opened: {}. The folder must exist and permit it.", path.string(),
                                     std::strerror(errno)));
    return Descriptor(value);
}

std::uint64_t file_size(const Descriptor& file, const std::filesystem::path& path) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) refuse("fstat", path, errno);
    return static_cast<std::uint64_t>(status.st_size);
}

double modified_at(const Descriptor& file, const std::filesystem::path& path) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) refuse("fstat", path, errno);
    return static_cast<double>(status.st_mtim.tv_sec) + 1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

bool read_at(const Descriptor& file, const std::filesystem::path& path, std::uint64_t offset,
             std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::pread(file.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (got == 0) return false;
        if (got < 0) {
            if (errno == EINTR) continue;
            refuse("read", path, errno);
        }
        offset += static_cast<std::uint64_t>(got);
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

void write_all(const Descriptor& file, const std::filesystem::path& path, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
        if (written < 0) {
            if (errno == EINTR) continue;
            refuse("write", path, errno);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void truncate_file(const Descriptor& file, const std::filesystem::path& path, std::uint64_t size) {
    if (::ftruncate(file.get(), static_cast<off_t>(size)) != 0) refuse("ftruncate", path, errno);
}

void sync_data(const Descriptor& file, const std::filesystem::path& path) {
    if (::fdatasync(file.get()) != 0) refuse("fdatasync", path, errno);
}

bool is_named(const Descriptor& file, const std::filesystem::path& path) {
    struct stat here {};
    struct stat there {};
    if (::fstat(file.get(), &here) != 0) refuse("fstat", path, errno);
    if (::stat(path.c_str(), &there) != 0) return false;
    return here.st_dev == there.st_dev && here.st_ino == there.st_ino;
}

void sync_folder_of(const std::filesystem::path& path) {
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    const Descriptor opened = open_file(folder, O_RDONLY | O_DIRECTORY);
    // Some network file systems do not support fsync of a folder (EINVAL); they keep names consistent themselves.
    if (::fsync(opened.get()) != 0 && errno != EINVAL) refuse("fsync", folder, errno);
}

std::filesystem::path target_of(std::filesystem::path path) {
    constexpr int most = 40;  // as Linux has it; a ring of links is left to whoever opens it
    std::error_code none;
    for (int k = 0; k < most && std::filesystem::is_symlink(path, none); ++k) {
        const std::filesystem::path to = std::filesystem::read_symlink(path, none);
        if (none) break;
        path = to.is_absolute() ? to : path.parent_path() / to;
    }
    return path;
}

void rename_into_place(const std::filesystem::path& aside, const std::filesystem::path& path) {
    const std::filesystem::path target = target_of(path);
    std::error_code error;
    std::filesystem::rename(aside, target, error);
    if (error == std::errc::cross_device_link) {
        const std::filesystem::path arriving = target.string() + ".arriving";
        std::filesystem::copy_file(aside, arriving, std::filesystem::copy_options::overwrite_existing, error);
        if (!error) {
            sync_data(open_file(arriving, O_RDWR), arriving);
            std::filesystem::rename(arriving, target, error);
        }
        std::error_code ignored;
        std::filesystem::remove(error ? arriving : aside, ignored);
    }
    if (error)
        throw RunError(fmt::format("renaming {} to {} failed: {}", aside.string(), target.string(), error.message()));
    sync_folder_of(target);
}

}  // namespace floes
