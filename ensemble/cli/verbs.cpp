// What `floes` can do: its verbs in the order of --help, from which manual pages and completions are made as well.

#include "cli/commands.hpp"

namespace floes {

void add_verbs(CLI::App& program, int& exit_status, std::span<char* const> command) {
    program.description("floes: the load of managed ice floes on a structure, over many random arrangements");
    program.require_subcommand(1);
    add_version(program);
    add_run(program, exit_status, command);
    add_merge(program, exit_status);
    add_status(program, exit_status);
    add_plan(program, exit_status);
    add_summarize(program, exit_status);
    add_design(program, exit_status);
    add_config(program, exit_status);
    add_calibrate(program, exit_status);
    add_cantilever(program, exit_status);
    add_hybrid(program, exit_status);
    add_report(program, exit_status);
    add_replay(program, exit_status);
    add_match(program, exit_status);
    add_verify(program, exit_status);
    program.footer(
        "Exit status: 0 done, 1 a member was set aside as failed or the run failed, 2 wrong input, 85 stopped, to be\n"
        "resumed with --resume.\n\n"
        "  floes config --defaults > my.toml\n"
        "  floes run my.toml -o my.h5\n"
        "  floes summarize my.h5");
}

}  // namespace floes
