#include "run/run_campaign.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "campaign/write.hpp"
#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "run/campaign_status.hpp"
#include "run/crew.hpp"
#include "run/hands.hpp"
#include "run/messages.hpp"
#include "run/plan.hpp"
#include "run/saved_members.hpp"
#include "run/scheduler.hpp"
#include "run/writer.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace {

// The master's view of the ranks: gathered before the first member is handed out, watched for heartbeats, and dismissed
// at the end.

struct Muster {
    std::vector<Hello> hellos;    ///< by rank
    bool stop_requested = false;  ///< a rank received a signal meanwhile

    /// Of all ranks.
    int cores() const {
        int sum = 0;
        for (const Hello& hello : hellos) sum += hello.cores;
        return sum;
    }
};

// A process by descriptor, because its number may be reused before it is needed. (The wrappers of glibc 2.36 have no
// C++ linkage.)
Descriptor open_process(int pid) {
    return Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, pid, 0)));
}

void kill_process(const Descriptor& process) {
    ::syscall(SYS_pidfd_send_signal, process.get(), SIGKILL, nullptr, 0);
}

Post post_of(int rank, const Groups& groups, const std::filesystem::path& journal) {
    const int writer = groups.writer_of(rank);
    if (writer != rank) return {writer, ""};
    return {writer, std::filesystem::absolute(piece_path(journal, groups.piece_of(rank))).string()};
}

void check_hello(int from, const Hello& hello, const std::string& fingerprint) {
    if (hello.fingerprint != fingerprint) {
        throw RunError(
            fmt::format("Rank {} on {} read a different campaign than the master ({} instead of {}): the "
                        "ranks run different builds of floes.",
                        from, hello.host, hello.fingerprint, fingerprint));
    }
}

/// Sends the campaign to every other rank, in a run with several writers with its post, and waits until each has said
/// hello. `journal`: whose pieces the writers open. `own`: the master's own hello. Throws
/// RunError if a rank read a different campaign, reports trouble, or if those that have not answered are silent for
/// twice the patience with a worker.
Muster muster(Link& link, const Campaign& campaign, const Groups& groups, const std::filesystem::path& journal,
              const Hello& own, const SilenceLimits& patience, const System& system) {
    Muster result{std::vector<Hello>(static_cast<std::size_t>(link.size())), false};
    result.hellos[0] = own;
    const Bytes text = link.size() > 1 ? encode(write_campaign(campaign)) : Bytes{};
    const bool has_writers = !groups.writers().empty();
    for (int rank = 1; rank < link.size(); ++rank) {
        if (has_writers) link.send(rank, Tag::post, encode(post_of(rank, groups, journal)));
        link.send(rank, Tag::campaign, text);
    }
    Pause pause = pause_between_polls(link.size());
    // Ranks begin at different speeds, so they have twice the time that is allowed to them later.
    const std::chrono::duration<double> longest_silence{2 * patience.with_a_worker};
    auto last_word = system.now();
    for (int present = 1; present < link.size();) {
        const auto message = link.poll();
        if (!message) {
            if (system.now() - last_word > longest_silence) {
                throw RunError(fmt::format(
                    "Only {} of {} ranks have answered after {:g} s of silence. Start the run again, with --resume.",
                    present, link.size(), longest_silence.count()));
            }
            system.sleep(pause.next());
            continue;
        }
        last_word = system.now();
        pause.something_happened();
        if (message->tag == Tag::trouble) {
            throw RunError(fmt::format("Rank {}: {}", message->from, decode<std::string>(message->bytes)));
        }
        if (message->tag == Tag::stop_request) {
            result.stop_requested = true;
            continue;
        }
        if (message->tag == Tag::alive) continue;  // it has said hello, and waits for slower ones
        if (message->tag != Tag::hello) throw RunError(fmt::format("Rank {} did not begin with hello.", message->from));
        const Hello hello = decode<Hello>(message->bytes);
        check_hello(message->from, hello, own.fingerprint);
        result.hellos[static_cast<std::size_t>(message->from)] = hello;
        ++present;
    }
    return result;
}

class RankWatch {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `link` must outlive the watch. `mustered`: of muster().
    RankWatch(Link& link, const Muster& mustered, const SilenceLimits& patience, Time now)
        : link_(link), patience_(patience), silence_(link.size(), now) {
        const std::string& here = mustered.hellos.at(master_rank).host;
        for (int rank = 1; rank < link.size(); ++rank) {
            const Hello& hello = mustered.hellos.at(static_cast<std::size_t>(rank));
            if (hello.host == here) processes_.emplace(rank, open_process(hello.pid));
        }
    }

    /// To be called when a message of the rank has arrived.
    void heard(int rank) { silence_.heard(rank); }

    /// To be called after all arrived messages were taken. Sends the other ranks a sign of life when it is due. Returns
    /// the ranks that have now been silent for too long, and for how many s; the link has abandoned them.
    std::vector<std::pair<int, double>> watch(Time now) {
        silence_.listened(now);
        if (silence_.total() < next_sign_) return {};
        next_sign_ = silence_.total() + patience_.sign_of_life;
        std::vector<std::pair<int, double>> newly_lost;
        for (int rank = 1; rank < link_.size(); ++rank) {
            if (lost_.contains(rank)) continue;
            link_.send(rank, Tag::alive, {});
            if (silence_.of(rank) < patience_.with_a_worker) continue;
            lost_.insert(rank);
            link_.abandon(rank);
            newly_lost.emplace_back(rank, silence_.of(rank));
        }
        return newly_lost;
    }

    /// Kills lost ranks of this machine that still exist, because mpirun would wait for them, and lets the others leave
    /// without them. Does nothing if no rank was lost.
    void part() {
        if (lost_.empty()) return;
        for (const int rank : lost_) {
            if (const auto found = processes_.find(rank); found != processes_.end()) kill_process(found->second);
        }
        for (int rank = 1; rank < link_.size(); ++rank) link_.send(rank, Tag::part, {});
    }

  private:
    Link& link_;
    SilenceLimits patience_;
    Silence silence_;
    double next_sign_ = 0;                 // of life, in time listened
    std::map<int, Descriptor> processes_;  // of the ranks on this machine, by descriptors that stay valid
    std::set<int> lost_;
};

// The loop of rank 0: it passes events to the scheduler and obeys its commands, keeps the results, and shows the
// progress. The cores of rank 0 compute like those of any other rank; this thread mostly sleeps.

constexpr int self = 0;

/// The reasons of all attempts, in order; identical ones are given once.
std::string reason_of_all(std::span<const std::string> reasons) {
    if (reasons.size() == 1) return reasons[0];
    if (std::ranges::count(reasons, reasons[0]) == std::ssize(reasons))
        return fmt::format("{} ({} attempts)", reasons[0], reasons.size());
    std::string all;
    for (std::size_t i = 0; i < reasons.size(); ++i) {
        all += fmt::format("{}attempt {}: {}", i == 0 ? "" : " ", i + 1, reasons[i]);
    }
    return all;
}

/// s, as RunOptions has it: what runs longer is saved, and goes on in another run; 0 where a member cannot be saved.
double saves_every(const Campaign& campaign, const RunOptions& options) {
    const auto can = [](const Case& one) { return saves_state(one.scenario.general.solver); };
    return std::ranges::all_of(campaign.cases, can) ? options.saves_every : 0;
}

/// What is done with the answer of a finished member, as the scheduler wants it.
struct WithAnswer {
    std::function<void()> keep = {};
    std::function<void()> retry = {};
};

class Master {
  public:
    /// What is referred to must outlive the master. `setup`: of the crew of this rank. `mustered`: of muster().
    Master(const Campaign& campaign, const RunOptions& options, Link& link, const Groups& groups, Recorder& recorder,
           Progress& progress, const StopSignals& signals, const CrewSetup& setup, const Muster& mustered)
        : campaign_(campaign),
          system_(setup.system),
          link_(link),
          groups_(groups),
          recorder_(recorder),
          progress_(progress),
          signals_(signals),
          walltime_(options.walltime),
          saves_every_(saves_every(campaign, options)),
          scheduler_(recorder_.tally().found().tasks, campaign.run.attempts),
          crew_(campaign, setup),
          pause_(pause_between_polls(link_.size())),
          ranks_(link_, mustered, options.patience, begin_),
          pace_(recorder_.tally().found().pace) {
        for (const int writer : groups_.writers()) open_pieces_.insert(writer);
        if (mustered.stop_requested) request_stop("another rank");
        tell_time_left();
        for (int rank = 0; rank < link_.size(); ++rank) {
            const int cores = mustered.hellos.at(static_cast<std::size_t>(rank)).cores;
            handle(WorkerJoined{rank, cores, cores});  // one member ahead for each core
        }
    }

    /// Returns when every member has an answer or the run was stopped, every worker has said farewell, and every writer
    /// has closed its journal. Stops when no rank is left that computes. Throws RunError if a rank reports trouble or
    /// the journal cannot be written.
    void run() {
        while (!scheduler_.finished()) {
            advance();
            crew_.wait(pause_.next());
        }
        close_pieces();
        progress_.show_last(state());
    }

    /// Publishes the campaign file by all writers, after run(); false where there is only one, or one was lost, and of
    /// a simulated system, to which HDF5 cannot write. Throws RunError where the file cannot be written.
    bool publish_by_hands() {
        if (groups_.writers().empty() || lost_a_writer_ || &system_ != &this_system()) return false;
        return hands_.publish(recorder_.tally().published(), recorder_.journal(), recorder_.places().campaign_file);
    }

    /// RankWatch::part(), to be called when everything is on the disk.
    void part() { ranks_.part(); }

    /// A writer was lost; what it has told is in its journal.
    bool lost_a_writer() const { return lost_a_writer_; }

    /// What stopped the run, e.g. "SIGTERM"; empty if nothing did, or if all members were done nevertheless.
    std::string stopped_by() const { return scheduler_.done() < scheduler_.total() ? stop_reason_ : ""; }

  private:
    void advance() {
        bool something = link_.moving();
        while (const auto message = link_.poll()) {
            ranks_.heard(message->from);
            receive(*message);
            something = true;
        }
        for (Outcome& outcome : crew_.take()) {
            if (outcome.record) finished(self, outcome.number, std::move(*outcome.record));
            something = true;
        }
        if (const auto trouble = crew_.trouble(); trouble && !dismissed_) give_up(*trouble);
        if (dismissed_ && !left_ && crew_.held() == 0) {
            left_ = true;
            handle(WorkerLeft{self});
        }
        if (scheduler_.workers() == 0) request_stop("the loss of all ranks that compute");
        if (signals_.received() != 0) request_stop(signal_name(signals_.received()));
        if (recorder_.together()) request_stop("the stop rule");
        const auto now = system_.now();
        watch_ranks(now);
        watch_time(now);
        hand_out();
        if (const std::string trouble = recorder_.tend(now); !trouble.empty()) progress_.say(trouble);
        look_at_members(now);
        progress_.show(state(), now);
        if (something) pause_.something_happened();
    }

    void receive(const Message& message) {
        switch (message.tag) {
            case Tag::answer:
                for (Answer& answer : decode<std::vector<Answer>>(message.bytes)) {
                    finished(message.from, answer.number, std::move(answer.record));
                }
                return;
            case Tag::kept:
                for (const Kept& kept : decode<std::vector<Kept>>(message.bytes)) finished_in_piece(kept, message.from);
                return;
            case Tag::published:
            case Tag::digested:
                hands_.answered(message.from, message.bytes);
                pause_.something_happened();
                return;
            case Tag::farewell:
                handle(WorkerLeft{message.bytes.empty() ? message.from : decode<int>(message.bytes)});
                return;
            case Tag::closed:
                open_pieces_.erase(message.from);
                return;
            case Tag::alive:
                if (!message.bytes.empty()) recorder_.note(decode<std::vector<MemberProgress>>(message.bytes));
                return;
            case Tag::stop_request:
                request_stop(fmt::format("a signal to rank {}", message.from));
                return;
            case Tag::trouble:
                throw RunError(fmt::format("Rank {}: {}", message.from, decode<std::string>(message.bytes)));
            default:
                throw RunError(fmt::format("The master cannot interpret message {} of rank {}.",
                                           static_cast<int>(message.tag), message.from));
        }
    }

    void finished(int worker, int number, MemberRecord record) {
        const auto end = record.result.status == MemberStatus::done ? AttemptEnd::done : AttemptEnd::failed;
        finished({worker, number, record.attempt, end, record.result.wall_time},
                 {.keep = [&] { keep(number, record); }, .retry = [&] { note_failure(number, record); }});
    }

    void finished_in_piece(const Kept& kept, int writer) {
        const auto keep = [&] {
            failures_.erase(kept.number);
            recorder_.kept_in_piece(kept, groups_.piece_of(writer));
        };
        finished({kept.worker, kept.number, kept.note.attempt, AttemptEnd::done, kept.note.wall_time}, {.keep = keep});
    }

    void finished(const MemberFinished& event, const WithAnswer& with) {
        if (event.end == AttemptEnd::done)
            pace_ = std::max(pace_, event.run_time / expected_cost(campaign_, event.number));
        tell_time_left();
        handle(event, with);
        end_when_precise();
    }

    void give_up(const CrewTrouble& trouble) {
        if (trouble.stuck) {
            recorder_.sync();
            progress_.say(fmt::format(
                "{} The run ends immediately; --resume computes that member in an isolated process", trouble.sentence));
            std::_Exit(exit_stopped);
        }
        progress_.say(fmt::format("rank 0 stopped computing: {}", trouble.sentence));
        crew_.abandon();
        dismissed_ = true;
    }

    void tell_time_left() {
        const std::optional<double> left = walltime_.left(system_.now());
        if (!left || !(pace_ > 0)) return;
        const bool can_be_put_off = saves_every_ > 0 && *left > saves_every_;
        handle(TimeLeft{can_be_put_off ? std::numeric_limits<double>::infinity() : *left / pace_});
    }

    void look_at_members(std::chrono::steady_clock::time_point now) {
        constexpr std::chrono::seconds interval{2};
        if (now < next_look_) return;
        next_look_ = now + interval;
        recorder_.note(crew_.progress());
        longest_ = recorder_.tally().longest(now);
    }

    void watch_ranks(std::chrono::steady_clock::time_point now) {
        for (const auto& [rank, silence] : ranks_.watch(now)) {
            progress_.say(
                fmt::format("rank {} has been silent for {:.0f} s: others compute its members", rank, silence));
            lose(rank);
        }
    }

    void watch_time(std::chrono::steady_clock::time_point now) {
        const std::optional<double> left = walltime_.left(now);
        if (!left) return;
        if (*left <= 0) request_stop("the end of the time limit");
        if (scheduler_.assigned() == 0 && scheduler_.pending() > 0) {
            request_stop("the end of the time limit, before which no further member could finish,");
        }
    }

    void request_stop(const std::string& reason) {
        if (scheduler_.stopping()) return;
        stop_reason_ = reason;
        handle(StopRequested{});
    }

    void end_when_precise() {
        if (recorder_.tally().precise() && !scheduler_.stopping()) handle(StopRequested{});
    }

    /// Without its writer a group can bring its members nowhere.
    void lose(int rank) {
        handle(WorkerLost{rank});
        hands_.lost(rank);
        if (open_pieces_.erase(rank) == 0) return;
        lost_a_writer_ = true;
        const std::vector<int> group = groups_.group_of(rank);
        if (group.size() > 1)
            progress_.say(fmt::format("ranks {} to {} stop, since it kept their results", rank + 1, group.back()));
        for (const int other : group) {
            if (other == rank) continue;
            handle(WorkerLost{other});
            link_.send(other, Tag::dismiss, {});
        }
    }

    /// Everybody has left: nothing more comes into the pieces.
    void close_pieces() {
        if (!open_pieces_.empty()) recorder_.sync();  // a writer may take long
        for (const int writer : open_pieces_) link_.send(writer, Tag::close, {});
        while (!open_pieces_.empty()) listen();
    }

    /// Takes what has come from ranks that compute no more, and sleeps.
    void listen() {
        while (const auto message = link_.poll()) {
            ranks_.heard(message->from);
            receive(*message);
        }
        watch_ranks(system_.now());
        system_.sleep(pause_.next());
    }

    void handle(const Event& event, const WithAnswer& with = {}) {
        for (const Command& command : scheduler_.handle(event)) {
            if (const auto* assign = std::get_if<Assign>(&command)) {
                handed_out_[assign->worker].push_back({assign->number, assign->attempt, assign->apart});
            }
            if (const auto* dismiss = std::get_if<Dismiss>(&command)) obey(*dismiss);
            if (std::holds_alternative<Retry>(command)) with.retry();
            if (std::holds_alternative<Keep>(command)) with.keep();
        }
    }

    void keep(int number, MemberRecord& record) {
        if (record.result.status == MemberStatus::failed) {
            std::vector<std::string> reasons = failures_[number];
            reasons.push_back(record.result.reason);
            record.result.reason = reason_of_all(reasons);
            progress_.say(fmt::format("{} failed and was set aside: {}", name_of(number), record.result.reason));
        }
        failures_.erase(number);
        recorder_.keep(record);
    }

    void note_failure(int number, const MemberRecord& record) {
        failures_[number].push_back(record.result.reason);
        progress_.say(fmt::format("{} failed and will be retried: {}", name_of(number), record.result.reason));
    }

    void obey(const Dismiss& command) {
        hand_out();
        if (command.worker == self) {
            crew_.abandon();
            dismissed_ = true;
        } else {
            link_.send(command.worker, Tag::dismiss, {});
        }
    }

    /// Sends the latest assignments, in one message to each worker. The journal notes an attempt before it begins.
    void hand_out() {
        if (handed_out_.empty()) return;
        for (const auto& [worker, assignments] : handed_out_) {
            for (const Assignment& assignment : assignments) recorder_.started(assignment.number, assignment.attempt);
        }
        recorder_.hand_over();
        for (const auto& [worker, assignments] : handed_out_) {
            if (worker == self) {
                for (const Assignment& assignment : assignments) crew_.begin(assignment);
            } else {
                link_.send(worker, Tag::assign, encode(assignments));
            }
        }
        handed_out_.clear();
    }

    std::string name_of(int number) const {
        return fmt::format("member {} (case {}, arrangement {})", number, case_of(campaign_, number).name,
                           member_key(campaign_, number).arrangement);
    }

    ProgressState state() const {
        const Tally& tally = recorder_.tally();
        ProgressState state;
        state.total = tally.found().total;
        state.done = tally.done();
        state.failed = tally.failed();
        state.running = scheduler_.running();
        if (const auto& precision = tally.precision()) {
            state.half_width = precision->achieved();
            state.half_width_target = precision->target();
            state.in_order = precision->judged();
            state.obstacle = precision->obstacle();
        }
        state.finished_now = scheduler_.done();
        state.elapsed = std::chrono::duration<double>(system_.now() - begin_).count();
        state.finished_cost = scheduler_.done_cost();
        state.remaining_cost = scheduler_.remaining_cost();
        state.longest = longest_;
        return state;
    }

    const Campaign& campaign_;
    const System& system_;
    Link& link_;
    const Groups& groups_;
    Recorder& recorder_;
    Progress& progress_;
    const StopSignals& signals_;
    Walltime walltime_;
    double saves_every_;
    Scheduler scheduler_;
    Crew crew_;
    Pause pause_;
    System::Time begin_ = system_.now();
    std::map<int, std::vector<Assignment>> handed_out_;  // by worker, since the last hand_out()
    std::map<int, std::vector<std::string>> failures_;   // by member, the reasons of failed attempts that are retried
    RankWatch ranks_;
    std::vector<Heartbeat::UnderWay> longest_;  // running members, as of the last look
    std::chrono::steady_clock::time_point next_look_ = begin_;
    double pace_;                // s per unit of cost, of the slowest member so far; 0: unknown
    std::set<int> open_pieces_;  // writers that have not closed theirs
    bool lost_a_writer_ = false;
    Hands hands_{link_, campaign_, groups_, [this] { listen(); }};
    std::string stop_reason_;
    bool dismissed_ = false;  // the crew of this rank
    bool left_ = false;
};

// The run from its beginning to its end.

std::string opening(const Campaign& campaign, const RunOptions& options, int ranks, int cores) {
    return fmt::format("{}: {} = {} x {} on {}{}, into {}", campaign.name, counted(member_count(campaign), "member"),
                       counted(std::ssize(campaign.cases), "case"), counted(campaign.arrangements, "arrangement"),
                       counted(cores, "core"), ranks > 1 ? fmt::format(" of {} ranks", ranks) : "",
                       options.places.campaign_file.string());
}

std::string part_text(const CampaignPart& part, const Inventory& found) {
    return fmt::format("part {} of {}: {} of these members", part.number, part.of, found.total);
}

/// What earlier sessions left; empty if nothing. `saved`: members that were put off.
std::string stock(const Inventory& found, int saved) {
    if (found.reused() + found.retried + saved == 0) return {};
    return fmt::format("resumed: {} reused, {} to compute{}{}", counted(found.reused(), "member"), found.tasks.size(),
                       found.retried > 0 ? fmt::format(", {} of them retried", found.retried) : "",
                       saved > 0 ? fmt::format(", {} of them from where they were saved", saved) : "");
}

/// What this session did.
std::string harvest(const Tally& tally) {
    return fmt::format("{} reused, {} computed, {} retried, {} set aside", counted(tally.found().reused(), "member"),
                       tally.computed(), tally.found().retried, tally.set_aside());
}

/// Throws unless rank 0 sees the pieces that others have opened: results on another node's own disk would be lost.
void expect_to_see_pieces(const Groups& groups, const std::filesystem::path& journal, const System& system) {
    constexpr std::chrono::seconds longest{60};  // for which a shared file system may remember that there was none
    const auto deadline = system.now() + longest;
    for (const int writer : groups.writers()) {
        const std::filesystem::path piece = piece_path(journal, groups.piece_of(writer));
        while (!is_there(piece, system)) {
            if (system.now() > deadline)
                throw RunError(fmt::format(
                    "{}, which rank {} has opened, is not to be seen by rank 0. All ranks that keep results "
                    "need one folder: give -o on a shared file system, or --writers 1.",
                    piece.string(), writer));
            system.sleep(std::chrono::milliseconds(100));
        }
    }
}

Session session_of(int ranks, int cores, const System& system) {
    return describe_session(ranks, cores, std::array{Software{"MPI", library_version()}}, system);
}

/// After all arrangements, where the stop rule is not met.
std::string imprecise_sentence(const Campaign& campaign, PrecisionStop precision) {
    precision.look();
    const std::string all = fmt::format("all {} arrangements are done and", campaign.arrangements);
    if (const std::string obstacle = precision.obstacle(); !obstacle.empty())
        return fmt::format("{} the half-width is not known, target {:g} %: {}", all, 100 * precision.target(),
                           obstacle);
    const std::string reached =
        precision.achieved() <= precision.target()
            ? fmt::format(", but not met for stop.look_ahead = {} arrangements in a row after {}",
                          campaign.stop.look_ahead, precision.minimum())
            : "; to continue, raise campaign.arrangements and resume";
    return fmt::format("{} the half-width is {:.1f} %, target {:g} %{}", all, 100 * precision.achieved(),
                       100 * precision.target(), reached);
}

CaseStatus total_of(const Tally& tally) {
    const int total = tally.precise() ? member_count(tally.published()) : tally.found().total;
    const int done = tally.precise() ? total - tally.failed() : tally.done();
    return {"all", done, tally.failed(), total - done - tally.failed()};
}

/// Prints the final messages and returns the exit status.
int conclude(const Campaign& campaign, const RunOptions& options, Recorder& recorder, Progress& progress,
             Master& master) {
    const auto by_hands = [&] { return master.publish_by_hands(); };
    const std::string stopped_by = master.stopped_by();
    const Tally& tally = recorder.tally();
    const bool taken_in = options.places.with_file || master.lost_a_writer();
    const int lost = taken_in ? recorder.take_in_pieces(master.lost_a_writer()) : 0;
    const bool resumed = recorder.journal().contents().sessions.size() > 1;
    const std::string file = options.places.campaign_file.string();
    const int total = members_of(total_of(tally));
    if (lost > 0 && stopped_by.empty()) {
        progress.say(
            fmt::format("{} of this run {} in no journal, since a rank that kept results was lost; to resume: {}",
                        counted(lost, "member"), lost == 1 ? "is" : "are", options.resume_command));
        recorder.finish("members were lost");
        return exit_stopped;
    }
    if (tally.precise()) {
        const PrecisionStop& precision = *tally.precision();
        progress.say(fmt::format(
            "precise enough after {} of at most {} arrangements: half-width {:.1f} %, target {:g} %",
            precision.arrangements(), campaign.arrangements, 100 * precision.achieved(), 100 * precision.target()));
    } else if (const auto& together = recorder.together(); together && !stopped_by.empty()) {
        progress.say(fmt::format(
            "precise enough: all parts together have the half-width {:.1f} %, target {:g} %, after {} of at most {} "
            "arrangements, so what is left of this part is not needed",
            100 * together->achieved(), 100 * together->target(), together->arrangements(), campaign.arrangements));
    } else if (!stopped_by.empty()) {
        recorder.sync();  // before anything slow, because the batch system may kill the run soon
        if (resumed) progress.say(harvest(tally));
        progress.say(fmt::format("stopped by {} with {} of {} done and on the disk; to resume: {}", stopped_by,
                                 tally.done() + tally.failed() - lost, counted(total, "member"),
                                 options.resume_command));
        recorder.finish("stopped", by_hands);
        return exit_stopped;
    }
    if (resumed) progress.say(harvest(tally));
    recorder.finish(tally.failed() > 0 ? "complete, members failed" : "complete", by_hands);
    if (const auto& precision = tally.precision(); precision && !tally.precise())
        progress.say(imprecise_sentence(campaign, *precision));
    if (tally.failed() > 0) {
        progress.say(fmt::format("{} of {} failed and {} missing in {}; floes status {} shows the reasons",
                                 tally.failed(), counted(total, "member"), tally.failed() == 1 ? "is" : "are", file,
                                 shell_word(file)));
        return 1;
    }
    return 0;
}

}  // namespace

int run_campaign(const Campaign& campaign, const RunOptions& options, Link& link, const MemberFunction& compute,
                 Progress& progress, Helper* helper) {
    const StopSignals signals;
    const System& system = options.places.system;
    if (Recorder::is_over(campaign, options.places)) {
        progress.say(fmt::format("{} has all of {}: nothing is left to compute", options.places.campaign_file.string(),
                                 counted(member_count(campaign), "member")));
        options.at_end({"all", member_count(campaign), 0, 0});
        return 0;
    }
    Recorder recorder(campaign, options.places);
    const Hello own{threads_of(link, options.threads), host_name(), fingerprint(campaign), ::getpid()};
    const Groups groups(link.size(), options.writers);
    const Muster mustered =
        muster(link, campaign, groups, journal_path(options.places.campaign_file), own, options.patience, system);
    expect_to_see_pieces(groups, journal_path(options.places.campaign_file), system);
    progress.say(opening(campaign, options, link.size(), mustered.cores()));
    if (const Inventory& found = recorder.tally().found(); campaign.stop.active() && !found.precise())
        progress.say(stop_forecast(campaign, options.places.part, found.done, found.pace, mustered.cores()));
    if (options.places.part.of > 1) progress.say(part_text(options.places.part, recorder.tally().found()));
    if (const std::string remark = binding_remark(link.topology()); !remark.empty()) progress.say(remark);
    if (recorder.journal().contents().damaged_bytes > 0) {
        progress.say(
            fmt::format("{} bytes of the journal are damaged and were skipped; the members in them are computed "
                        "again, unless the campaign file has them. Is the disk failing?",
                        recorder.journal().contents().damaged_bytes));
    }
    for (const std::string& line : recorder.journal().extension()) {
        progress.say(fmt::format("the campaign is extended, existing results are kept: {}", line));
    }
    for (const std::string& change : recorder.begin(session_of(link.size(), mustered.cores(), system))) {
        progress.say(
            fmt::format("the earlier members may differ in the last bits from results of this program; {}", change));
    }
    const int saved = options.saves_every > 0 ? count_saved(campaign, options.places.campaign_file, system) : 0;
    if (const std::string text = stock(recorder.tally().found(), saved); !text.empty()) progress.say(text);
    Master master(campaign, options, link, groups, recorder, progress, signals,
                  {compute, own.cores, helper, options.cores, system}, mustered);
    try {
        master.run();
    } catch (...) {
        recorder.give_up();
        options.at_end(total_of(recorder.tally()));
        throw;
    }
    options.at_end(total_of(recorder.tally()));
    const int status = conclude(campaign, options, recorder, progress, master);
    master.part();
    return status;
}

int lead_ranks(Link& link, std::ostream& errors, const std::function<int()>& body) {
    int status = 1;
    try {
        status = body();
    } catch (const InputError& error) {
        errors << fmt::format("floes: {}\n", error.what());
        status = 2;
    } catch (const std::exception& error) {
        errors << fmt::format("floes: {}\n", error.what());
    }
    for (int rank = 1; rank < link.size(); ++rank) link.send(rank, Tag::leave, encode(status));
    return status;
}

}  // namespace floes
