#pragma once
// The verbs of the command. Each adds its subcommand to the program and, when chosen, sets the exit status:
// 0 every member done, 1 a member was set aside or the run failed, 2 bad input or usage, 85 stopped and resumable.

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <vector>

namespace floes {

/// All verbs, the program's description and --version. `command`: the words of this process.
void add_verbs(CLI::App& program, int& exit_status, std::span<char* const> command);

/// With --ranks it starts `command` again, under mpirun.
void add_run(CLI::App& program, int& exit_status, std::span<char* const> command);
void add_merge(CLI::App& program, int& exit_status);
void add_status(CLI::App& program, int& exit_status);
void add_plan(CLI::App& program, int& exit_status);
void add_summarize(CLI::App& program, int& exit_status);
void add_design(CLI::App& program, int& exit_status);
void add_config(CLI::App& program, int& exit_status);
void add_calibrate(CLI::App& program, int& exit_status);
void add_cantilever(CLI::App& program, int& exit_status);
void add_hybrid(CLI::App& program, int& exit_status);
void add_report(CLI::App& program, int& exit_status);
void add_replay(CLI::App& program, int& exit_status);
void add_match(CLI::App& program, int& exit_status);
void add_verify(CLI::App& program, int& exit_status);

/// The flag --version, and what it prints: a line each for name and version, git revision, compiler, libraries, lanes.
void add_version(CLI::App& program);
std::string version_text();

/// The option --set of a verb that reads a configuration: key=value, repeatable, into `overrides`.
CLI::Option* add_overrides(CLI::App& verb, std::vector<std::string>& overrides);

/// The option --format of a verb whose answer is a table: "table", "json" or "csv", as written() takes it.
void add_format(CLI::App& verb, std::string& format);

/// The option --window of a verb that measures loads: "given" or "auto".
void add_window(CLI::App& verb, std::string& window);

}  // namespace floes
