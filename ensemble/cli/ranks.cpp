#include "cli/ranks.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "run/link.hpp"

namespace floes {

namespace {

constexpr int not_started = 127;  // as shells have it

std::string mpirun() {
    const char* given = std::getenv("FLOES_MPIRUN");
    return given != nullptr && *given != '\0' ? given : "mpirun";
}

std::vector<std::string> rank_command(int ranks, std::span<char* const> command) {
    std::vector<std::string> words{mpirun(), "-n", std::to_string(ranks)};
    // Each rank distributes its threads over the cores that it shares with the other ranks, so it must not be bound.
    if (library_version().starts_with("Open MPI")) words.insert(words.end(), {"--oversubscribe", "--bind-to", "none"});
    words.insert(words.end(), command.begin(), command.end());
    return words;
}

void prepare_environment(const char* program) {
    constexpr int keep = 0;
    setenv("FLOES_LAUNCHER", program, keep);      // so that the printed command has --ranks
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", keep);  // in containers the only user is root
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", keep);
    // In containers a process must not read the memory of another; Open MPI would warn of that and continue.
    setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", keep);
}

/// In the child. Returns only if mpirun could not be started.
void become(std::vector<std::string> words, const sigset_t& signals) {
    setpgid(0, 0);  // so that Ctrl-C reaches its parent alone
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    sigprocmask(SIG_UNBLOCK, &signals, nullptr);
    if (const int nothing = open("/dev/null", O_RDONLY); nothing >= 0) dup2(nothing, STDIN_FILENO);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
}

/// Passes signals on until the child has ended; its status.
int wait_for(pid_t child, const sigset_t& signals) {
    bool asked = false;
    while (true) {
        int signal = 0;
        sigwait(&signals, &signal);
        if (signal == SIGCHLD) {
            int status = 0;
            if (waitpid(child, &status, WNOHANG) != child) continue;
            return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
        // On SIGINT and SIGTERM mpirun kills the ranks after a second and loses their exit status. It forwards SIGUSR1,
        // which the ranks take as a request to stop.
        kill(child, signal == SIGUSR1 || !asked ? SIGUSR1 : SIGTERM);
        asked = asked || signal != SIGUSR1;
    }
}

}  // namespace

int run_ranks(int ranks, std::span<char* const> command) {
    prepare_environment(command[0]);
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGCHLD}) sigaddset(&signals, signal);
    struct sigaction hangup {};
    sigaction(SIGHUP, nullptr, &hangup);
    if (hangup.sa_handler != SIG_IGN) sigaddset(&signals, SIGHUP);  // which nohup sets
    sigprocmask(SIG_BLOCK, &signals, nullptr);
    const pid_t child = fork();
    if (child == 0) {
        become(rank_command(ranks, command), signals);
        _exit(not_started);
    }
    if (child < 0) throw RunError("no process could be started for mpirun.");
    const int status = wait_for(child, signals);
    if (status == not_started)
        throw RunError(
            fmt::format("{} could not be started; is MPI's program of that name installed and in the PATH? "
                        "FLOES_MPIRUN can name it.",
                        mpirun()));
    return status;
}

}  // namespace floes
