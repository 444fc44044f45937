#include "store/system.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <thread>

namespace floes {

namespace {

namespace fs = std::filesystem;

int error_or(int result) {
    return result < 0 ? -errno : result;
}

struct flock whole_file() {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    return lock;
}

FileFacts facts_of(const struct stat& status) {
    return {static_cast<std::uint64_t>(status.st_size),
            static_cast<double>(status.st_mtim.tv_sec) + 1e-9 * static_cast<double>(status.st_mtim.tv_nsec),
            status.st_dev, status.st_ino};
}

class ThisSystem final : public System {
  public:
    int open(const fs::path& path, int flags) const override {
        return error_or(::open(path.c_str(), flags | O_CLOEXEC, 0666));
    }
    void close(int file) const override { ::close(file); }

    std::int64_t read(int file, std::uint64_t offset, std::span<std::byte> bytes) const override {
        const ssize_t got = ::pread(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        return got < 0 ? -errno : got;
    }
    std::int64_t write(int file, std::span<const std::byte> bytes) const override {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        return written < 0 ? -errno : written;
    }
    int truncate(int file, std::uint64_t size) const override {
        return error_or(::ftruncate(file, static_cast<off_t>(size)));
    }
    int sync(int file) const override { return error_or(::fdatasync(file)); }
    void forget_cached(int file) const override { ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED); }
    int sync_folder(const fs::path& folder) const override {
        const OpenFile opened(*this, open(folder, O_RDONLY | O_DIRECTORY), folder);
        return opened.get() < 0 ? opened.get() : error_or(::fsync(opened.get()));
    }

    int facts(int file, FileFacts& facts) const override {
        struct stat status {};
        if (::fstat(file, &status) != 0) return -errno;
        facts = facts_of(status);
        return 0;
    }
    int facts(const fs::path& path, FileFacts& facts) const override {
        struct stat status {};
        if (::stat(path.c_str(), &status) != 0) return -errno;
        facts = facts_of(status);
        return 0;
    }

    int rename(const fs::path& from, const fs::path& to) const override {
        return error_or(std::rename(from.c_str(), to.c_str()));
    }
    int remove(const fs::path& path) const override { return error_or(std::remove(path.c_str())); }
    std::vector<std::string> names_in(const fs::path& folder) const override {
        std::vector<std::string> names;
        std::error_code none;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
            names.push_back(entry.path().filename().string());
        return names;
    }
    int may_write_in(const fs::path& folder) const override { return error_or(::access(folder.c_str(), W_OK)); }

    int lock(int file) const override {
        auto lock = whole_file();
        const int result = error_or(::fcntl(file, F_OFD_SETLK, &lock));
        return result == -EACCES ? -EAGAIN : result;
    }
    bool is_locked(int file) const override {
        auto lock = whole_file();
        return ::fcntl(file, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
    }

    Time now() const override { return std::chrono::steady_clock::now(); }
    double seconds_since_1970() const override {
        return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    }
    void sleep(std::chrono::microseconds time) const override { std::this_thread::sleep_for(time); }
    void wait(std::condition_variable& changed, std::unique_lock<std::mutex>& lock, std::chrono::microseconds longest,
              const std::function<bool()>& is_over) const override {
        changed.wait_for(lock, longest, is_over);
    }
};

}  // namespace

const System& this_system() {
    static const ThisSystem system;
    return system;
}

}  // namespace floes
