#pragma once
// The verbs of the command, with what every verb is made of. Each adds itself to the command line and, when chosen,
// returns the exit status: 0 every member done, 1 a member was set aside or the run failed, 2 bad input or usage, 85
// stopped and resumable.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/answer.hpp"
#include "cli/command_line.hpp"
#include "cli/given.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace floes {

struct CampaignStatus;

inline constexpr const char* program_description =
    "floes: the load of managed ice floes on a structure, over many random arrangements";

inline constexpr const char* keep_journal_words =
    "Keep the journal also when the campaign file has every member; by default it goes then, and --resume with more "
    "arrangements goes on from the file";

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
void add_show(CommandLine& line);
void add_laboratory(CommandLine& line);
void add_hybrid(CommandLine& line);
void add_hydro(CommandLine& line);
void add_report(CommandLine& line);
void add_replay(CommandLine& line);
void add_export(CommandLine& line);
void add_explore(CommandLine& line);
void add_match(CommandLine& line);
void add_serve(CommandLine& line);
void add_vary(CommandLine& line);
void add_verify(CommandLine& line);

// What `floes status` prints.

/// For people: a sentence, the active run, a line for each case, and the failures with their reasons.
std::string status_table(const CampaignStatus& status);

/// For programs: one JSON object with `title`, `done`, `failed`, `missing`, `total`, `at_work`, `seconds_left` and
/// `members_per_second` (null when unknown), `heartbeat`, `parts` and `stop` (null where there is none), `cases`,
/// `failures`, `remarks`, `under_way`, `slowest`, `sessions`.
std::string status_json(const CampaignStatus& status);

/// What --version prints: a line each for name and version, git revision, compiler, libraries, lanes.
std::string version_text();

}  // namespace floes
