#include "run/core_pool.hpp"

#include <future>
#include <memory>
#include <utility>

namespace floes {

constexpr unsigned slots_for_the_owner = 0;  // who begins tasks only waits

CorePool::CorePool(int threads)
    : threads_(threads),
      limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads) + 1),
      arena_(threads, slots_for_the_owner) {}

void CorePool::begin(std::int64_t turn, std::function<void()> task) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.emplace(turn, std::move(task));
    }
    // The thread sanitizer cannot see how TBB hands over a task, so the task carries no data that could race.
    arena_.enqueue([this]() __attribute__((no_sanitize("thread"))) { execute_next(); });
}

void CorePool::execute(std::int64_t turn, const std::function<void()>& task) {
    const auto told = std::make_shared<std::packaged_task<void()>>(task);  // outlives the end of this call
    std::future<void> over = told->get_future();
    begin(turn, [told] { (*told)(); });
    over.get();
}

void CorePool::execute_next() {
    std::unique_lock lock(mutex_);
    const auto node = waiting_.extract(waiting_.begin());
    lock.unlock();
    node.mapped()();
}

}  // namespace floes
