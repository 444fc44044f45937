// floes run: computes a campaign from its configuration to its campaign file, on every core, alone or under mpirun.

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>

#include "campaign/case_words.hpp"
#include "cli/commands.hpp"
#include "cli/until.hpp"
#include "core/started_program.hpp"
#include "core/trial.hpp"
#include "findings/overview.hpp"
#include "run/calibrate.hpp"
#include "run/campaign_status.hpp"
#include "run/link.hpp"
#include "run/run_campaign.hpp"
#include "run/saved_members.hpp"
#include "run/signals.hpp"
#include "run/worker.hpp"
#include "store/file_calls.hpp"
#include "store/journal.hpp"

namespace floes {

namespace {

// floes run --ranks N: the program starts itself again as N ranks on this machine.

constexpr int not_started = 127;  // as shells have it

std::string mpirun() {
    const char* given = std::getenv("FLOES_MPIRUN");
    return given != nullptr && *given != '\0' ? given : "mpirun";
}

std::vector<std::string> rank_command(int ranks, std::span<char* const> command) {
    std::vector<std::string> words{mpirun(), "-n", std::to_string(ranks)};
    // Each rank distributes its threads over the cores that it shares with the other ranks, so it must not be bound.
    if (library_version().starts_with("Open MPI")) words.insert(words.end(), {"--oversubscribe", "--bind-to", "none"});
    words.insert(words.end(), command.begin(), command.end());
    return words;
}

void prepare_environment(const char* program) {
    constexpr int keep = 0;
    setenv("FLOES_LAUNCHER", program, keep);      // so that the printed command has --ranks
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", keep);  // in containers the only user is root
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", keep);
    // In containers a process must not read the memory of another; Open MPI would warn of that and continue.
    setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", keep);
}

/// In the child. Returns only if mpirun could not be started.
void become(std::vector<std::string> words, const sigset_t& signals) {
    setpgid(0, 0);  // so that Ctrl-C reaches its parent alone
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    sigprocmask(SIG_UNBLOCK, &signals, nullptr);
    if (const int nothing = open("/dev/null", O_RDONLY); nothing >= 0) dup2(nothing, STDIN_FILENO);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
}

/// Passes signals on until the child has ended; its status.
int wait_for(pid_t child, const sigset_t& signals) {
    bool asked = false;
    while (true) {
        int signal = 0;
        sigwait(&signals, &signal);
        if (signal == SIGCHLD) {
            int status = 0;
            if (waitpid(child, &status, WNOHANG) != child) continue;
            return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
        // On SIGINT and SIGTERM mpirun kills the ranks after a second and loses their exit status. It forwards SIGUSR1,
        // which the ranks take as a request to stop.
        kill(child, signal == SIGUSR1 || !asked ? SIGUSR1 : SIGTERM);
        asked = asked || signal != SIGUSR1;
    }
}

/// Runs `command` (the words of this process, the first of them the program) under mpirun and waits for it. The first
/// of stop_signals asks the ranks to stop, as SIGUSR1 does; a second one ends mpirun. mpirun ends if this process dies.
/// Returns mpirun's exit status, or 128 and its signal. The environment variable FLOES_MPIRUN names another mpirun.
/// Throws RunError if it cannot be started. Call it before any thread.
int run_ranks(int ranks, std::span<char* const> command) {
    prepare_environment(command[0]);
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGCHLD);
    for (const int signal : stop_signals)
        if (!is_to_be_outlived(signal)) sigaddset(&signals, signal);
    sigprocmask(SIG_BLOCK, &signals, nullptr);
    const pid_t child = fork();
    if (child == 0) {
        become(rank_command(ranks, command), signals);
        _exit(not_started);
    }
    if (child < 0) throw RunError("no process could be started for mpirun.");
    const int status = wait_for(child, signals);
    if (status == not_started)
        throw RunError(
            fmt::format("{} could not be started; is MPI's program of that name installed and in the PATH? "
                        "FLOES_MPIRUN can name it.",
                        mpirun()));
    return status;
}

// The run of this process.

struct RunVerb {
    std::string config;
    std::string output;
    bool resume = false;
    bool overwrite = false;
    bool retry_failed = false;
    int threads = 0;
    int ranks = 0;
    int writers = 0;
    bool no_file = false;
    bool keep_journal = false;
    std::string part;
    std::string isolation;
    std::string until;
    double time_left = 0;
    double checkpoint = 5;  // min
    std::string on_end;     // command
    std::string metrics;
    std::vector<std::string> overrides;
};

std::filesystem::path output_of(const RunVerb& verb) {
    const std::string name = std::filesystem::path(verb.config).stem().string();
    const std::string part = verb.part.substr(0, verb.part.find('/'));
    return target_of(!verb.output.empty() ? verb.output  // a link is the campaign that it leads to
                     : verb.part.empty()  ? name + ".h5"
                                          : fmt::format("{}.part{}.h5", name, part));
}

constexpr double longest_save = 30;  // s, for a state to reach the disk

double saves_every(const RunVerb& verb) {
    return 60 * verb.checkpoint;
}

/// "mpirun -n 4 --bind-to none --map-by ppr:1:node ": as many ranks, as many on a node, each with all cores of its
/// node.
std::string start_of_ranks(const Link& link) {
    std::string command = fmt::format("mpirun -n {} ", link.size());
    if (!library_version().starts_with("Open MPI")) return command;
    command += "--bind-to none ";
    const int on_a_node = link.topology().node_ranks;
    return on_a_node < link.size() ? command + fmt::format("--map-by ppr:{}:node ", on_a_node) : command;
}

/// With the ranks of `link` as this run; without one on a single core, to write the file that --no-file left out.
std::string resume_command(const RunVerb& verb, const std::string& program, const Link* link) {
    const int ranks = link == nullptr ? 1 : link->size();
    const char* launcher = std::getenv("FLOES_LAUNCHER");  // the script that starts the ranks, if any
    std::string command = ranks > 1 && launcher == nullptr ? start_of_ranks(*link) : "";
    command += fmt::format("{} run ", program);
    if (ranks > 1 && launcher != nullptr) command += fmt::format("--ranks {} ", ranks);
    command += fmt::format("{} -o {} --resume", shell_word(verb.config), shell_word(output_of(verb).string()));
    if (!verb.part.empty()) command += " --part " + verb.part;
    if (verb.keep_journal) command += " --keep-journal";
    if (link != nullptr) {
        if (verb.retry_failed) command += " --retry-failed";
        if (verb.threads > 0) command += fmt::format(" --threads {}", verb.threads);
        if (verb.writers > 0) command += fmt::format(" --writers {}", verb.writers);
        if (verb.checkpoint != RunVerb{}.checkpoint) command += fmt::format(" --checkpoint-min {}", verb.checkpoint);
        if (verb.no_file) command += " --no-file";
        if (!verb.metrics.empty()) command += " --metrics " + shell_word(verb.metrics);
        if (!verb.on_end.empty()) command += " --on-end " + shell_word(verb.on_end);
    }
    for (const std::string& setting : verb.overrides) command += " --set " + shell_word(setting);
    return command;
}

/// Reads K/N of --part.
CampaignPart part_of(const RunVerb& verb, const Campaign& campaign) {
    if (verb.part.empty()) return {};
    CampaignPart part;
    char rest = 0;
    const bool read = std::sscanf(verb.part.c_str(), "%9d/%9d%c", &part.number, &part.of, &rest) == 2;
    if (read && 1 <= part.number && part.number <= part.of && part.of <= campaign.arrangements) return part;
    throw InputError(
        fmt::format("--part {} is not a part of this campaign; it is K/N, part K of N, with K from 1 to N and N from 1 "
                    "to its {}.",
                    verb.part, counted(campaign.arrangements, "arrangement")));
}

/// `ended`: gets the campaign's name and the members of a run that has begun. `began`: when the time left was as
/// stated.
int lead(const RunVerb& verb, const std::string& program, Link& link, const MemberFunction& compute, Helper& helper,
         CampaignStatus& ended, Walltime::Time began) {
    if (verb.ranks > 0 && verb.ranks != link.size())
        throw InputError(fmt::format("--ranks {} inside mpirun, which started {}; leave --ranks out there.", verb.ranks,
                                     counted(link.size(), "rank")));
    const JobTimeLeft time_left = find_time_left(verb.time_left);
    const Walltime walltime(time_left.seconds, verb.time_left > 0 ? began : std::chrono::steady_clock::now());
    Campaign campaign = load_campaign(verb.config, verb.overrides);
    RunOptions options{.places = {.campaign_file = output_of(verb),
                                  .existing = verb.resume      ? Existing::resume
                                              : verb.overwrite ? Existing::replace
                                                               : Existing::refuse,
                                  .part = part_of(verb, campaign),
                                  .with_file = !verb.no_file,
                                  .metrics = verb.metrics,
                                  .retry_failed = verb.retry_failed,
                                  .keep_journal = verb.keep_journal},
                       .threads = verb.threads,
                       .writers = verb.writers,
                       .resume_command = resume_command(verb, program, &link),
                       .walltime = walltime,
                       .saves_every = saves_every(verb),
                       .at_end = [&](const CaseStatus& total) {
                           ended.title = campaign.name;
                           ended.cases = {total};
                       }};
    expect_no_other_file(options.places.campaign_file);
    int status = 0;
    {
        Progress progress(std::cerr, style_of_standard_error());
        if (!time_left.remark.empty()) progress.say(time_left.remark);
        if (const std::string remark = hull_remark(campaign); !remark.empty()) progress.say(remark);
        for (const std::string& sentence : advice(campaign)) progress.say(sentence);
        Recorder::check(options.places);  // before the calibration, which takes a minute
        {
            const LeaveOnSignals leave;  // nothing has started yet that would need an orderly end
            options.places.calibrations = calibrate_campaign(campaign, kept_calibrations(options.places),
                                                             threads_of(link, verb.threads), progress);
            settle_moduli(campaign, threads_of(link, verb.threads), progress);
        }
        status = run_campaign(campaign, options, link, compute, progress, &helper);
        if (verb.no_file && status != exit_stopped)
            progress.say(fmt::format("the results are in {}; to write {}, one core is enough: {}",
                                     journal_path(options.places.campaign_file).string(),
                                     options.places.campaign_file.string(), resume_command(verb, program, nullptr)));
    }
    if (status != exit_stopped && options.places.part.of == 1 && !verb.no_file) {
        Evidence evidence = read_evidence(options.places.campaign_file);
        print({overview_section(evidence), next_commands(evidence, program)}, "table", evidence.units);
    }
    return status;
}

constexpr Seconds longest_message{60};

/// What the command of --on-end finds in its environment.
void tell_environment(const RunVerb& verb, int status, const CampaignStatus& ended) {
    const char* outcome = status == 0              ? "done"
                          : status == exit_stopped ? "stopped"
                          : status == 2            ? "refused"
                                                   : "failed";
    const CaseStatus total = total_of(ended);
    const std::string words =
        ended.cases.empty() ? fmt::format("floes run {}: {}", verb.config, outcome) : counts_sentence(ended);
    const std::pair<const char*, std::string> told[]{{"FLOES_OUTCOME", outcome},
                                                     {"FLOES_EXIT_STATUS", std::to_string(status)},
                                                     {"FLOES_CAMPAIGN_FILE", output_of(verb).string()},
                                                     {"FLOES_DONE", std::to_string(total.done)},
                                                     {"FLOES_FAILED", std::to_string(total.failed)},
                                                     {"FLOES_MISSING", std::to_string(total.missing)},
                                                     {"FLOES_WORDS", words}};
    for (const auto& [name, value] : told) setenv(name, value.c_str(), 1);
}

/// Starts the command of --on-end, and waits for it.
void tell_of_end(const RunVerb& verb, int status, const CampaignStatus& ended) {
    if (verb.on_end.empty()) return;
    tell_environment(verb, status, ended);
    StartedProgram command({"/bin/sh", "-c", verb.on_end}, {.out = STDERR_FILENO, .errors = STDERR_FILENO});
    if (!command.fault().empty()) {
        note("the command of --on-end could not be started: {}", command.fault());
    } else if (!command.wait(longest_message)) {
        note("the command of --on-end ran for longer than {:g} s and was ended", longest_message.count());
    } else if (command.status() != 0) {
        note("the command of --on-end ended with status {}", command.status());
    }
}

int run(const RunVerb& verb, const std::string& program) {
    const auto began = std::chrono::steady_clock::now();  // MPI may take minutes to start
    outlive_readers();
    const MemberFunction compute = long_members(output_of(verb), saves_every(verb));
    Helper helper(compute, verb.checkpoint > 0 ? longest_save : 0);  // before MPI and the first thread
    const std::unique_ptr<Link> link = open_link();
    if (link->rank() != 0) return serve_campaign(*link, verb.threads, compute, &helper);
    CampaignStatus ended;
    const int status =
        lead_ranks(*link, std::cerr, [&] { return lead(verb, program, *link, compute, helper, ended, began); });
    tell_of_end(verb, status, ended);
    return status;
}

/// What tells others of the run.
void add_messages(Verb& verb, RunVerb& options) {
    verb.option("--metrics", options.metrics,
                "A file in the text format of Prometheus, written anew every 5 s: members by state, rate and time left")
        .writes_file();
    verb.option(
        "--on-end", options.on_end,
        "A command for the shell when the run has ended, as for a message: it finds FLOES_OUTCOME (done, failed, "
        "stopped, refused), FLOES_EXIT_STATUS, FLOES_CAMPAIGN_FILE, FLOES_DONE, FLOES_FAILED, FLOES_MISSING and "
        "FLOES_WORDS, a sentence, in its environment, and has a minute");
}

}  // namespace

void add_run(CommandLine& line, std::span<char* const> command) {
    auto options = std::make_shared<RunVerb>();
    Verb verb = line.verb("run", "Run a campaign on every core, alone or under mpirun");
    verb.option("config", options->config, "The configuration (CONFIG.toml), or the name of an installed one, as smoke")
        .required();
    verb.option("-o,--output", options->output,
                "The campaign file; default: CONFIG.h5 in this folder, of a part CONFIG.partK.h5")
        .file_ending({".h5", ".hdf5", ".nc"});
    Option resume = verb.flag("--resume", options->resume, "Resume an existing campaign, or start if there is none");
    verb.flag("--retry-failed", options->retry_failed, "With --resume: retry members that were set aside as failed")
        .needs(resume);
    verb.flag("--overwrite", options->overwrite, "Start afresh and replace an existing campaign").excludes(resume);
    verb.option("--threads", options->threads,
                "Number of members at a time on each rank; default: one for each of its cores")
        .within(1, 4096);
    verb.option("--ranks", options->ranks,
                "Start that many ranks on this machine with mpirun (FLOES_MPIRUN names another); on several nodes "
                "call mpirun yourself")
        .within(1, 4096);
    verb.option("--writers", options->writers,
                "Number of ranks that keep results, each in a journal and then a piece of the campaign file; default: "
                "one up to 15 ranks, then one for every four, at most 256")
        .within(1, 4096);
    verb.flag("--no-file", options->no_file,
              "End with the results in the journal, while many cores wait for the campaign file; --resume on one core "
              "writes it");
    verb.flag("--keep-journal", options->keep_journal, keep_journal_words);
    verb.option("--part", options->part,
                "K/N: run only part K of N of the arrangements, into a separate file; floes merge merges the parts");
    verb.option("--isolation", options->isolation,
                "Where members are computed: none or process; same as --set run.isolation=…")
        .one_of({"none", "process"})
        .last_wins();  // slurm/ gives one, the user may give another
    verb.option(
            "--checkpoint-min", options->checkpoint,
            "Minutes after which a running member is saved, again and again, and goes on from there after --resume; "
            "0: never; default: 5")
        .within(0.0, 1e5);
    verb.option("--time-left", options->time_left,
                "Seconds until the run must have ended; default inside a Slurm job: the time left according to Slurm")
        .within(1e-3, 1e9);
    verb.option("--until", options->until,
                "Run until the question is answered: \"mooring_force 3 h +- 15 %\" for a design value of every case "
                "(load, mooring_force, offset, yaw, line_tension ...), \"mean_load +- 5 %\" for a mean; takes as many "
                "arrangements as that needs, at most 1000 unless --set campaign.arrangements says how many");
    add_messages(verb, *options);
    add_overrides(verb, options->overrides);
    verb.runs([options, &line, command] {
        if (options->ranks > 0 && !started_by_mpi()) return run_ranks(options->ranks, command);
        if (!options->until.empty()) {
            // What is set by hand comes after, so it counts.
            const std::vector<std::string> settings = until_settings(options->until);
            options->overrides.insert(options->overrides.begin(), settings.begin(), settings.end());
        }
        if (!options->isolation.empty()) options->overrides.push_back("run.isolation=" + options->isolation);
        return run(*options, line.typed_program());
    });
}

}  // namespace floes
