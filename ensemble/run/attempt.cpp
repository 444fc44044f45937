#include "run/attempt.hpp"

#include <sys/resource.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "member/run_member.hpp"

namespace floes {

AttemptLimits limits_of(const RunRules& rules) {
    return {.deadline = rules.member_deadline, .memory = static_cast<std::uint64_t>(rules.member_memory)};
}

std::string deadline_reason(const AttemptLimits& limits) {
    return fmt::format("The member was not done after {} s (run.member_deadline_s) and was stopped.", limits.deadline);
}

std::string memory_reason(const AttemptLimits& limits) {
    if (limits.memory == 0) return "There was not enough memory for the member.";
    return fmt::format("The member needed more than the {} MiB of memory that run.member_memory_MiB allows.",
                       static_cast<double>(limits.memory) / (1024.0 * 1024.0));
}

std::string reason_of(const Ending& ending, const AttemptLimits& limits) {
    if (ending.at_deadline) return deadline_reason(limits);
    if (!WIFSIGNALED(ending.wait_status)) {
        return fmt::format("The process of the member exited with status {} without a result.",
                           WEXITSTATUS(ending.wait_status));
    }
    const int signal = WTERMSIG(ending.wait_status);
    const char* name = ::sigabbrev_np(signal);
    const char* meaning = ::sigdescr_np(signal);
    return fmt::format("The process of the member was killed by SIG{} ({}){}.", name == nullptr ? "?" : name,
                       meaning == nullptr ? "unknown" : meaning,
                       signal == SIGKILL ? ": by a user, or by the system because memory ran out" : "");
}

MemberResult compute_member(const Campaign& campaign, int number, std::stop_token stop) {
    const MemberKey key = member_key(campaign, number);
    const Scenario& scenario = campaign.cases[static_cast<std::size_t>(key.case_index)].scenario;
    return run_member(scenario, arrangement_seed(campaign, key.case_index), static_cast<std::uint32_t>(key.arrangement),
                      std::move(stop));
}

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
