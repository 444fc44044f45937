// The verbs of floes in the order of --help. Manual pages and completions are made from the same list.

#include "cli/commands.hpp"

namespace floes {

void add_verbs(CommandLine& line, std::span<char* const> command) {
    for (const auto add : {add_new, add_show}) add(line);
    add_run(line, command);
    for (const auto add : {add_array, add_merge, add_status, add_plan, add_vary, add_summarize, add_design, add_contour,
                           add_config, add_laboratory, add_hybrid, add_hydro, add_report, add_explore, add_replay,
                           add_export, add_match, add_serve, add_verify})
        add(line);
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
