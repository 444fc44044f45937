// floes plan and array: what a run will take, and the script that has a batch system compute it in parts.

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iostream>
#include <string_view>
#include <thread>
#include <utility>

#include <tbb/parallel_for.h>

#include "cli/commands.hpp"
#include "run/plan.hpp"
#include "tables/section.hpp"

namespace floes {

namespace {

constexpr double busy_master = 0.7;

std::string size(double bytes) {
    constexpr std::array units{"B", "kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    for (; bytes >= 1000 && unit + 1 < units.size(); ++unit) bytes /= 1000;
    return bytes < 100 ? fmt::format("{:.2g} {}", bytes, units[unit]) : fmt::format("{:.0f} {}", bytes, units[unit]);
}

std::string remark(int members, const PlanRow& row) {
    const Forecast& forecast = row.forecast;
    const std::string cores = counted(row.cores, "core");
    if (forecast.master_load > busy_master)
        return fmt::format("{}: the master is busy {:.0f} % of the time; more cores gain little.", cores,
                           100 * forecast.master_load);
    if (forecast.writer_load > busy_master)
        return fmt::format("{}: ranks that keep results are busy {:.0f} % of the time; ask for more with --writers.",
                           cores, 100 * forecast.writer_load);
    if (forecast.wall_time - forecast.last_member > 0.1 * forecast.wall_time)
        return fmt::format(
            "{}: start-up takes {} of the time, and writing the campaign file {}; floes run --no-file "
            "leaves that to one core.",
            cores, duration_in_figures(forecast.start_up), duration_in_figures(forecast.file_time));
    if (forecast.efficiency < 0.9 && members < 3 * row.cores)
        return fmt::format("{}: too few members; cores are idle while the last ones run.", cores);
    return "";
}

/// For people with a note on the bottleneck of each setting that has one. In JSON one object, in CSV a line for each
/// setting; times in s, sizes in bytes.
Section plan_section(const Campaign& campaign, const PlannedMembers& planned, std::span<const PlanRow> rows) {
    const int members = member_count(campaign);
    double mean_run_time = 0;
    double longest = 0;
    double message_bytes = 0;  // the largest answer
    for (const SimulatedMember& member : planned.members) {
        mean_run_time += member.run_time / members;
        longest = std::max(longest, member.run_time);
        message_bytes = std::max(message_bytes, member.record_bytes);
    }
    const bool calibrates = std::ranges::count(campaign.cases, Pairing::find_cfm, &Case::pairing) > 0;
    const double memory = core_memory(campaign);
    Section section;
    section.before =
        fmt::format("{}: {} of {} on average, {} at most, {} each; a core needs {} of memory.\nRun times: {}.\n{}\n",
                    campaign.name, counted(members, "member"), duration_in_figures(mean_run_time),
                    duration_in_figures(longest), size(message_bytes), size(memory), planned.source,
                    calibrates ? "Not counted: cases are calibrated first, about a minute.\n" : "");
    Results common = object("", {{"campaign", campaign.name},
                                 {"members", members},
                                 {"mean_run_time_s", mean_run_time},
                                 {"longest_run_time_s", longest},
                                 {"message_bytes", message_bytes},
                                 {"core_memory_bytes", memory},
                                 {"run_times_from", planned.source},
                                 {"calibration_not_counted", calibrates}});
    Results plans{.place = "plans",
                  .columns = {{"cores", "cores"},
                              {"ranks", "ranks"},
                              {"", "wall time"},
                              {"wall_time_s"},
                              {.key = "core_hours", .words = "core-hours", .digits = 4},
                              {.key = "efficiency", .words = "efficiency", .unit = "share", .decimals = 1},
                              {.key = "master_busy", .words = "master busy", .unit = "share", .digits = 2},
                              {"start_up_s"},
                              {"last_member_s"},
                              {"file_s"},
                              {"writers"},
                              {"writer_busy"},
                              {"", "file"},
                              {"file_bytes"},
                              {"", "journal"},
                              {"journal_bytes"},
                              {"", "master memory"},
                              {"master_memory_bytes"}}};
    for (const PlanRow& row : rows) {
        const Forecast& forecast = row.forecast;
        plans.add({row.cores, row.ranks, duration_in_figures(forecast.wall_time), forecast.wall_time,
                   row.cores * forecast.wall_time / unit::hour, forecast.efficiency, forecast.master_load,
                   forecast.start_up, forecast.last_member, forecast.file_time, forecast.writers, forecast.writer_load,
                   size(forecast.file_bytes), std::round(forecast.file_bytes), size(forecast.journal_bytes),
                   forecast.journal_bytes, size(row.master_memory), row.master_memory});
        if (const std::string told = remark(members, row); !told.empty()) section.notes.push_back(told);
    }
    section.results = {std::move(common), std::move(plans)};
    return section;
}

// floes plan: predicts wall time, core-hours, efficiency and sizes of a campaign.

struct PlanOptions {
    std::string config;
    std::vector<int> cores;
    std::vector<int> ranks;
    std::string from;
    double record_bytes = 0;  // 0: the actual size
    int writers = 0;
    bool no_file = false;
    std::string format = "table";
    std::vector<std::string> overrides;
};

std::vector<PlanRow> rows_of(const PlanOptions& options, const PlannedMembers& planned) {
    std::vector<int> cores = options.cores;
    if (cores.empty()) cores.push_back(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    if (options.ranks.size() > 1 && options.ranks.size() != cores.size()) {
        throw InputError(fmt::format("--ranks has {} numbers and --cores {}; give one for all, or one for each.",
                                     options.ranks.size(), cores.size()));
    }
    const DriverCosts costs = measured_costs();
    std::vector<PlanRow> rows(cores.size());
    tbb::parallel_for(std::size_t{0}, cores.size(), [&](std::size_t k) {
        int ranks = usual_ranks(cores[k]);
        if (!options.ranks.empty()) ranks = options.ranks[options.ranks.size() == 1 ? 0 : k];
        Machine machine = machine_of(cores[k], ranks);
        machine.writers = options.writers;
        rows[k] = plan_row(planned.members, machine, costs, !options.no_file);
    });
    return rows;
}

/// As they ran in the campaign file `from`; empty: as they are expected to.
PlannedMembers planned_members(const Campaign& campaign, const std::string& from) {
    return from.empty() ? expected_members(campaign) : measured_members(campaign, read_measured_run(from));
}

std::string plan_text(const PlanOptions& options) {
    const Campaign campaign = load_campaign(options.config, options.overrides);
    const WaitingNote patience(std::cerr, fmt::format("simulating the run of {} on each number of cores …",
                                                      counted(member_count(campaign), "member")));
    PlannedMembers planned = planned_members(campaign, options.from);
    if (options.record_bytes > 0) set_record_bytes(planned, options.record_bytes);
    const std::vector<PlanRow> rows = rows_of(options, planned);
    return written({plan_section(campaign, planned, rows)}, options.format);
}

}  // namespace

void add_plan(CommandLine& line) {
    auto options = std::make_shared<PlanOptions>();
    Verb verb = line.verb("plan", "Predict wall time, core-hours and efficiency of a run");
    verb.option("config", options->config, "The configuration (CONFIG.toml)").required();
    verb.option("--cores", options->cores,
                "Total number of cores, one or several settings; default: the cores of this machine")
        .comma_separated()
        .within(1, 10'000'000);
    verb.option("--ranks", options->ranks,
                "Number of ranks, one for all settings or one for each; default: one for every 64 cores")
        .comma_separated()
        .within(1, 1'000'000);
    verb.option("--writers", options->writers,
                "Number of ranks that keep results and write the file; default: as floes run has it")
        .within(1, 1'000'000);
    verb.flag("--no-file", options->no_file, "Of a run that leaves the campaign file to a later --resume");
    verb.option("--from", options->from, "Take run times from this campaign file (CAMPAIGN.h5), finished or running");
    verb.option("--record-bytes", options->record_bytes,
                "Assumed size of a member's result; default: the size of its record")
        .within(1.0, 1e12);
    add_format(verb, options->format);
    add_overrides(verb, options->overrides);
    verb.prints([options] { return plan_text(*options); });
}

// floes array: the script that has a batch system compute a campaign in parts.

namespace {

namespace fs = std::filesystem;

constexpr double usual_part = 1800;  // s: short enough to fill gaps of a queue, long enough for its start
constexpr int usual_cores = 4;
constexpr int soft_seconds = 120;  // before the time limit

struct ArrayOptions {
    std::string config;
    std::string output;
    std::string system;
    std::string parts = "auto";
    int cores = 0;  ///< 0: usual_cores; with parallel all of the machine
    int hours = 0;  ///< 0: by the expected run time
    std::string from;
    std::vector<std::string> overrides;
};

/// Of a task, as far as they are known before it starts.
int cores_of(const ArrayOptions& options) {
    return options.cores == 0 ? usual_cores : options.cores;
}

/// How a campaign is divided.
struct Division {
    int parts = 1;
    double longest = 0;  ///< s: expected wall time of a part
    std::string source;  ///< of that
};

int number_of_parts(const ArrayOptions& options, const Campaign& campaign, double core_seconds, int cores) {
    if (options.parts == "auto")
        return std::clamp(static_cast<int>(std::min(1e9, std::round(core_seconds / cores / usual_part))), 1,
                          campaign.arrangements);
    int parts = 0;
    const char* end = options.parts.data() + options.parts.size();
    const auto [read, error] = std::from_chars(options.parts.data(), end, parts);
    if (error != std::errc() || read != end || parts < 1 || parts > campaign.arrangements)
        throw InputError(fmt::format("--parts {} is neither auto nor a number from 1 to the campaign's {}.",
                                     options.parts, counted(campaign.arrangements, "arrangement")));
    return parts;
}

Division divide(const ArrayOptions& options, const Campaign& campaign, int cores) {
    const PlannedMembers planned = planned_members(campaign, options.from);
    double all = 0;
    double longest = 0;
    for (const SimulatedMember& member : planned.members) {
        all += member.run_time;
        longest = std::max(longest, member.run_time);
    }
    Division division{.parts = number_of_parts(options, campaign, all, cores), .longest = 0, .source = planned.source};
    division.longest = std::max(longest, all / cores / division.parts);
    return division;
}

/// A word that every batch system takes as a name.
std::string plain(std::string text) {
    for (char& c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-') c = '_';
    return text;
}

std::string options_of(const ArrayOptions& options) {
    std::string words = "--isolation process";
    const bool all_cores = options.system == "parallel" && options.cores == 0;
    if (!all_cores) words += fmt::format(" --threads {}", cores_of(options));
    for (const std::string& setting : options.overrides) words += " --set " + shell_word(setting);
    return words;
}

std::string merge_words(const fs::path& output) {
    const std::string stem = fs::path(output).replace_extension("").string();
    return fmt::format("floes merge {}.part*.h5 -o {}", shell_word(stem), shell_word(output.string()));
}

/// What starts this program in a job: its file or, where a loader that came along has started it, the script that did
/// so and by whose name it goes (packaging/bundled-floes).
fs::path program_of_jobs() {
    const fs::path file = fs::read_symlink("/proc/self/exe");
    return file.filename().string().starts_with("ld-linux") ? fs::absolute(program_invocation_name) : file;
}

std::string script_of(const ArrayOptions& options, const Division& division, const fs::path& output,
                      const std::string& name) {
    const std::string stem = fs::path(output).replace_extension("").string();
    const int cores = cores_of(options);
    const int usual_hours = static_cast<int>(std::ceil(4 * division.longest / unit::hour));
    const int hours = options.hours > 0 ? options.hours : std::clamp(usual_hours, 1, 24);
    const std::string next = fmt::format(
        "#     floes status {0}.part*.h5  # while they run; floes summarize takes the parts, too\n"
        "#     {1}  # of what is done; again: adds what is new",
        shell_word(stem), merge_words(output));
    const std::vector<std::pair<std::string_view, std::string>> values{
        {"@TASK@\n", std::string(starter("task.sh").value())},
        {"@SLOTS@\n", cores > 1 ? fmt::format("#$ -pe smp {}\n", cores) : ""},
        {"@PBS_ARRAY@\n", division.parts > 1 ? "#PBS -J 1-@PARTS@\n" : ""},
        {"@HEAD@", fmt::format("{} of {}, about {} each on {}. Written by floes array.",
                               counted(division.parts, "part"), fs::path(options.config).filename().string(),
                               duration_text(division.longest), counted(cores, "core"))},
        {"@NEXT@", next},
        {"@NAME@", "floes-" + plain(fs::path(stem).filename().string())},
        {"@LOG@", plain(fs::path(stem).filename().string())},
        {"@SCRIPT@", shell_word(name)},
        {"@PROGRAM@", shell_word(program_of_jobs().string())},
        {"@CONFIG@", shell_word(options.config)},
        {"@STEM@", shell_word(stem)},
        {"@OPTIONS@", options_of(options)},
        {"@CORES_WORDS@", options.cores == 0 ? "all its cores" : counted(cores, "core")},
        {"@PARTS@", std::to_string(division.parts)},
        {"@CORES@", std::to_string(cores)},
        {"@HOURS@", std::to_string(hours)},
        {"@SECONDS@", std::to_string(hours * 3600)},
        {"@SOFT_SECONDS@", std::to_string(hours * 3600 - soft_seconds)}};
    std::string text(starter(options.system + ".sh").value());
    for (const auto& [what, by] : values) replace_all(text, what, by);
    return text;
}

std::string submit_words(const std::string& system, const std::string& script) {
    const std::string file = shell_word(script);
    if (system == "slurm") return "sbatch " + file;
    if (system == "gridengine" || system == "pbs") return "qsub " + file;
    if (system == "lsf") return "bsub < " + file;
    if (system == "hyperqueue") return "hq submit " + file;
    return "bash " + file;
}

int write_array(const ArrayOptions& options) {
    const Campaign campaign = load_campaign(options.config, options.overrides);
    const fs::path output =
        options.output.empty() ? fs::path(fs::path(options.config).stem().string() + ".h5") : fs::path(options.output);
    if (const fs::path ending = output.extension(); ending != ".h5" && ending != ".hdf5" && ending != ".nc")
        throw InputError(
            fmt::format("{} is to be the campaign file that the parts are merged into; give it a name that "
                        "ends with .h5, .hdf5 or .nc.",
                        output.string()));  // the folder is made on the machine that computes them
    const Division division = divide(options, campaign, cores_of(options));
    const std::string script = fmt::format("{}.{}.sh", output.stem().string(), options.system);
    write_new(script, script_of(options, division, output, script));
    std::printf("%s\n", script.c_str());
    note("{} of {}, about {} each on {}; run times: {}\nfloes: now {}, and when parts are done {}",
         counted(division.parts, "part"), counted(member_count(campaign), "member"), duration_text(division.longest),
         counted(cores_of(options), "core"), division.source, submit_words(options.system, script),
         merge_words(output));
    return 0;
}

}  // namespace

void add_array(CommandLine& line) {
    auto options = std::make_shared<ArrayOptions>();
    Verb verb = line.verb("array", "Write the script with which a batch system computes a campaign in parts");
    verb.option("config", options->config, "The configuration (CONFIG.toml)").required();
    verb.option("--for", options->system,
                "The batch system; parallel: GNU parallel, on this machine and others that share the folder")
        .one_of({"slurm", "gridengine", "pbs", "lsf", "flux", "hyperqueue", "parallel"})
        .required();
    verb.option("--parts", options->parts,
                "How many parts, each a task of the array; auto: such that each takes about half an hour")
        .shows_default();
    verb.option("--cores", options->cores, "Cores of a task; default: 4, with parallel all of each machine")
        .within(1, 4096);
    verb.option("--hours", options->hours,
                "Time limit of a task, h; default: four times what it is expected to take. A task that reaches it "
                "resumes")
        .within(1, 8760);
    verb.option("--from", options->from, "Take run times from this campaign file (CAMPAIGN.h5), finished or running");
    verb.option("-o,--output", options->output,
                "The campaign file that the parts are merged into, NAME.h5; default: CONFIG.h5 in this folder. Parts "
                "are NAME.partK.h5 beside it, the script is NAME.SYSTEM.sh in this folder");
    add_overrides(verb, options->overrides);
    verb.footer(
        "Every task computes one part into its own file, with all cases of each of its arrangements, and obeys the\n"
        "signals of its system: it keeps what is done and resumes in its next start.\n\n"
        "  floes array my.toml --for slurm -o my.h5\n"
        "  sbatch my.slurm.sh\n"
        "  floes status my.part*.h5\n"
        "  floes merge my.part*.h5 -o my.h5");
    verb.runs([options] { return write_array(*options); });
}

}  // namespace floes
