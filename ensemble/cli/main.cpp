// floes: the program. Each verb has its own file and verbs.cpp lists them; this one only dispatches.

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <string_view>

#include "cli/commands.hpp"
#include "core/error.hpp"
#include "core/trial.hpp"
#include "run/link.hpp"

namespace {

/// Under mpirun every rank reads the same command line, so only one reports an error in it.
bool speaks() {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
        if (const char* rank = std::getenv(name)) return std::string_view(rank) == "0";
    return true;
}

int end(const floes::CommandLineEnd& said) {
    if (speaks()) {
        std::fputs(said.output().c_str(), stdout);
        std::fputs(said.what(), stderr);
    }
    // mpirun ends all ranks when one ends with an error. Starting MPI first keeps all alive until rank 0 has reported.
    if (said.status() != 0 && floes::started_by_mpi()) floes::open_link();
    return said.status();
}

/// `status`, or 1 with a sentence where the output is not whole: a full disk, a quota. A reader that went away, as head
/// does, has read what it wanted.
int with_output_written(int status) {
    errno = 0;
    const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    struct stat output {};
    if (whole || (::fstat(STDOUT_FILENO, &output) == 0 && (S_ISFIFO(output.st_mode) || S_ISSOCK(output.st_mode))))
        return status;
    std::fprintf(stderr, "floes: standard output could not be written whole (%s); has its disk free space?\n",
                 errno != 0 ? std::strerror(errno) : "an error before its end");
    return status == 0 ? 1 : status;
}

/// Where standard input, output or error is closed, the next file that is opened would be it.
void fill_standard_streams() {
    for (int stream = 0; stream < 3; ++stream)
        if (::fcntl(stream, F_GETFD) < 0) static_cast<void>(::open("/dev/null", stream == 0 ? O_RDONLY : O_WRONLY));
}

}  // namespace

int main(int argc, char** argv) {
    fill_standard_streams();
    std::signal(SIGCHLD, SIG_DFL);  // where it is ignored, as a parent may leave it, nobody learns how a child ended
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is reported as an error, like a full disk
    const std::span<char* const> words(argv, static_cast<std::size_t>(argc));
    floes::CommandLine line(floes::program_description);
    floes::add_verbs(line, words);
    try {
        return with_output_written(line.run(words));
    } catch (const floes::CommandLineEnd& said) {
        return with_output_written(end(said));
    } catch (const floes::InputError& error) {
        std::fprintf(stderr, "floes: %s\n", error.what());
        return 2;
    } catch (const std::bad_alloc&) {
        std::fputs("floes: there is not enough memory for this; close other programs, or take a smaller input\n",
                   stderr);
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "floes: %s\n", error.what());
        return 1;
    }
}
