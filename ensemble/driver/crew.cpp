#include "driver/crew.hpp"

#include <exception>
#include <utility>

namespace floes {

namespace {

constexpr unsigned slots_for_the_owner = 0;  // the owner waits and never computes

MemberResult failure(std::string reason) {
    MemberResult result;
    result.status = MemberStatus::failed;
    result.reason = std::move(reason);
    return result;
}

}  // namespace

Crew::Crew(const Campaign& campaign, MemberFunction compute, int threads)
    : campaign_(campaign),
      compute_(std::move(compute)),
      limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads) + 1),
      arena_(threads, slots_for_the_owner) {}

Crew::~Crew() {
    stop_.request_stop();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return unfinished_ == 0; });
}

void Crew::begin(Assignment assignment) {
    ++held_;
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(assignment);
        ++unfinished_;
    }
    // The thread sanitizer does not see how TBB hands a task over, so the task carries nothing that could race.
    arena_.enqueue([this]() __attribute__((no_sanitize("thread"))) { execute_next(); });
}

void Crew::execute_next() {
    std::unique_lock lock(mutex_);
    const Assignment assignment = waiting_.front();
    waiting_.pop_front();
    lock.unlock();
    Outcome outcome = execute(assignment);
    lock.lock();  // until the last touch of *this
    outcomes_.push_back(std::move(outcome));
    --unfinished_;
    changed_.notify_all();
}

Outcome Crew::execute(Assignment assignment) const {
    if (stop_.stop_requested()) return {assignment, std::nullopt};
    const auto begin = std::chrono::steady_clock::now();
    MemberResult result;
    try {
        result = compute_(campaign_, assignment.number, stop_.get_token());
    } catch (const std::exception& error) {
        if (stop_.stop_requested()) return {assignment, std::nullopt};
        result = failure(error.what());
    } catch (...) {
        result = failure("The member ended with an error that says nothing.");
    }
    result.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return {assignment, std::move(result)};
}

void Crew::abandon() {
    stop_.request_stop();
}

std::vector<Outcome> Crew::take() {
    std::vector<Outcome> taken;
    {
        const std::lock_guard lock(mutex_);
        taken.swap(outcomes_);
    }
    held_ -= static_cast<int>(taken.size());
    return taken;
}

void Crew::wait(std::chrono::microseconds longest) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest, [this] { return !outcomes_.empty(); });
}

}  // namespace floes
