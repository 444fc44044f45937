#include "run/simulate.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "run/link.hpp"
#include "run/writer.hpp"
#include "schedule/scheduler.hpp"

// Measured by
//
//     bench/dispatch.py build/release/bench/floes_dispatch dispatch.json
//
// on two cores of an otherwise idle virtual machine (Intel Xeon, family 6 model 207; Open MPI 4.1.4, HDF5 1.10.8):
// processor times, the smaller of two rounds. docs/performance.md compares the resulting plan with real runs.
// Publishing, reading and `kept` are of later builds. Not measured but taken from experience: start_up_per_rank,
// publish, latency, transfer_per_byte, and the variation of members. Run times of members: configs/table3.toml, 94 s of
// processor time for three members, 234 s for one with the stock solver. Bytes: 120 members of configs/smoke.toml, and
// 12 of configs/moored_platform.toml, whose histories take 6.4 a number; what breaks is not foreseen.
// Memory: what 200,001 members of tests/faults take more than 50,001, at most at any moment.

namespace floes {

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
        .sync_interval = 0.9,  // this one and those for publishing as in driver/upkeep_timer.cpp
        .publish = 0.02,
        .publish_per_member = 22e-6,
        .publish_per_byte = 1.5e-9,
        .publish_interval = 300,
        .publish_share = 1.0 / 20,
        .read_per_member = 7.7e-6,
        .read_per_byte = 0.18e-9,
        .memory_per_member = 290,
        .member = 24e-6,
        .member_per_byte = 21e-9,
        .report = 11e-6,
        .report_per_byte = 1.1e-9,
        .longest_held_back = 0.05,  // as in run/worker.hpp; the next as in run/worker.cpp
        .most_held_back = 256,
        .latency = 5e-6,  // between ranks of one machine
        .transfer_per_byte = 0.2e-9,
        .longest_pause = 10e-3,  // as in driver/pause.hpp
    };
}

MemberCosts measured_member_costs() {
    return {
        .direct_per_unit = 2.4e-6,
        .lanes_per_unit = 1.6e-6,
        .stock_per_unit = 12e-6,
        .jam = 4.5,
        .variation = 0.05,
        .history_bytes = 7,
        .file_per_record_byte = 0.8,
        .file_bytes = 165e3,
        .source =
            "the expected cost of each member, times the measured time per unit on a Xeon of 2023 (AVX-512); "
            "members of 27 configurations took 0.7 to 2.7 times as long. --from takes those of members that ran",
    };
}

}  // namespace floes
namespace floes {

Processors::Processors(int count) {
    for (int i = 0; i < count; ++i) free_at_.push(0.0);
}

double Processors::run(double ready, double work) {
    if (free_at_.empty() || work <= 0) return ready + work;
    const double end = std::max(ready, free_at_.top()) + work;
    free_at_.pop();
    free_at_.push(end);
    return end;
}

double notice_delay(const DriverCosts& costs, double silence) {
    return 0.5 * std::clamp(silence, 0.0, costs.longest_pause);
}

MasterClock::MasterClock(const DriverCosts& costs, Processors& processors, double begin, bool with_file)
    : costs_(costs),
      processors_(processors),
      now_(begin),
      last_sync_(begin),
      next_publish_(begin + costs.publish_interval),
      with_file_(with_file) {}

void MasterClock::notice(double ready, bool asleep) {
    tend(ready);
    if (ready > now_) now_ = ready + (asleep ? notice_delay(costs_, ready - now_) : 0.0);
}

void MasterClock::work(double seconds) {
    now_ = processors_.run(now_, seconds);
    busy_ += seconds;
}

void MasterClock::keep(double bytes) {
    ++members_;
    bytes_ += bytes;
    synced_ = false;
    published_ = false;
}

void MasterClock::keep_in_part(double bytes) {
    ++members_in_parts_;
    bytes_in_parts_ += bytes;
    synced_ = false;  // a note of it
}

void MasterClock::finish() {
    tend(now_);
    work(2 * costs_.sync);  // the last records and the end of the session
}

void MasterClock::tend(double until) {
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

void MasterClock::publish() {
    work(costs_.read_per_member * members_in_parts_ + costs_.read_per_byte * bytes_in_parts_);
    work(costs_.publish + costs_.publish_per_member * (members_ + members_in_parts_) +
         costs_.publish_per_byte * (bytes_ + bytes_in_parts_));
    published_ = true;
}

namespace {

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
};

struct Later {
    bool operator()(const Happening& a, const Happening& b) const {
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

    /// A writer other than the master takes a message, and tells the master of it.
    void keep(Rank& writer, double time, int message, double work) {
        writer.free_at = processors_.run(std::max(time, writer.free_at), work + costs_.send);
        writer.busy += work + costs_.send;
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
    std::priority_queue<Happening, std::vector<Happening>, Later> happenings_;
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

}  // namespace floes
