#pragma once
// The one door of the driver to files, clocks and waiting: each function is one call of the operating system, so that
// tests can put a simulated one behind it, whose disk loses what was not synced (tests/support/simulated_system.hpp).
// HDF5 writes through its own calls, and what it wrote is synced and renamed here.

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace floes {

/// What a file is. Two files are the same if device and number are.
struct FileFacts {
    std::uint64_t size = 0;  ///< bytes
    double modified = 0;     ///< s since 1970, by the clock of the file system
    std::uint64_t device = 0;
    std::uint64_t number = 0;
};

/// An int that is negative is an error, as -ENOSPC.
class System {
  public:
    using Time = std::chrono::steady_clock::time_point;

    System() = default;
    System(const System&) = delete;
    System& operator=(const System&) = delete;
    virtual ~System() = default;

    /// open(2), with close-on-exec: a descriptor.
    virtual int open(const std::filesystem::path& path, int flags) const = 0;
    virtual void close(int file) const = 0;
    /// pread(2) and write(2): how many bytes, perhaps fewer than asked for.
    virtual std::int64_t read(int file, std::uint64_t offset, std::span<std::byte> bytes) const = 0;
    virtual std::int64_t write(int file, std::span<const std::byte> bytes) const = 0;
    virtual int truncate(int file, std::uint64_t size) const = 0;
    /// fdatasync(2).
    virtual int sync(int file) const = 0;
    /// Has what is read from now on come from the disk, as far as nothing waits to be written to it:
    /// posix_fadvise(2). After a sync that failed, the system may read out what is on no disk and will never be.
    virtual void forget_cached(int file) const = 0;
    /// fsync(2) of a folder: of the names in it.
    virtual int sync_folder(const std::filesystem::path& folder) const = 0;
    virtual int facts(int file, FileFacts& facts) const = 0;
    virtual int facts(const std::filesystem::path& path, FileFacts& facts) const = 0;
    virtual int rename(const std::filesystem::path& from, const std::filesystem::path& to) const = 0;
    virtual int remove(const std::filesystem::path& path) const = 0;
    /// Of files and folders in it, in any order; none if it cannot be read.
    virtual std::vector<std::string> names_in(const std::filesystem::path& folder) const = 0;
    /// Whether this process may make files in the folder.
    virtual int may_write_in(const std::filesystem::path& folder) const = 0;

    /// Locks the whole file against other writers until it is closed: a lock of the open file, not of the process, so
    /// that it works between two journals of one process too. -EAGAIN if another open file has it.
    virtual int lock(int file) const = 0;
    /// Whether another open file has the lock.
    virtual bool is_locked(int file) const = 0;

    /// By a clock that nobody sets.
    virtual Time now() const = 0;
    /// By the clock of the host.
    virtual double seconds_since_1970() const = 0;
    virtual void sleep(std::chrono::microseconds time) const = 0;
    /// Sleeps until `is_over`, at most for `longest`. `changed` is notified when that may be so; `lock` guards it.
    virtual void wait(std::condition_variable& changed, std::unique_lock<std::mutex>& lock,
                      std::chrono::microseconds longest, const std::function<bool()>& is_over) const = 0;
};

/// The one that this process runs on.
const System& this_system();

/// An open file, which closes itself, and the path that it was opened by. Its system must outlive it.
class OpenFile {
  public:
    OpenFile() = default;
    OpenFile(const System& system, int descriptor, std::filesystem::path path)
        : system_(&system), descriptor_(descriptor), path_(std::move(path)) {}
    OpenFile(OpenFile&& other) noexcept
        : system_(other.system_), descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}
    OpenFile& operator=(OpenFile&& other) noexcept {
        std::swap(system_, other.system_);
        std::swap(descriptor_, other.descriptor_);
        std::swap(path_, other.path_);
        return *this;
    }
    ~OpenFile() {
        if (descriptor_ >= 0) system_->close(descriptor_);
    }

    const System& system() const { return *system_; }
    int get() const { return descriptor_; }
    const std::filesystem::path& path() const { return path_; }

  private:
    const System* system_ = &this_system();
    int descriptor_ = -1;
    std::filesystem::path path_;
};

}  // namespace floes
