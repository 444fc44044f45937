#include "hdf5/trial.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <exception>

#include "hdf5/contents.hpp"
#include "hdf5/damage.hpp"
#include "hdf5/stored.hpp"

namespace floes::hdf5 {
namespace {

constexpr rlim_t longest = 10;          // s of processor time, because the disk may be slow
constexpr unsigned longest_wait = 600;  // s

void read_structure(const std::filesystem::path& path) {
    const Handle access = access_without_locks();
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, "H5Fopen", path.string());
    for (const std::string& name : paths_of(file.id()).datasets) {
        try {
            const Handle dataset = open_dataset(file.id(), name);
            if (shape_of(dataset, name, Portion::row).is_text) texts_of(dataset, name);
        } catch (const DamagedFile&) {
            continue;  // HDF5 reported an error instead of crashing
        }
    }
    contents_digests(file.id());
}

}  // namespace

void try_out(const std::filesystem::path& path) {
    const pid_t child = ::fork();
    if (child < 0) return;  // then the trial is left out
    if (child == 0) {
        const rlimit processor{longest, longest};
        const rlimit no_core{0, 0};
        ::setrlimit(RLIMIT_CPU, &processor);
        ::setrlimit(RLIMIT_CORE, &no_core);
        ::alarm(longest_wait);
        ::close(STDERR_FILENO);  // what a crash would print
        try {
            read_structure(path);
        } catch (const std::exception&) {
            ::_exit(0);
        }
        ::_exit(0);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (WIFSIGNALED(status))
        throw DamagedFile(path.string(), fmt::format("HDF5 cannot read it (it ends with signal {})", WTERMSIG(status)));
}

}  // namespace floes::hdf5
