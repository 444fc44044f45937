#include "run/master.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {

namespace {

constexpr int self = 0;

/// The reasons of all attempts, in order; identical ones are given once.
std::string reason_of_all(std::span<const std::string> reasons) {
    if (reasons.size() == 1) return reasons[0];
    const bool all_equal =
        std::ranges::all_of(reasons, [&](const std::string& reason) { return reason == reasons[0]; });
    if (all_equal) return fmt::format("{} ({} attempts)", reasons[0], reasons.size());
    std::string all;
    for (std::size_t i = 0; i < reasons.size(); ++i) {
        all += fmt::format("{}attempt {}: {}", i == 0 ? "" : " ", i + 1, reasons[i]);
    }
    return all;
}

}  // namespace

Master::Master(const Campaign& campaign, const MasterTools& tools, const CrewSetup& setup, const Muster& mustered,
               const MasterLimits& limits)
    : campaign_(campaign),
      link_(tools.link),
      groups_(tools.groups),
      recorder_(tools.recorder),
      progress_(tools.progress),
      signals_(tools.signals),
      walltime_(limits.walltime),
      scheduler_(recorder_.tally().found().tasks, campaign.run.attempts),
      scribe_(campaign, self),
      crew_(campaign, setup),
      pause_(pause_between_polls(link_.size())),
      ranks_(link_, mustered, limits.patience, begin_),
      pace_(recorder_.tally().found().pace) {
    for (const int writer : groups_.writers()) open_pieces_.insert(writer);
    if (mustered.stop_requested) request_stop("another rank");
    tell_time_left();
    for (int rank = 0; rank < link_.size(); ++rank) {
        const int cores = mustered.hellos.at(static_cast<std::size_t>(rank)).cores;
        handle(WorkerJoined{rank, cores, cores});  // one member ahead for each core
    }
}

void Master::run() {
    while (!scheduler_.finished()) {
        advance();
        crew_.wait(pause_.next());
    }
    close_pieces();
    progress_.show_last(state());
}

std::string Master::stopped_by() const {
    return scheduler_.done() < scheduler_.total() ? stop_reason_ : "";
}

void Master::advance() {
    bool something = link_.moving();
    while (const auto message = link_.poll()) {
        ranks_.heard(message->from);
        receive(*message);
        something = true;
    }
    for (Outcome& outcome : crew_.take()) {
        const int number = outcome.assignment.number;
        if (outcome.result) finished(self, number, scribe_.record(std::move(outcome)));
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
    const auto now = std::chrono::steady_clock::now();
    watch_ranks(now);
    watch_time(now);
    hand_out();
    if (const std::string trouble = recorder_.tend(now); !trouble.empty()) progress_.say(trouble);
    progress_.show(state(), now);
    if (something) pause_.something_happened();
}

void Master::receive(const Message& message) {
    switch (message.tag) {
        case Tag::answer:
            for (Answer& answer : decode_answers(message.bytes)) {
                finished(message.from, answer.number, std::move(answer.record));
            }
            return;
        case Tag::kept:
            for (const Kept& kept : decode_kept(message.bytes)) finished_in_piece(kept);
            return;
        case Tag::farewell:
            handle(WorkerLeft{message.bytes.empty() ? message.from : decode_status(message.bytes)});
            return;
        case Tag::closed:
            open_pieces_.erase(message.from);
            return;
        case Tag::alive:
            return;
        case Tag::stop_request:
            request_stop(fmt::format("a signal to rank {}", message.from));
            return;
        case Tag::trouble:
            throw RunError(fmt::format("Rank {}: {}", message.from, decode_text(message.bytes)));
        default:
            throw RunError(fmt::format("The master cannot interpret message {} of rank {}.",
                                       static_cast<int>(message.tag), message.from));
    }
}

void Master::finished(int worker, int number, MemberRecord record) {
    const auto end = record.result.status == MemberStatus::done ? AttemptEnd::done : AttemptEnd::failed;
    if (end == AttemptEnd::done) note_pace(number, record.result.wall_time);
    tell_time_left();
    handle(MemberFinished{worker, number, record.attempt, end, record.result.wall_time}, &record);
    end_when_precise();
}

void Master::finished_in_piece(const Kept& kept) {
    note_pace(kept.number, kept.wall_time);
    tell_time_left();
    handle(MemberFinished{kept.worker, kept.number, kept.attempt, AttemptEnd::done, kept.wall_time}, nullptr, &kept);
    end_when_precise();
}

void Master::note_pace(int number, double wall_time) {
    pace_ = std::max(pace_, wall_time / expected_cost(campaign_, number));
}

void Master::tell_time_left() {
    const std::optional<double> left = walltime_.left(std::chrono::steady_clock::now());
    if (left && pace_ > 0) handle(TimeLeft{*left / pace_});
}

void Master::watch_ranks(std::chrono::steady_clock::time_point now) {
    for (const auto& [rank, silence] : ranks_.watch(now)) {
        progress_.say(fmt::format("rank {} has been silent for {:.0f} s: others compute its members", rank, silence));
        lose(rank);
    }
}

/// Without its writer a group can bring its members nowhere.
void Master::lose(int rank) {
    handle(WorkerLost{rank});
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
void Master::close_pieces() {
    for (const int writer : open_pieces_) link_.send(writer, Tag::close, {});
    while (!open_pieces_.empty()) {
        while (const auto message = link_.poll()) {
            ranks_.heard(message->from);
            receive(*message);
        }
        watch_ranks(std::chrono::steady_clock::now());
        if (!open_pieces_.empty()) std::this_thread::sleep_for(pause_.next());
    }
}

void Master::watch_time(std::chrono::steady_clock::time_point now) {
    const std::optional<double> left = walltime_.left(now);
    if (!left) return;
    if (*left <= 0) request_stop("the end of the time limit");
    if (scheduler_.assigned() == 0 && scheduler_.pending() > 0) {
        request_stop("the end of the time limit, before which no further member could finish,");
    }
}

void Master::give_up(const CrewTrouble& trouble) {
    if (trouble.stuck) {
        recorder_.sync();
        progress_.say(fmt::format("{} The run ends immediately; --resume computes that member in an isolated process",
                                  trouble.sentence));
        std::_Exit(exit_stopped);
    }
    progress_.say(fmt::format("rank 0 stopped computing: {}", trouble.sentence));
    crew_.abandon();
    dismissed_ = true;
}

void Master::request_stop(const std::string& reason) {
    if (scheduler_.stopping()) return;
    stop_reason_ = reason;
    handle(StopRequested{});
}

void Master::end_when_precise() {
    if (recorder_.tally().precise() && !scheduler_.stopping()) handle(StopRequested{});
}

void Master::handle(const Event& event, MemberRecord* record, const Kept* in_piece) {
    for (const Command& command : scheduler_.handle(event)) {
        if (const auto* assign = std::get_if<Assign>(&command)) {
            handed_out_[assign->worker].push_back({assign->number, assign->attempt, assign->apart});
        }
        if (const auto* dismiss = std::get_if<Dismiss>(&command)) obey(*dismiss);
        if (const auto* retry = std::get_if<Retry>(&command)) note_failure(*retry, *record);
        if (const auto* kept = std::get_if<Keep>(&command)) {
            if (in_piece == nullptr) keep(kept->number, *record);
            if (in_piece != nullptr) keep(*in_piece);
        }
    }
}

/// Sends the latest assignments, in one message to each worker. The journal notes an attempt before it begins.
void Master::hand_out() {
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

void Master::obey(const Dismiss& command) {
    hand_out();
    if (command.worker == self) {
        crew_.abandon();
        dismissed_ = true;
    } else {
        link_.send(command.worker, Tag::dismiss, {});
    }
}

std::string Master::name_of(int number) const {
    const MemberKey key = member_key(campaign_, number);
    const std::string& name = campaign_.cases[static_cast<std::size_t>(key.case_index)].name;
    return fmt::format("member {} (case {}, arrangement {})", number, name, key.arrangement);
}

void Master::note_failure(const Retry& retry, const MemberRecord& record) {
    failures_[retry.number].push_back(record.result.reason);
    progress_.say(fmt::format("{} failed and will be retried: {}", name_of(retry.number), record.result.reason));
}

void Master::keep(int number, MemberRecord& record) {
    if (record.result.status == MemberStatus::failed) {
        std::vector<std::string> reasons = failures_[number];
        reasons.push_back(record.result.reason);
        record.result.reason = reason_of_all(reasons);
        progress_.say(fmt::format("{} failed and was set aside: {}", name_of(number), record.result.reason));
    }
    failures_.erase(number);
    recorder_.keep(record);
}

void Master::keep(const Kept& in_piece) {
    failures_.erase(in_piece.number);
    recorder_.kept_in_piece(in_piece.number, in_piece.record);
}

ProgressState Master::state() const {
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
    state.elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    state.finished_cost = scheduler_.done_cost();
    state.remaining_cost = scheduler_.remaining_cost();
    return state;
}

}  // namespace floes
