#include "attempt/helper_child.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <new>
#include <string>

#include "attempt/attempt_here.hpp"
#include "member/result_bytes.hpp"

namespace floes {

namespace {

using namespace helper_protocol;

/// Bytes of address space of this process; 0 if unknown.
std::uint64_t mapped_bytes() {
    unsigned long pages = 0;
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (file == nullptr) return 0;
    const bool known = std::fscanf(file, "%lu", &pages) == 1;
    std::fclose(file);
    return known ? pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

void limit_memory(std::uint64_t bytes) {
    if (bytes == 0) return;
    const rlim_t all = mapped_bytes() + bytes;
    const rlimit limit{all, all};
    ::setrlimit(RLIMIT_AS, &limit);
}

/// Restores the default handlers, except for requests to stop, which are not meant for this process. A crash leaves no
/// core file.
void reset_signals() {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGCHLD}) ::signal(signal, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
}

Bytes sentence(const std::string& text) {
    ByteWriter answer;
    answer.u8(static_cast<std::uint8_t>(AnswerKind::sentence));
    answer.text(text);
    return answer.take();
}

Bytes compute_answer(const Request& request, const Campaign& campaign, const MemberFunction& compute) {
    // The helper enforces the deadline, so that it also ends a member that does not poll.
    const AttemptLimits limits{.deadline = 0, .memory = request.limits.memory};
    const Attempted attempt = attempt_here(compute, campaign, request.number, limits, {}, [] {});
    try {
        ByteWriter answer;
        answer.u8(static_cast<std::uint8_t>(AnswerKind::result));
        write(answer, *attempt.result);
        write_arrays(answer, *attempt.result);
        return answer.take();
    } catch (const std::bad_alloc&) {
        return sentence(memory_reason(limits));
    }
}

}  // namespace

void compute_and_leave(const Request& request, const Descriptor& socket, const Campaign& campaign,
                       const MemberFunction& compute, pid_t helper) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != helper) ::_exit(0);
    reset_signals();
    limit_memory(request.limits.memory);
    const Bytes answer = compute_answer(request, campaign, compute);
    send_frames(socket.get(), Frame::part, answer);
    ::_exit(0);
}

}  // namespace floes
