// The verbs of floes in the order of --help. Manual pages and completions are made from the same list.

#include "cli/commands.hpp"

namespace floes {

void add_verbs(CommandLine& line, std::span<char* const> command) {
    add_new(line);
    add_show(line);
    add_run(line, command);
    add_array(line);
    add_merge(line);
    add_status(line);
    add_plan(line);
    add_vary(line);
    add_summarize(line);
    add_design(line);
    add_contour(line);
    add_config(line);
    add_laboratory(line);
    add_hybrid(line);
    add_hydro(line);
    add_report(line);
    add_explore(line);
    add_replay(line);
    add_export(line);
    add_match(line);
    add_serve(line);
    add_verify(line);
    line.help_verb();
    line.version(version_text, "Print version, revision, libraries and the lane widths of this processor");
    line.footer(
        "Exit status: 0 done, 1 a member was set aside as failed or the run failed, 2 wrong input, 85 stopped, to be\n"
        "resumed with --resume.\n\n"
        "  floes new my.toml\n"
        "  floes show my.toml\n"
        "  floes run my.toml -o my.h5\n"
        "  floes summarize my.h5");
}

}  // namespace floes
