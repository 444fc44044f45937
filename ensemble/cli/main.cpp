// floes: the one program. Verbs live in their own files; this one only picks.

#include <cstdio>

#include "cli/commands.hpp"
#include "core/error.hpp"

int main(int argc, char** argv) {
    CLI::App program{"floes: the load that managed ice floes put on a structure, over many random arrangements"};
    program.require_subcommand(1);
    int exit_status = 0;
    floes::add_run(program, exit_status);
    floes::add_merge(program, exit_status);
    floes::add_status(program, exit_status);
    floes::add_plan(program, exit_status);
    floes::add_summarize(program, exit_status);
    floes::add_config(program, exit_status);
    floes::add_calibrate(program, exit_status);
    floes::add_cantilever(program, exit_status);
    floes::add_hybrid(program, exit_status);
    floes::add_report(program, exit_status);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    } catch (const floes::InputError& error) {
        std::fprintf(stderr, "floes: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "floes: %s\n", error.what());
        return 1;
    }
    return exit_status;
}
