#include "run/scheduler.hpp"

#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "core/contract.hpp"

namespace floes {

namespace {

constexpr double time_ahead =
    0.2;  // s; much longer than a message takes, much shorter than the time that a lost rank may cost
constexpr double most_rounds_ahead = 64;

void require(bool holds, const char* what, int which) {
    if (!holds) throw ContractError(fmt::format("scheduler: {} ({})", what, which));
}

}  // namespace

Scheduler::Scheduler(std::vector<MemberTask> tasks, int most_failures) : most_failures_(most_failures) {
    require(most_failures >= 1, "a member must be attempted at least once", most_failures);
    std::sort(tasks.begin(), tasks.end(), [](const MemberTask& a, const MemberTask& b) {
        return std::tuple(a.batch, -a.cost, a.number) < std::tuple(b.batch, -b.cost, b.number);
    });
    tasks_.reserve(tasks.size());
    index_of_.reserve(tasks.size());
    for (const MemberTask& task : tasks) {
        require(std::isfinite(task.cost) && task.cost > 0, "the cost of a member must be positive and finite",
                task.number);
        require(task.failures < most_failures, "a member that failed too often is no task", task.number);
        const bool is_new = index_of_.emplace(task.number, tasks_.size()).second;
        require(is_new, "a member comes twice", task.number);
        pending_.insert(pending_.end(), tasks_.size());
        total_cost_ += task.cost;
        tasks_.push_back({task, task.attempts_made, task.failures, task.suspect, std::nullopt, false});
    }
}

std::vector<Command> Scheduler::handle(const Event& event) {
    std::vector<Command> commands;
    if (const auto* joined = std::get_if<WorkerJoined>(&event)) take(*joined);
    if (const auto* answer = std::get_if<MemberFinished>(&event)) take(*answer, commands);
    if (const auto* left = std::get_if<WorkerLeft>(&event)) remove(left->worker, Leave::farewell);
    if (const auto* lost = std::get_if<WorkerLost>(&event)) remove(lost->worker, Leave::lost);
    if (std::holds_alternative<StopRequested>(event)) stopping_ = true;
    if (const auto* left = std::get_if<TimeLeft>(&event)) affordable_ = left->cost;
    // Workers join one after the other; members given ahead now would be missing on those still to join.
    hand_out(commands, std::holds_alternative<WorkerJoined>(event) ? 0 : rounds());
    dismiss_when_over(commands);
    return commands;
}

void Scheduler::take(const WorkerJoined& event) {
    require(event.cores > 0 && event.prefetch >= 0, "a worker must have at least one core", event.worker);
    const bool is_new = workers_.emplace(event.worker, Worker{event.cores, event.prefetch, {}, false}).second;
    require(is_new, "a worker joins twice", event.worker);
    cores_ += event.cores;
    offer(event.worker);
}

void Scheduler::take(const MemberFinished& event, std::vector<Command>& commands) {
    const auto found = index_of_.find(event.number);
    if (found == index_of_.end() || tasks_[found->second].worker != event.worker ||
        tasks_[found->second].attempts != event.attempt) {
        ++late_answers_;
        return;
    }
    Entry& entry = tasks_[found->second];
    withdraw(event.worker);
    workers_.at(event.worker).held.erase(found->second);
    offer(event.worker);
    entry.worker.reset();
    --assigned_;
    if (event.end == AttemptEnd::failed && ++entry.failures < most_failures_) {
        pending_.insert(found->second);
        commands.push_back(Retry{event.number, event.attempt});
        return;
    }
    entry.done = true;
    ++done_;
    done_cost_ += entry.task.cost;
    if (event.end == AttemptEnd::done) {
        timed_cost_ += entry.task.cost;
        run_time_ += event.run_time;
    }
    commands.push_back(Keep{event.number, event.attempt});
}

void Scheduler::remove(int worker, Leave how) {
    const auto found = workers_.find(worker);
    if (found == workers_.end()) return;  // considered lost before its farewell arrived
    withdraw(worker);
    for (const Index index : found->second.held) {
        tasks_[index].worker.reset();
        if (how == Leave::lost) tasks_[index].suspect = true;
        pending_.insert(index);
        --assigned_;
    }
    cores_ -= found->second.cores;
    workers_.erase(found);
}

int Scheduler::rounds() const {
    if (pending_.empty() || timed_cost_ <= 0) return 1;
    const double expected = run_time_ / timed_cost_ * tasks_[*pending_.begin()].task.cost;
    return static_cast<int>(std::clamp(std::ceil(time_ahead / expected), 1.0, most_rounds_ahead));
}

std::set<Scheduler::Index>::iterator Scheduler::next(int level) const {
    const double longest = affordable_ / (2 + std::max(level, -1));
    return std::ranges::find_if(pending_, [&](Index index) { return tasks_[index].task.cost <= longest; });
}

void Scheduler::hand_out(std::vector<Command>& commands, int most_rounds) {
    if (stopping_) return;
    while (!pending_.empty() && !room_.empty()) {
        const auto [level, number] = *room_.begin();
        if (level >= most_rounds || (level >= 0 && pending() < (level + 2) * cores_)) return;
        const auto chosen = next(level);
        if (chosen == pending_.end()) return;
        withdraw(number);
        const Index index = *chosen;
        pending_.erase(chosen);
        Entry& entry = tasks_[index];
        entry.worker = number;
        ++entry.attempts;
        ++assigned_;
        workers_.at(number).held.insert(index);
        offer(number);
        commands.push_back(Assign{number, entry.task.number, entry.attempts, entry.suspect});
    }
}

void Scheduler::dismiss_when_over(std::vector<Command>& commands) {
    if (!stopping_ && done_ < total()) return;
    for (auto& [number, worker] : workers_) {
        if (worker.dismissed) continue;
        worker.dismissed = true;
        commands.push_back(Dismiss{number});
    }
}

void Scheduler::offer(int worker) {
    const Worker& w = workers_.at(worker);
    running_ += w.running();
    if (w.takes_more()) room_.emplace(w.level(), worker);
}

void Scheduler::withdraw(int worker) {
    const Worker& w = workers_.at(worker);
    running_ -= w.running();
    room_.erase({w.level(), worker});
}

void Scheduler::check_invariants() const {
    int done = 0;
    int assigned = 0;
    int cores = 0;
    for (Index i = 0; i < tasks_.size(); ++i) {
        const Entry& entry = tasks_[i];
        const int number = entry.task.number;
        const int states = (pending_.contains(i) ? 1 : 0) + (entry.worker ? 1 : 0) + (entry.done ? 1 : 0);
        require(states == 1, "a member must be exactly one of pending, assigned and done", number);
        require(!entry.worker || (workers_.contains(*entry.worker) && workers_.at(*entry.worker).held.contains(i)),
                "an assigned member must be held by its worker", number);
        require(pending_.contains(i) || entry.attempts > entry.task.attempts_made,
                "a member that left the queue must have been attempted", number);
        require(entry.done || entry.failures < most_failures_, "a member that failed too often must be set aside",
                number);
        require(entry.attempts - entry.task.attempts_made >= entry.failures - entry.task.failures,
                "a failure must have been attempted", number);
        done += entry.done ? 1 : 0;
        assigned += entry.worker ? 1 : 0;
    }
    int held = 0;
    int running = 0;
    for (const auto& [number, worker] : workers_) {
        const int ahead = static_cast<int>(worker.held.size()) - worker.cores;
        require(ahead <= static_cast<int>(most_rounds_ahead) * worker.prefetch, "a worker holds more than it may",
                number);
        require(room_.contains({worker.level(), number}) == worker.takes_more(),
                "the list of workers with room is wrong", number);
        require(stopping_ || next(-1) == pending_.end() || worker.level() >= 0,
                "a core is idle though a member could be computed", number);
        held += static_cast<int>(worker.held.size());
        running += worker.running();
        cores += worker.cores;
    }
    require(running == running_, "the number of running members is wrong", running_);
    require(room_.size() <= workers_.size(), "the list of workers with room is too long",
            static_cast<int>(room_.size()));
    require(done == done_ && assigned == assigned_ && held == assigned_, "the counts are wrong", done_);
    require(cores == cores_, "the number of cores is wrong", cores_);
}

}  // namespace floes
