#include "attempt/attempt_here.hpp"

#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

#include "core/error.hpp"

namespace floes {

namespace {

/// Asks the member to stop at its deadline, and reports when it does not.
class Deadline {
  public:
    Deadline(const AttemptLimits& limits, std::stop_source member, std::function<void()> stuck)
        : limits_(limits), member_(std::move(member)), stuck_(std::move(stuck)) {
        if (limits.deadline > 0) watch_ = std::jthread([this](const std::stop_token& over) { watch(over); });
    }

    bool passed() const { return passed_; }

  private:
    void watch(const std::stop_token& over) {
        if (!sleep(over, limits_.deadline)) return;
        passed_ = true;
        member_.request_stop();
        if (sleep(over, limits_.grace)) stuck_();
    }

    /// False if the attempt ended first.
    bool sleep(const std::stop_token& over, double seconds) {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, over, std::chrono::duration<double>(seconds), [] { return false; });
        return !over.stop_requested();
    }

    const AttemptLimits& limits_;
    std::stop_source member_;
    std::function<void()> stuck_;
    std::atomic<bool> passed_ = false;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::jthread watch_;  // last, because it uses all of the above
};

std::uint64_t own_peak_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace

MemberResult failed_result(std::string reason) {
    MemberResult result;
    result.status = MemberStatus::failed;
    result.reason = std::move(reason);
    return result;
}

MemberResult checked(MemberResult result) {
    if (result.status == MemberStatus::failed) return result;
    const LoadStatistics& load = result.load;
    for (const double value : {load.mean, load.sd, load.maximum, load.mean_maximum, load.sd_maximum}) {
        if (!std::isfinite(value)) throw MemberFailure("The load statistics of the member are not numbers.");
    }
    return result;
}

Attempted attempt_here(const MemberFunction& compute, const Campaign& campaign, int number, const AttemptLimits& limits,
                       std::stop_token stop, const std::function<void()>& stuck) {
    std::stop_source member;
    const std::stop_callback pass_on(stop, [&member] { member.request_stop(); });
    const Deadline deadline(limits, member, stuck);
    const auto failed = [&](std::string reason) -> Attempted {
        if (stop.stop_requested()) return {};
        if (deadline.passed()) reason = deadline_reason(limits);
        return {failed_result(std::move(reason)), own_peak_memory()};
    };
    try {
        return {checked(compute(campaign, number, member.get_token())), own_peak_memory()};
    } catch (const std::bad_alloc&) {
        return failed(memory_reason(limits));
    } catch (const std::exception& error) {
        return failed(error.what());
    } catch (...) {
        return failed("The member ended with an error without a message.");
    }
}

}  // namespace floes
