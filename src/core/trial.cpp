#include "core/trial.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>

namespace floes {

constexpr rlim_t longest = 10;          // s of processor time, because the disk may be slow
constexpr unsigned longest_wait = 600;  // s

bool started_by_mpi() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"}) {
        if (std::getenv(name) != nullptr) return true;
    }
    return false;
}

int signal_of_trial(const std::function<void()>& work) {
    if (started_by_mpi()) return 0;  // what MPI has mapped does not outlive a fork
    const pid_t child = ::fork();
    if (child < 0) return 0;
    if (child == 0) {
        const rlimit processor{longest, longest};
        const rlimit no_core{0, 0};
        ::setrlimit(RLIMIT_CPU, &processor);
        ::setrlimit(RLIMIT_CORE, &no_core);
        ::alarm(longest_wait);
        ::close(STDERR_FILENO);  // what a crash would print
        for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU})
            std::signal(signal, SIG_DFL);
        try {
            work();
        } catch (const std::exception&) {
            ::_exit(0);
        }
        ::_exit(0);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (WIFSIGNALED(status)) return WTERMSIG(status);
    return WEXITSTATUS(status) == 0 ? 0 : SIGABRT;  // a sanitizer ended it
}

}  // namespace floes
