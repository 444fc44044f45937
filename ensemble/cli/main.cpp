// floes: the program. Each verb has its own file and verbs.cpp lists them; this one only dispatches.

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "cli/commands.hpp"
#include "core/error.hpp"
#include "wire/open_link.hpp"

namespace {

/// Under mpirun every rank reads the same command line, so only one reports an error in it.
bool speaks() {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
        if (const char* rank = std::getenv(name)) return std::string_view(rank) == "0";
    return true;
}

int refuse(const CLI::App& program, const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream errors;
    const bool no_error = program.exit(error, out, errors) == 0;
    if (speaks()) {
        std::fputs(out.str().c_str(), stdout);
        std::fputs(errors.str().c_str(), stderr);
    }
    if (no_error) return 0;
    // mpirun ends all ranks when one ends with an error. Starting MPI first keeps all alive until rank 0 has reported.
    if (floes::started_by_mpi()) floes::open_link();
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is reported as an error, like a full disk
    CLI::App program;
    int exit_status = 0;
    floes::add_verbs(program, exit_status, {argv, static_cast<std::size_t>(argc)});
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return refuse(program, error);
    } catch (const floes::InputError& error) {
        std::fprintf(stderr, "floes: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "floes: %s\n", error.what());
        return 1;
    }
    return exit_status;
}
