#include "store/file_calls.hpp"

#include <fcntl.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

namespace floes {
namespace {

[[noreturn]] void refuse(const char* call, const std::filesystem::path& path, int error) {
    throw RunError(fmt::format("{} of {} failed: {}. Is the disk full, or the file system unavailable?", call,
                               path.string(), std::strerror(error)));
}

/// `result`: of a System.
void expect(const char* call, const std::filesystem::path& path, std::int64_t result) {
    if (result < 0) refuse(call, path, static_cast<int>(-result));
}

FileFacts facts_of(const OpenFile& file) {
    FileFacts facts;
    expect("fstat", file.path(), file.system().facts(file.get(), facts));
    return facts;
}

/// Where a file cannot be renamed to: what arrives there is copied beside it first.
std::error_code copy_into_place(const std::filesystem::path& aside, const std::filesystem::path& target) {
    const std::filesystem::path arriving = target.string() + ".arriving";
    std::error_code error;
    std::filesystem::copy_file(aside, arriving, std::filesystem::copy_options::overwrite_existing, error);
    if (!error) {
        sync_data(open_file(arriving, O_RDWR));
        std::filesystem::rename(arriving, target, error);
    }
    std::error_code ignored;
    std::filesystem::remove(error ? arriving : aside, ignored);
    return error;
}

}  // namespace

OpenFile open_file(const std::filesystem::path& path, int flags, const System& system) {
    const int opened = system.open(path, flags);
    if (opened < 0)
        throw InputError(fmt::format("{} cannot be opened: {}. The folder must exist and permit it.", path.string(),
                                     std::strerror(-opened)));
    return {system, opened, path};
}

std::uint64_t file_size(const OpenFile& file) {
    return facts_of(file).size;
}

double modified_at(const OpenFile& file) {
    return facts_of(file).modified;
}

bool read_at(const OpenFile& file, std::uint64_t offset, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const std::int64_t got = file.system().read(file.get(), offset, bytes);
        if (got == 0) return false;
        if (got == -EINTR) continue;
        expect("read", file.path(), got);
        offset += static_cast<std::uint64_t>(got);
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

void write_all(const OpenFile& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const std::int64_t written = file.system().write(file.get(), bytes);
        if (written == -EINTR) continue;
        expect("write", file.path(), written);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void truncate_file(const OpenFile& file, std::uint64_t size) {
    expect("ftruncate", file.path(), file.system().truncate(file.get(), size));
}

void sync_data(const OpenFile& file) {
    const int result = file.system().sync(file.get());
    if (result < 0) file.system().forget_cached(file.get());
    expect("fdatasync", file.path(), result);
}

FilePlace place_of(const OpenFile& file) {
    const FileFacts facts = facts_of(file);
    return {facts.device, facts.number};
}

bool is_named(const OpenFile& file, const std::filesystem::path& path) {
    const FileFacts here = facts_of(file);
    FileFacts there;
    if (file.system().facts(path, there) < 0) return false;
    return here.device == there.device && here.number == there.number;
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

RunError not_written(const std::filesystem::path& path, const std::string& why) {
    return RunError(
        fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?", path.string(), why));
}

bool is_there(const std::filesystem::path& path, const System& system) {
    FileFacts facts;
    const int result = system.facts(path, facts);
    if (result != -ENOENT && result != -ENOTDIR) expect("stat", path, result);
    return result == 0;
}

void remove_file(const std::filesystem::path& path, const System& system) {
    const int result = system.remove(path);
    if (result != -ENOENT) expect("unlink", path, result);
}

void sync_folder_of(const std::filesystem::path& path, const System& system) {
    const std::filesystem::path folder = folder_of(path);
    const int result = system.sync_folder(folder);
    // Some network file systems do not support fsync of a folder (EINVAL); they keep names consistent themselves.
    if (result != -EINVAL) expect("fsync", folder, result);
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

void rename_into_place(const std::filesystem::path& aside, const std::filesystem::path& path, const System& system) {
    const std::filesystem::path target = target_of(path);
    std::error_code error(-system.rename(aside, target), std::generic_category());
    if (error == std::errc::cross_device_link) error = copy_into_place(aside, target);
    if (error)
        throw RunError(fmt::format("renaming {} to {} failed: {}", aside.string(), target.string(), error.message()));
    sync_folder_of(target, system);
}

void replace_file(const std::filesystem::path& path, const std::filesystem::path& aside,
                  const std::function<void(const std::filesystem::path& aside)>& write, const System& system) {
    try {
        write(aside);
        sync_data(open_file(aside, O_RDWR, system));
        rename_into_place(aside, path, system);
    } catch (...) {
        system.remove(aside);  // on a full disk others need the room
        throw;
    }
}

}  // namespace floes
