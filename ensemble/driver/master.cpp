#include "driver/master.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {

namespace {

constexpr int self = 0;

}  // namespace

Master::Master(const Campaign& campaign, Link& link, Recorder& recorder, Progress& progress, const StopSignals& signals,
               const MemberFunction& compute, const Muster& mustered)
    : campaign_(campaign),
      link_(link),
      recorder_(recorder),
      progress_(progress),
      signals_(signals),
      scheduler_(recorder.tasks()),
      scribe_(campaign, self),
      crew_(campaign, compute, mustered.hellos.at(self).cores),
      pause_(pause_between_polls(link.size())) {
    if (mustered.stop_requested) request_stop("another rank");
    for (int rank = 0; rank < link.size(); ++rank) {
        const int cores = mustered.hellos.at(static_cast<std::size_t>(rank)).cores;
        handle(WorkerJoined{rank, cores, cores});  // one ahead for each core
    }
}

void Master::run() {
    while (!scheduler_.finished()) {
        advance();
        crew_.wait(pause_.next());
    }
    progress_.show_last(state());
}

std::string Master::stopped_by() const {
    return scheduler_.done() < scheduler_.total() ? stop_reason_ : "";
}

void Master::advance() {
    bool something = link_.moving();
    while (const auto message = link_.poll()) {
        receive(*message);
        something = true;
    }
    for (Outcome& outcome : crew_.take()) {
        const int number = outcome.assignment.number;
        if (outcome.result) finished(self, number, scribe_.record(outcome.assignment, std::move(*outcome.result)));
        something = true;
    }
    if (dismissed_ && !left_ && crew_.held() == 0) {
        left_ = true;
        handle(WorkerLost{self});
    }
    if (signals_.received() != 0) request_stop(signal_name(signals_.received()));
    const auto now = std::chrono::steady_clock::now();
    if (const std::string trouble = recorder_.tend(now); !trouble.empty()) progress_.say(trouble);
    progress_.show(state(), now);
    if (something) pause_.something_happened();
}

void Master::receive(const Message& message) {
    switch (message.tag) {
        case Tag::answer: {
            const Answer answer = decode_answer(message.bytes);
            finished(message.from, answer.number, answer.record);
            return;
        }
        case Tag::farewell:
            handle(WorkerLost{message.from});
            return;
        case Tag::stop_request:
            request_stop(fmt::format("a signal to rank {}", message.from));
            return;
        case Tag::trouble:
            throw RunError(fmt::format("Rank {}: {}", message.from, decode_text(message.bytes)));
        default:
            throw RunError(fmt::format("The master cannot understand message {} of rank {}.",
                                       static_cast<int>(message.tag), message.from));
    }
}

void Master::finished(int worker, int number, const MemberRecord& record) {
    handle(MemberFinished{worker, number, record.attempt}, &record);
    end_when_precise();
}

void Master::request_stop(const std::string& reason) {
    if (scheduler_.stopping()) return;
    stop_reason_ = reason;
    handle(StopRequested{});
}

void Master::end_when_precise() {
    if (recorder_.precise() && !scheduler_.stopping()) handle(StopRequested{});
}

void Master::handle(const Event& event, const MemberRecord* record) {
    for (const Command& command : scheduler_.handle(event)) {
        if (const auto* assign = std::get_if<Assign>(&command)) obey(*assign);
        if (const auto* dismiss = std::get_if<Dismiss>(&command)) obey(*dismiss);
        if (const auto* keep = std::get_if<Record>(&command)) {
            recorder_.keep(*record);
            if (record->result.status == MemberStatus::failed) report_failure(keep->number, *record);
        }
    }
}

void Master::obey(const Assign& command) {
    const Assignment assignment{command.number, command.attempt};
    if (command.worker == self) {
        crew_.begin(assignment);
    } else {
        link_.send(command.worker, Tag::assign, encode(assignment));
    }
}

void Master::obey(const Dismiss& command) {
    if (command.worker == self) {
        crew_.abandon();
        dismissed_ = true;
    } else {
        link_.send(command.worker, Tag::dismiss, {});
    }
}

void Master::report_failure(int number, const MemberRecord& record) {
    const MemberKey key = member_key(campaign_, number);
    const std::string& name = campaign_.cases[static_cast<std::size_t>(key.case_index)].name;
    progress_.say(fmt::format("member {} (case {}, arrangement {}) failed and is set aside: {}", number, name,
                              key.arrangement, record.result.reason));
}

ProgressState Master::state() const {
    ProgressState state;
    state.total = recorder_.total();
    state.done = recorder_.done();
    state.failed = recorder_.failed();
    state.running = scheduler_.running();
    if (const auto& precision = recorder_.precision()) {
        state.half_width = precision->achieved();
        state.half_width_target = precision->target();
        state.in_order = precision->arrangements();
    }
    state.finished_now = scheduler_.done();
    state.elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    state.finished_cost = scheduler_.done_cost();
    state.remaining_cost = scheduler_.remaining_cost();
    return state;
}

}  // namespace floes
