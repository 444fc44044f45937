#pragma once
// The threads of this process that compute. A crew has some of its own, or shares them with the crews of other runs in
// the same process.

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>

namespace floes {

/// What executes tasks for a crew.
class Cores {
  public:
    Cores() = default;
    Cores(const Cores&) = delete;
    Cores& operator=(const Cores&) = delete;
    virtual ~Cores() = default;

    /// Executes the task, which must not throw: the lowest turn first, and of one turn in the order of the calls.
    virtual void begin(std::int64_t turn, std::function<void()> task) = 0;
};

class CorePool final : public Cores {
  public:
    /// Computes `threads` tasks at a time, >= 1.
    explicit CorePool(int threads);

    int threads() const { return threads_; }

    /// On a free thread, or as soon as one is free. The pool must outlive its tasks, but none is touched by the pool
    /// after it has returned.
    void begin(std::int64_t turn, std::function<void()> task) override;

    /// The same for a task that may throw; returns when it has returned, or throws what it threw. Not to be called from
    /// a task.
    void execute(std::int64_t turn, const std::function<void()>& task);

  private:
    void execute_next();

    int threads_;
    std::mutex mutex_;
    std::multimap<std::int64_t, std::function<void()>> waiting_;  // by turn; equal ones stay in order

    tbb::global_control limit_;  // without it TBB never starts more threads than there are cores
    tbb::task_arena arena_;
};

/// The part of a run in a pool that several runs share. Its members go before those of runs with a higher turn.
struct SharedCores {
    Cores* pool = nullptr;  ///< nullptr: the run has threads of its own
    std::int64_t turn = 0;
};

}  // namespace floes
