#include "attempt/limits.hpp"

#include <sys/wait.h>

#include <csignal>
#include <cstring>

#include <fmt/format.h>

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

}  // namespace floes
