#pragma once
// The verbs of the command. Each adds itself to the command line and, when chosen, returns the exit status:
// 0 every member done, 1 a member was set aside or the run failed, 2 bad input or usage, 85 stopped and resumable.

#include <span>
#include <string>
#include <vector>

#include "cli/command_line.hpp"

namespace floes {

inline constexpr const char* program_description =
    "floes: the load of managed ice floes on a structure, over many random arrangements";

/// Adds all verbs and --version. `command`: the command line of this process.
void add_verbs(CommandLine& line, std::span<char* const> command);

/// With --ranks it starts `command` again under mpirun.
void add_run(CommandLine& line, std::span<char* const> command);
void add_new(CommandLine& line);
void add_array(CommandLine& line);
void add_merge(CommandLine& line);
void add_status(CommandLine& line);
void add_plan(CommandLine& line);
void add_summarize(CommandLine& line);
void add_design(CommandLine& line);
void add_contour(CommandLine& line);
void add_config(CommandLine& line);
void add_laboratory(CommandLine& line);
void add_hybrid(CommandLine& line);
void add_hydro(CommandLine& line);
void add_report(CommandLine& line);
void add_replay(CommandLine& line);
void add_match(CommandLine& line);
void add_serve(CommandLine& line);
void add_vary(CommandLine& line);
void add_verify(CommandLine& line);

/// The tests of `floes laboratory`.
void add_plate(Verb& laboratory);
void add_cantilever(Verb& laboratory);

/// What --version prints: a line each for name and version, git revision, compiler, libraries, lanes.
std::string version_text();

}  // namespace floes
