#include "run/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "campaign_file/pieces.hpp"
#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "inference/precision_stop.hpp"
#include "member/array_output.hpp"
#include "run/campaign_status.hpp"
#include "run/link.hpp"
#include "run/scheduler.hpp"
#include "run/writer.hpp"
#include "store/journal.hpp"
#include "store/member_record.hpp"

namespace floes {

// Measured by
//
//     bench/dispatch.py build/release/bench/floes_dispatch dispatch.json
//
// on two cores of an otherwise idle virtual machine (Intel Xeon, family 6 model 207; Open MPI 4.1.4, HDF5 1.10.8):
// processor times, the smaller of two rounds. docs/performance.md compares the resulting plan with real runs.
// Publishing, reading and `kept` are of later builds. Not measured but taken from experience: start_up_per_rank,
// latency, transfer_per_byte, and the variation of members. The file by many hands (publish, order, index, digest) was
// measured on a machine that others used, where all else took 1.3 times as long; of an order half is measured, the
// other half for taking in what writers told. Run times of members: configs/table3.toml, 94 s of processor time for
// three members, 234 s for one with the stock solver. Bytes: 120 members of configs/smoke.toml, and 12 of
// configs/moored_platform.toml, whose histories take 6.4 a number; what breaks is not foreseen. Memory: what 200,001
// members of tests/faults take more than 50,001, at most at any moment.

DriverCosts measured_costs() {
    return {
        .start_up = 0.01,
        // Assumed, not measured: nodes launch their ranks in parallel, and the master greets them one after the other.
        // If two processors launch all ranks it is 0.12 s.
        .start_up_per_rank = 2e-3,
        .send = 0.4e-6,
        .assign = 2.1e-6,
        .receive = 1.5e-6,
        .answer = 6.2e-6,
        .own_member = 17e-6,
        .kept = 2.8e-6,
        .receive_per_byte = 0.24e-9,
        .keep_per_byte = 1.3e-9,
        .sync = 0.6e-3,
        .sync_interval = 0.9,  // this one and those for publishing as in run/recorder.cpp
        .publish = 0.045,
        .publish_per_member = 22e-6,
        .publish_per_byte = 1.5e-9,
        .publish_interval = 300,
        .publish_share = 1.0 / 20,
        .read_per_member = 7.7e-6,
        .read_per_byte = 0.18e-9,
        .order_per_member = 0.3e-6,
        .index = 0.06,
        .index_per_piece = 4.7e-3,
        .digest_per_piece = 1.3e-3,
        .digest_per_member = 3e-6,
        .digest_texts = 0.3e-6,
        .memory_per_member = 290,
        .member = 24e-6,
        .member_per_byte = 21e-9,
        .report = 11e-6,
        .report_per_byte = 1.1e-9,
        .longest_held_back = 0.05,  // as in run/worker.hpp; the next as in run/worker.cpp
        .most_held_back = 256,
        .latency = 5e-6,  // between ranks of one machine
        .transfer_per_byte = 0.2e-9,
        .longest_pause = 10e-3,  // as in run/worker.hpp
    };
}

namespace {

// Simulated time of the master's single thread, which works sequentially, syncs the journal when due, and publishes,
// with other writers only at the end. Times in s from the start of the run.

/// The processors shared by all threads, first come, first served.
class Processors {
  public:
    /// count 0: every thread has its own.
    explicit Processors(int count) {
        for (int i = 0; i < count; ++i) free_at_.push(0.0);
    }

    /// When `work` seconds of work end that can start at `ready`. To be called in order of time.
    double run(double ready, double work) {
        if (free_at_.empty() || work <= 0) return ready + work;
        const double end = std::max(ready, free_at_.top()) + work;
        free_at_.pop();
        free_at_.push(end);
        return end;
    }

  private:
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at_;
};

/// Delay until an arrived message is noticed by a rank that has received nothing for `silence` seconds. Such a rank
/// sleeps about as long as it has already waited, at most costs.longest_pause.
double notice_delay(const DriverCosts& costs, double silence) {
    return 0.5 * std::clamp(silence, 0.0, costs.longest_pause);
}

class MasterClock {
  public:
    /// Both must outlive the clock. `begin`: when the first member can be handed out. `with_file`: it publishes.
    MasterClock(const DriverCosts& costs, Processors& processors, double begin, bool with_file)
        : costs_(costs),
          processors_(processors),
          now_(begin),
          last_sync_(begin),
          next_publish_(begin + costs.publish_interval),
          with_file_(with_file) {}

    /// Notices an event at `ready` or later; `asleep`: a message, which is found by polling.
    void notice(double ready, bool asleep) {
        tend(ready);
        if (ready > now_) now_ = ready + (asleep ? notice_delay(costs_, ready - now_) : 0.0);
    }

    /// Works for this time.
    void work(double seconds) {
        now_ = processors_.run(now_, seconds);
        busy_ += seconds;
    }

    /// Appends a record of this size to the journal.
    void keep(double bytes) {
        ++members_;
        bytes_ += bytes;
        synced_ = false;
        published_ = false;
    }

    /// Notes a record of this size that another writer has kept.
    void keep_in_part(double bytes) {
        ++members_in_parts_;
        bytes_in_parts_ += bytes;
        synced_ = false;  // a note of it
    }

    /// Syncs everything to the disk.
    void finish() {
        tend(now_);
        work(2 * costs_.sync);  // the last records and the end of the session
    }

    /// Writes the campaign file, alone.
    void publish() {
        work(costs_.read_per_member * members_in_parts_ + costs_.read_per_byte * bytes_in_parts_);
        work(costs_.publish + costs_.publish_per_member * (members_ + members_in_parts_) +
             costs_.publish_per_byte * (bytes_ + bytes_in_parts_));
        published_ = true;
    }

    /// The same by so many writers, a piece each.
    void publish_in_pieces(double writers) {
        const double members = members_ + members_in_parts_;
        const double each = costs_.publish_per_member * members + costs_.publish_per_byte * (bytes_ + bytes_in_parts_);
        work(costs_.order_per_member * members);
        work_together(writers, costs_.publish + each / writers);
        work(costs_.publish + costs_.index + costs_.index_per_piece * writers);
        const double share = costs_.digest_per_member * members / writers;
        work_together(writers, costs_.digest_per_piece * writers + share);
        work(std::max(0.0, costs_.digest_texts * members - share));
        published_ = true;
    }

    double now() const { return now_; }    ///< when the master is free
    double busy() const { return busy_; }  ///< time spent working, s

  private:
    /// Each of them works for this time, and this one waits for the last.
    void work_together(double writers, double seconds) {
        double last = now_;
        for (double k = 0; k < writers; ++k) last = std::max(last, processors_.run(now_, seconds));
        now_ = last;
        busy_ += seconds;
    }

    void tend(double until) {
        const double sync_due = last_sync_ + costs_.sync_interval;
        if (!synced_ && sync_due <= std::max(until, now_)) {
            now_ = std::max(now_, sync_due);
            work(costs_.sync);
            last_sync_ = now_;
            synced_ = true;
        }
        if (with_file_ && !published_ && members_in_parts_ == 0 && next_publish_ <= std::max(until, now_)) {
            now_ = std::max(now_, next_publish_);
            const double begin = now_;
            publish();
            const double took = now_ - begin;
            const double rest = costs_.publish_share > 0 ? took / costs_.publish_share : 0.0;
            next_publish_ = now_ + std::max(costs_.publish_interval, rest);
        }
    }

    const DriverCosts& costs_;
    Processors& processors_;
    double now_;
    double busy_ = 0;
    double last_sync_;
    double next_publish_;
    bool with_file_;
    bool synced_ = true;
    bool published_ = true;
    double members_ = 0;
    double bytes_ = 0;
    double members_in_parts_ = 0;
    double bytes_in_parts_ = 0;
};

enum class Kind : std::uint8_t {
    assigned,  // a member has reached a rank
    computed,  // a core has finished a member
    held,      // a rank has held back its answers for the longest time
    answered,  // the answers have reached the rank that keeps them
    kept,      // the master has heard of them from another writer
};

struct Happening {
    double time = 0;
    std::uint64_t order = 0;  // at equal times, the event scheduled first comes first
    Kind kind = Kind::assigned;
    int rank = 0;
    int number = 0;  // of the member; of the message for `answered` and `kept`
    int attempt = 0;

    friend bool operator>(const Happening& a, const Happening& b) {
        return std::tie(a.time, a.order) > std::tie(b.time, b.order);
    }
};

struct Rank {
    int cores = 0;
    int idle_cores = 0;
    std::deque<Assign> waiting;
    std::vector<Assign> answers;  // not sent yet
    double first_answer = 0;
    double free_at = 0;  // of its message thread
    double busy = 0;     // of it, with records
};

std::vector<MemberTask> tasks_of(std::span<const SimulatedMember> members) {
    std::vector<MemberTask> tasks;
    tasks.reserve(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) tasks.push_back({static_cast<int>(i), members[i].expected_cost});
    return tasks;
}

class Play {
  public:
    Play(std::span<const SimulatedMember> members, const Machine& machine, const DriverCosts& costs, bool with_file)
        : members_(members),
          costs_(costs),
          with_file_(with_file),
          processors_(machine.processors),
          groups_(static_cast<int>(machine.cores_of_rank.size()), machine.writers),
          scheduler_(tasks_of(members)),
          start_up_(costs.start_up + costs.start_up_per_rank * static_cast<double>(machine.cores_of_rank.size() - 1)),
          clock_(costs_, processors_, start_up_, with_file) {
        for (const int cores : machine.cores_of_rank) ranks_.push_back({cores, cores, {}, {}, 0, start_up_, 0});
        for (std::size_t rank = 0; rank < ranks_.size(); ++rank) {
            const int cores = machine.cores_of_rank[rank];
            handle(WorkerJoined{static_cast<int>(rank), cores, cores});
        }
        hand_out();
    }

    Forecast run() {
        while (!happenings_.empty()) {
            const Happening next = happenings_.top();
            happenings_.pop();
            switch (next.kind) {
                case Kind::assigned:
                    assigned(next);
                    break;
                case Kind::computed:
                    computed(next);
                    break;
                case Kind::held:
                    send_answers(next.rank, next.time);
                    break;
                case Kind::answered:
                    answered(next);
                    break;
                case Kind::kept:
                    kept(next);
                    break;
            }
        }
        Forecast forecast;
        forecast.start_up = start_up_;
        forecast.last_member = clock_.now();
        const double span = clock_.now() - start_up_;
        forecast.master_load = span > 0 ? clock_.busy() / span : 0.0;
        forecast.writers = 1 + static_cast<int>(groups_.writers().size());
        for (const int writer : groups_.writers())
            forecast.writer_load = std::max(forecast.writer_load, span > 0 ? rank(writer).busy / span : 0.0);
        // With other writers they pass farewells on, and close their journals.
        if (ranks_.size() > 1) clock_.notice(clock_.now() + (forecast.writers > 1 ? 2 : 1) * farewell(), false);
        clock_.finish();
        forecast.wall_time = clock_.now();
        if (with_file_ && forecast.writers > 1)
            clock_.publish_in_pieces(forecast.writers);
        else
            clock_.publish();
        forecast.file_time = clock_.now() - forecast.wall_time;
        if (with_file_) forecast.wall_time = clock_.now();
        return forecast;
    }

  private:
    Rank& rank(int number) { return ranks_[static_cast<std::size_t>(number)]; }
    const SimulatedMember& member(int number) const { return members_[static_cast<std::size_t>(number)]; }

    void foresee(double time, Kind kind, int at, const Assign& what) {
        happenings_.push({time, order_++, kind, at, what.number, what.attempt});
    }

    // Dismissal and farewell, each noticed with the delay of a waiting rank.
    double farewell() const { return 2 * (costs_.latency + notice_delay(costs_, costs_.longest_pause)); }

    void handle(const Event& event) {
        for (const Command& command : scheduler_.handle(event)) {
            if (const auto* assign = std::get_if<Assign>(&command)) handed_out_[assign->worker].push_back(*assign);
        }
    }

    void hand_out() {
        for (const auto& [worker, assigns] : handed_out_) {
            const auto members = static_cast<double>(assigns.size());
            if (worker == master_rank) {
                clock_.work(members * costs_.own_member / 2);
                for (const Assign& assign : assigns) foresee(clock_.now(), Kind::assigned, master_rank, assign);
                continue;
            }
            clock_.work(costs_.send + members * costs_.assign);
            const double arrival = clock_.now() + costs_.latency;
            const double noticed = arrival + notice_delay(costs_, arrival - rank(worker).free_at);
            for (const Assign& assign : assigns) foresee(noticed, Kind::assigned, worker, assign);
        }
        handed_out_.clear();
    }

    void assigned(const Happening& at) {
        Rank& here = rank(at.rank);
        here.free_at = std::max(here.free_at, at.time);
        here.waiting.push_back({at.rank, at.number, at.attempt});
        begin_next(here, at.time);
    }

    void begin_next(Rank& here, double time) {
        if (here.idle_cores == 0 || here.waiting.empty()) return;
        const Assign next = here.waiting.front();
        here.waiting.pop_front();
        --here.idle_cores;
        const SimulatedMember& what = member(next.number);
        const double work = costs_.member + costs_.member_per_byte * what.packed_bytes;
        foresee(processors_.run(time, work) + what.run_time, Kind::computed, next.worker, next);
    }

    void computed(const Happening& at) {
        Rank& here = rank(at.rank);
        ++here.idle_cores;
        begin_next(here, at.time);
        if (here.answers.empty()) {
            here.first_answer = at.time;
            if (at.rank != master_rank) foresee(at.time + costs_.longest_held_back, Kind::held, at.rank, {});
        }
        here.answers.push_back({at.rank, at.number, at.attempt});
        send_answers(at.rank, at.time);
    }

    void send_answers(int from, double time) {
        Rank& here = rank(from);
        if (here.answers.empty()) return;
        const bool waits = from != master_rank && static_cast<int>(here.waiting.size()) >= here.cores &&
                           static_cast<double>(here.answers.size()) < costs_.most_held_back &&
                           time - here.first_answer < costs_.longest_held_back;
        if (waits) return;
        const int message = next_message_++;
        const auto [sent, is_new] = messages_.emplace(message, std::exchange(here.answers, {}));
        const double bytes = bytes_of(sent->second);
        const auto count = static_cast<double>(sent->second.size());
        double arrival = time;
        if (groups_.writer_of(from) == from && from != master_rank) {
            keep(here, time, message, costs_.own_member / 2 * count + costs_.keep_per_byte * bytes);
            return;
        }
        if (from != master_rank) {
            here.free_at =
                processors_.run(std::max(time, here.free_at), costs_.report * count + costs_.report_per_byte * bytes);
            arrival = here.free_at + costs_.latency + costs_.transfer_per_byte * bytes;
        }
        foresee(arrival, Kind::answered, from, {from, message, 0});
    }

    double bytes_of(std::span<const Assign> answers) const {
        double bytes = 0;
        for (const Assign& one : answers) bytes += member(one.number).record_bytes;
        return bytes;
    }

    /// A writer other than the master takes a message, syncs it, and tells the master of it. `taking`: s.
    void keep(Rank& writer, double time, int message, double taking) {
        const double work = taking + costs_.sync + costs_.send;
        writer.free_at = processors_.run(std::max(time, writer.free_at), work);
        writer.busy += work;
        foresee(writer.free_at + costs_.latency, Kind::kept, master_rank, {master_rank, message, 0});
    }

    void answered(const Happening& at) {
        if (const int writer = groups_.writer_of(at.rank); writer != master_rank) {
            const std::vector<Assign>& answers = messages_.at(at.number);
            Rank& here = rank(writer);
            const double noticed = at.time + notice_delay(costs_, at.time - here.free_at);
            keep(here, noticed, at.number,
                 costs_.receive + costs_.answer * static_cast<double>(answers.size()) +
                     (costs_.receive_per_byte + costs_.keep_per_byte) * bytes_of(answers));
            return;
        }
        const auto message = messages_.extract(at.number);
        const bool own = at.rank == master_rank;
        clock_.notice(at.time, !own);
        if (!own) clock_.work(costs_.receive);
        for (const Assign& one : message.mapped()) {
            const SimulatedMember& what = member(one.number);
            const double taking =
                own ? costs_.own_member / 2 : costs_.answer + costs_.receive_per_byte * what.record_bytes;
            clock_.work(taking + costs_.keep_per_byte * what.record_bytes);
            clock_.keep(what.record_bytes);
            handle(MemberFinished{at.rank, one.number, one.attempt, AttemptEnd::done, what.run_time});
        }
        hand_out();
    }

    void kept(const Happening& at) {
        const auto message = messages_.extract(at.number);
        clock_.notice(at.time, true);
        clock_.work(costs_.receive);
        for (const Assign& one : message.mapped()) {
            const SimulatedMember& what = member(one.number);
            clock_.work(costs_.kept);
            clock_.keep_in_part(what.record_bytes);
            handle(MemberFinished{one.worker, one.number, one.attempt, AttemptEnd::done, what.run_time});
        }
        hand_out();
    }

    std::span<const SimulatedMember> members_;
    const DriverCosts& costs_;
    bool with_file_;
    Processors processors_;
    Groups groups_;
    Scheduler scheduler_;
    double start_up_;
    MasterClock clock_;
    std::vector<Rank> ranks_;
    std::priority_queue<Happening, std::vector<Happening>, std::greater<>> happenings_;
    std::uint64_t order_ = 0;
    std::map<int, std::vector<Assign>> handed_out_;  // by worker, since the last hand_out()
    std::map<int, std::vector<Assign>> messages_;    // of answers, on their way
    int next_message_ = 0;
};

}  // namespace

Machine machine_of(int cores, int ranks) {
    if (ranks < 1 || ranks > cores) {
        throw InputError(
            fmt::format("{} cannot be spread over {}: there must be at least one rank, with at "
                        "least one core each.",
                        counted(cores, "core"), counted(ranks, "rank")));
    }
    Machine machine;
    for (int rank = 0; rank < ranks; ++rank) machine.cores_of_rank.push_back(cores / ranks + (rank < cores % ranks));
    return machine;
}

Forecast simulate(std::span<const SimulatedMember> members, const Machine& machine, const DriverCosts& costs,
                  bool with_file) {
    Forecast forecast = Play(members, machine, costs, with_file).run();
    double cores = 0;
    for (const int of_rank : machine.cores_of_rank) cores += of_rank;
    for (const SimulatedMember& one : members) {
        forecast.run_time += one.run_time;
        forecast.journal_bytes += one.record_bytes;
        forecast.file_bytes += one.file_bytes;
    }
    forecast.efficiency = forecast.wall_time > 0 ? forecast.run_time / (cores * forecast.wall_time) : 1.0;
    return forecast;
}

namespace {

/// With its pieces.
double size_of_file(const std::filesystem::path& journal) {
    auto bytes = static_cast<double>(std::filesystem::file_size(journal));
    for (const int piece : pieces_of(journal))
        bytes += static_cast<double>(std::filesystem::file_size(piece_path(journal, piece)));
    return bytes;
}

MeasuredRun of_journal(const std::filesystem::path& journal, const std::filesystem::path& campaign_file) {
    const JournalContents contents = read_journal(journal);
    MeasuredRun run{read_stored_campaign(contents, journal), {}, size_of_file(journal)};
    for (const std::optional<std::size_t>& record : match_records(run.campaign, contents.members)) {
        const bool done = record && contents.members[*record].done();
        run.wall_time.push_back(done ? contents.members[*record].wall_time : undefined);
    }
    // During a run the file is older than the journal.
    const bool complete = !contents.sessions.empty() && !contents.sessions.back().ended.empty();
    if (complete && std::filesystem::exists(campaign_file))
        run.file_bytes = static_cast<double>(size_with_pieces(campaign_file));
    return run;
}

MeasuredRun of_campaign_file(const std::filesystem::path& path) {
    const CampaignFile file(path);
    const CampaignTable table = read_campaign_file(file);
    MeasuredRun run{file.campaign(), read_wall_times(file), 0, static_cast<double>(size_with_pieces(path))};
    for (std::size_t k = 0; k < run.wall_time.size(); ++k)
        if (table.members.at(k).status != RowStatus::done) run.wall_time[k] = undefined;
    return run;
}

}  // namespace

MeasuredRun read_measured_run(const std::filesystem::path& campaign_file) {
    const std::filesystem::path journal = journal_path(campaign_file);
    if (std::filesystem::exists(journal)) return of_journal(journal, campaign_file);
    if (std::filesystem::exists(campaign_file)) return of_campaign_file(campaign_file);
    throw InputError(fmt::format("there is neither {} nor its journal {}. Give the output file of floes run.",
                                 campaign_file.string(), journal.string()));
}

namespace {

constexpr double peaks_a_separation = 0.57;  // declustered peaks; of the members of configs/table3.toml

constexpr int cores_of_a_node = 64;

/// That many numbers of which none compresses well.
std::vector<double> numbers(std::size_t count) {
    std::vector<double> made(count);
    for (std::size_t k = 0; k < count; ++k) made[k] = std::sin(static_cast<double>(k + 1));
    return made;
}

/// Size of a done member's record without its history, from a record with as many numbers.
double record_bytes(const Scenario& scenario) {
    MemberRecord record;
    record.case_key = std::string(32, '0');
    record.host = "node0000";
    const Analysis& analysis = scenario.analysis;
    record.result.load.segment_maximum = numbers(static_cast<std::size_t>(analysis.segments));
    record.result.levels.resize(analysis.exceedance_levels.size());
    record.result.averaged.resize(scenario.averaging_times().size());
    const double peaks = peaks_a_separation * analysis.window / analysis.peak_separation;
    for (AveragedLoad& one : record.result.averaged) {
        one.segment_maximum = record.result.load.segment_maximum;
        one.peaks = numbers(static_cast<std::size_t>(std::lround(peaks)));
    }
    for (const double number : numbers(static_cast<std::size_t>(scenario.field.floes)))
        record.result.arrangement.push_back({number, 2 * number, 3 * number});
    record.result.load_map = {numbers(LoadMap::heights * LoadMap::angles), numbers(LoadMap::heights * LoadMap::angles),
                              numbers(LoadMap::parts)};
    return static_cast<double>(encode(record).size());
}

/// Sizes of its rows of numbers, packed: those of loads and ice, and those of the motions that the hull has.
struct HistoryBytes {
    double all = 0;
    double deflated = 0;  ///< the compressed part; small sets are left uncompressed

    explicit HistoryBytes(const Scenario& scenario) {
        for (const ArrayOutput& output : array_outputs) {
            if (output.group() != "history" || !scenario.analysis.keep_history) continue;
            const std::size_t numbers = output.axes[0]->places(scenario).size();
            const int repeated = std::max(1, output.held_steps / scenario.analysis.history_stride);
            const double bytes = MemberCosts().history_bytes * static_cast<double>(numbers) / repeated;
            all += bytes;
            if (PackedNumbers{numbers, {}}.deflated()) deflated += bytes;
        }
    }
};

/// Two independent uniform numbers in (0, 1) for a member.
std::array<double, 2> draw(const Campaign& campaign, int number) {
    const PhiloxKey key{static_cast<std::uint32_t>(campaign.seed), static_cast<std::uint32_t>(campaign.seed >> 32)};
    const PhiloxCounter words = philox({static_cast<std::uint32_t>(number), 0, 0, 0}, key);
    return {(words[0] + 0.5) * 0x1p-32, (words[1] + 0.5) * 0x1p-32};
}

/// Log-normal, of mean 1.
double scatter(const std::array<double, 2>& uniform, double variation) {
    const double sigma = std::sqrt(std::log1p(variation * variation));
    const double normal = std::sqrt(-2 * std::log(uniform[0])) * std::cos(2 * std::numbers::pi * uniform[1]);
    return std::exp(sigma * normal - sigma * sigma / 2);
}

std::vector<SimulatedMember> members_of(const Campaign& campaign) {
    std::vector<SimulatedMember> of_case;  // the first of each
    for (const Case& one : campaign.cases) {
        const HistoryBytes history(one.scenario);
        const double other = record_bytes(one.scenario);
        of_case.push_back({.expected_cost = expected_cost(campaign, static_cast<int>(of_case.size())),
                           .record_bytes = history.all + other,
                           .file_bytes = history.all + MemberCosts().file_per_record_byte * other,
                           .packed_bytes = history.deflated});
    }
    std::vector<SimulatedMember> members;
    members.reserve(static_cast<std::size_t>(member_count(campaign)));
    for (int number = 0; number < member_count(campaign); ++number)
        members.push_back(of_case[static_cast<std::size_t>(member_key(campaign, number).case_index)]);
    return members;
}

/// Measured seconds per unit of expected cost, for each case of the run and for all its members.
struct MeasuredRates {
    std::vector<std::vector<double>> of_case;
    std::vector<double> of_all;
};

MeasuredRates rates_of(const MeasuredRun& run) {
    MeasuredRates rates{std::vector<std::vector<double>>(run.campaign.cases.size()), {}};
    for (std::size_t k = 0; k < run.wall_time.size(); ++k) {
        if (std::isnan(run.wall_time[k])) continue;
        const int number = static_cast<int>(k);
        const double rate = run.wall_time[k] / expected_cost(run.campaign, number);
        rates.of_case[static_cast<std::size_t>(member_key(run.campaign, number).case_index)].push_back(rate);
        rates.of_all.push_back(rate);
    }
    return rates;
}

/// The rates from which members of a case draw.
const std::vector<double>& rates_for(const Case& one, const MeasuredRun& run, const MeasuredRates& rates) {
    const auto same = std::ranges::find(run.campaign.cases, one.name, &Case::name);
    if (same == run.campaign.cases.end()) return rates.of_all;
    const auto& own = rates.of_case[static_cast<std::size_t>(same - run.campaign.cases.begin())];
    return own.empty() ? rates.of_all : own;
}

/// Makes sizes as much larger as those of the run are than they would have been planned.
void scale_as_measured(std::vector<SimulatedMember>& members, const MeasuredRun& run) {
    const std::vector<SimulatedMember> planned = members_of(run.campaign);
    double journal = 0;
    double file = MemberCosts().file_bytes;
    for (std::size_t k = 0; k < planned.size(); ++k) {
        if (std::isnan(run.wall_time[k])) continue;
        journal += planned[k].record_bytes;
        file += planned[k].file_bytes;
    }
    const double of_journal = run.journal_bytes > 0 ? run.journal_bytes / journal : run.file_bytes / file;
    const double of_file = run.file_bytes > 0 ? run.file_bytes / file : of_journal;
    for (SimulatedMember& member : members) {
        member.record_bytes *= of_journal;
        member.packed_bytes *= of_journal;
        member.file_bytes *= of_file;
    }
}

/// Whether ice meets an upright wall all round.
bool is_upright(const Shape& shape) {
    constexpr double least = 80 * unit::degree;
    if (!shape.is_of_revolution()) return shape.kind() == HullKind::four_legs;
    return std::abs(shape.wall_angle_above_water() - std::numbers::pi / 2) < std::numbers::pi / 2 - least;
}

/// s per unit of expected cost.
double time_per_unit(const Scenario& scenario, const MemberCosts& costs) {
    switch (scenario.general.solver) {
        case SolverKind::stock:
            return costs.stock_per_unit;
        case SolverKind::lanes:
            return costs.lanes_per_unit;
        case SolverKind::direct:
            break;
    }
    return costs.direct_per_unit * (is_upright(scenario.structure.shape) ? costs.jam : 1);
}

}  // namespace

double expected_run_time(const Campaign& campaign, int case_index) {
    return expected_cost(campaign, case_index) *  // members begin with one of each case
           time_per_unit(campaign.cases[static_cast<std::size_t>(case_index)].scenario, MemberCosts());
}

PlannedMembers expected_members(const Campaign& campaign) {
    const MemberCosts costs;
    PlannedMembers planned{members_of(campaign), costs.source};
    for (std::size_t k = 0; k < planned.members.size(); ++k) {
        const int number = static_cast<int>(k);
        SimulatedMember& member = planned.members[k];
        member.run_time = member.expected_cost * time_per_unit(case_of(campaign, number).scenario, costs) *
                          scatter(draw(campaign, number), costs.variation);
    }
    return planned;
}

std::string stop_forecast(const Campaign& campaign, const CampaignPart& part, int done, double pace, int cores) {
    const int least = std::min(PrecisionStop(campaign).minimum() + campaign.stop.look_ahead, campaign.arrangements);
    const int cases = static_cast<int>(campaign.cases.size());
    double seconds = 0;  // of all members of an arrangement
    for (int number = 0; number < cases; ++number)
        seconds += pace > 0 ? pace * expected_cost(campaign, number) : expected_run_time(campaign, number);
    int own = 0;
    for (int arrangement = 0; arrangement < least; ++arrangement) own += part.has(arrangement) ? 1 : 0;
    const double left = std::max(0.0, own - static_cast<double>(done) / cases);
    const std::string most = campaign.arrangements > least ? fmt::format(", at most {}", campaign.arrangements) : "";
    const std::string of_part = part.of > 1 ? fmt::format(" of all parts, {} of them of this one", own) : "";
    return fmt::format("until {} is known within {:g} %: at least {}{}{}; about {} on {} for {}",
                       what_of(campaign.stop), 100 * campaign.stop.half_width, counted(least, "arrangement"), most,
                       of_part, duration_text(left * seconds / cores), counted(cores, "core"),
                       done > 0 ? "what is left of these" : "these");
}

PlannedMembers measured_members(const Campaign& campaign, const MeasuredRun& run) {
    const MeasuredRates rates = rates_of(run);
    if (rates.of_all.empty()) throw InputError(fmt::format("no member of {} is done yet.", run.campaign.name));
    PlannedMembers planned{
        members_of(campaign),
        fmt::format("{} of {}", counted(std::ssize(rates.of_all), "measured member"), run.campaign.name)};
    scale_as_measured(planned.members, run);
    std::vector<const std::vector<double>*> of_case;
    for (const Case& one : campaign.cases) of_case.push_back(&rates_for(one, run, rates));
    for (std::size_t k = 0; k < planned.members.size(); ++k) {
        const int number = static_cast<int>(k);
        const std::vector<double>& from = *of_case[static_cast<std::size_t>(member_key(campaign, number).case_index)];
        const auto chosen = static_cast<std::size_t>(draw(campaign, number)[0] * static_cast<double>(from.size()));
        planned.members[k].run_time = planned.members[k].expected_cost * from[chosen];
    }
    return planned;
}

void set_record_bytes(PlannedMembers& planned, double bytes) {
    for (SimulatedMember& member : planned.members) {
        member.file_bytes *= bytes / member.record_bytes;
        member.packed_bytes *= bytes / member.record_bytes;
        member.record_bytes = bytes;
    }
}

int usual_ranks(int cores) {
    return (cores + cores_of_a_node - 1) / cores_of_a_node;
}

PlanRow plan_row(std::span<const SimulatedMember> members, const Machine& machine, const DriverCosts& costs,
                 bool with_file) {
    const auto& cores = machine.cores_of_rank;
    PlanRow row{std::accumulate(cores.begin(), cores.end(), 0), static_cast<int>(cores.size()),
                simulate(members, machine, costs, with_file),
                costs.memory_per_member * static_cast<double>(members.size())};
    row.forecast.file_bytes += MemberCosts().file_bytes;
    return row;
}

}  // namespace floes
