#include "run/attempt.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/bytes.hpp"
#include "member/array_output.hpp"
#include "member/run_member.hpp"
#include "run/signals.hpp"

namespace floes {

namespace {

std::string deadline_reason(const AttemptLimits& limits) {
    return fmt::format("The member was not done after {} s (run.member_deadline_s) and was stopped.", limits.deadline);
}

std::string memory_reason(const AttemptLimits& limits) {
    if (limits.memory == 0) return "There was not enough memory for the member.";
    return fmt::format("The member needed more than the {} MiB of memory that run.member_memory_MiB allows.",
                       static_cast<double>(limits.memory) / (1024.0 * 1024.0));
}

/// The result of a member that failed for `reason`.
MemberResult failed_result(std::string reason) {
    MemberResult result;
    result.status = MemberStatus::failed;
    result.reason = std::move(reason);
    return result;
}

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

Attempted attempt_at(const MemberFunction& compute, const Campaign& campaign, int number, const AttemptLimits& limits,
                     const Attempting& attempting, const std::function<bool()>& is_late) {
    const auto failed = [&](std::string reason) -> Attempted {
        if (attempting.is_put_off()) return {};
        if (is_late()) reason = deadline_reason(limits);
        return {failed_result(std::move(reason)), own_peak_memory()};
    };
    try {
        return {checked(compute(campaign, number, attempting)), own_peak_memory()};
    } catch (const std::bad_alloc&) {
        return failed(memory_reason(limits));
    } catch (const std::exception& error) {
        return failed(error.what());
    } catch (...) {
        return failed("The member ended with an error without a message.");
    }
}

}  // namespace

AttemptLimits limits_of(const RunRules& rules) {
    constexpr double longest = 1e9;  // s, which every clock holds
    return {.deadline = std::min(rules.member_deadline, longest),
            .memory = static_cast<std::uint64_t>(rules.member_memory)};
}

std::string reason_of(const Ending& ending, const AttemptLimits& limits) {
    if (ending.at_deadline) return deadline_reason(limits);
    if (!WIFSIGNALED(ending.wait_status)) {
        return fmt::format("The process of the member exited with status {} without a result.",
                           WEXITSTATUS(ending.wait_status));
    }
    const int signal = WTERMSIG(ending.wait_status);
    const char* meaning = ::sigdescr_np(signal);
    return fmt::format("The process of the member was killed by {} ({}){}.", signal_name(signal),
                       meaning == nullptr ? "unknown" : meaning,
                       signal == SIGKILL ? ": by a user, or by the system because memory ran out" : "");
}

MemberResult compute_member(const Campaign& campaign, int number, std::stop_token stop) {
    const auto [case_index, arrangement] = member_key(campaign, number);
    return run_member(case_of(campaign, number).scenario, arrangement_seed(campaign, case_index),
                      static_cast<std::uint32_t>(arrangement), std::move(stop));
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
                       std::stop_token stop, const std::function<void()>& stuck,
                       const std::function<void(const MemberProgress&)>& tell) {
    std::stop_source member;
    const std::stop_callback pass_on(stop, [&member] { member.request_stop(); });
    Attempting attempting(member.get_token());
    attempting.is_put_off = [&stop] { return stop.stop_requested(); };
    attempting.tell = tell;
    const Deadline deadline(limits, member, stuck);
    return attempt_at(compute, campaign, number, limits, attempting, [&deadline] { return deadline.passed(); });
}

namespace {

using Clock = std::chrono::steady_clock;

Clock::time_point in_seconds(double seconds) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// How long poll() may wait, in ms; -1: without limit.
int until(const std::optional<Clock::time_point>& end) {
    if (!end) return -1;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(*end - Clock::now()).count();
    return static_cast<int>(std::clamp<std::int64_t>(left, 0, 1'000'000));
}

// The protocol between a process, its helper and the helper's children.
//
// Requests go over the control socket, each with a descriptor: of a file with the campaign's text, or of the socket of
// one attempt. The answer comes over that socket in frames: from time to time how far the member is; then parts of a
// result or of a sentence from the child; then, after the child's end, the Ending from the helper. If the Ending is
// missing, the helper is gone.
//
// A process that puts its member off says nothing more over the socket, and the child hears that nothing comes. If it
// closes the socket, the helper kills the child.

struct Request {
    enum class Kind : std::int32_t { campaign, attempt } kind = Kind::attempt;
    std::int32_t number = 0;
    AttemptLimits limits;
};

enum class AnswerKind : std::uint8_t { result, sentence, no_process };

enum class PacketKind : std::uint8_t { part, ending, progress };  // the first byte of each packet
constexpr std::size_t most_bytes_in_a_frame = 32768;

/// A message with one request and space for one descriptor.
struct Envelope {
    explicit Envelope(Request& request) : part{&request, sizeof request} {
        message.msg_iov = &part;
        message.msg_iovlen = 1;
        message.msg_control = control.data();
        message.msg_controllen = control.size();
    }

    iovec part;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    msghdr message{};
};

constexpr const char* helper_is_gone = "The helper process that runs members is gone.";

/// Throws HelperLost if the other end is closed.
void post(int control, Request request, int descriptor) {
    Envelope envelope(request);
    cmsghdr* attached = CMSG_FIRSTHDR(&envelope.message);
    attached->cmsg_level = SOL_SOCKET;
    attached->cmsg_type = SCM_RIGHTS;
    attached->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(attached), &descriptor, sizeof descriptor);
    while (::sendmsg(control, &envelope.message, MSG_NOSIGNAL) < 0)
        if (errno != EINTR) throw HelperLost(helper_is_gone);
}

/// The next request and its descriptor; empty if the other end is closed.
std::optional<std::pair<Request, Descriptor>> next_request(int control) {
    Request request;
    Envelope envelope(request);
    ssize_t size = 0;
    do {
        size = ::recvmsg(control, &envelope.message, MSG_CMSG_CLOEXEC);
    } while (size < 0 && errno == EINTR);
    const cmsghdr* attached = CMSG_FIRSTHDR(&envelope.message);
    if (size != static_cast<ssize_t>(sizeof request) || attached == nullptr) return std::nullopt;
    int descriptor = -1;
    std::memcpy(&descriptor, CMSG_DATA(attached), sizeof descriptor);
    return std::pair(request, Descriptor(descriptor));
}

/// Sends the bytes in as many frames as needed; gives up if the other end is closed.
void send_frames(int socket, PacketKind kind, std::span<const std::byte> bytes) {
    std::vector<std::byte> packet;
    while (!bytes.empty()) {
        const auto part = bytes.first(std::min(bytes.size(), most_bytes_in_a_frame));
        packet.assign(1, static_cast<std::byte>(kind));
        packet.insert(packet.end(), part.begin(), part.end());
        const ssize_t sent = ::send(socket, packet.data(), packet.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR) return;
        if (sent > 0) bytes = bytes.subspan(part.size());
    }
}

// The child of a helper: one member, one process.

/// Bytes of address space of this process; 0 if unknown.
std::uint64_t mapped_bytes() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
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

Bytes answer_with(AnswerKind kind, const std::string& text) {
    ByteWriter answer;
    answer.u8(static_cast<std::uint8_t>(kind));
    answer.text(text);
    return answer.take();
}

/// Empty: put off.
Bytes compute_answer(const Request& request, const Campaign& campaign, const MemberFunction& compute,
                     const Descriptor& socket) {
    // The helper enforces the deadline, so that it also ends a member that does not poll.
    const AttemptLimits limits{.deadline = 0, .memory = request.limits.memory};
    Attempting attempting;
    // The other end says nothing more then.
    attempting.is_put_off = [&socket, next_look = Clock::now(), put_off = false]() mutable {
        constexpr std::chrono::milliseconds interval{100};
        const Clock::time_point now = Clock::now();
        if (put_off || now < next_look) return put_off;
        next_look = now + interval;
        pollfd look{socket.get(), POLLRDHUP, 0};
        put_off = ::poll(&look, 1, 0) > 0;
        return put_off;
    };
    attempting.tell = [&socket](const MemberProgress& progress) {
        send_frames(socket.get(), PacketKind::progress, std::as_bytes(std::span(&progress, 1)));
    };
    const Attempted attempt = attempt_at(compute, campaign, request.number, limits, attempting, [] { return false; });
    if (!attempt.result) return {};
    try {
        ByteWriter answer;
        answer.u8(static_cast<std::uint8_t>(AnswerKind::result));
        write(answer, *attempt.result);
        write_arrays(answer, *attempt.result);
        return answer.take();
    } catch (const std::bad_alloc&) {
        return answer_with(AnswerKind::sentence, memory_reason(limits));
    }
}

/// Computes the member in this process, a fork of the process `helper`, and exits. Never returns.
[[noreturn]] void compute_and_leave(const Request& request, const Descriptor& socket, const Campaign& campaign,
                                    const MemberFunction& compute, pid_t helper) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != helper) ::_exit(0);
    reset_signals();
    limit_memory(request.limits.memory);
    const Bytes answer = compute_answer(request, campaign, compute, socket);
    send_frames(socket.get(), PacketKind::part, answer);
    ::_exit(0);
}

// The loop of the helper: a single thread that sleeps until a request, the end of a child, a closed socket, or a
// deadline.

struct Child {
    pid_t pid;
    Descriptor socket;
    std::optional<Clock::time_point> deadline;
    bool ended = false;  // killed by this helper, not reaped yet
    bool at_deadline = false;
};

std::string no_file_for_a_helper(const std::string& path) {
    throw RunError(fmt::format("The campaign given to a helper refers to the file {}.", path));
}

Campaign read_from(const Descriptor& file) {
    struct stat facts {};
    ::fstat(file.get(), &facts);
    std::string text(static_cast<std::size_t>(facts.st_size), '\0');
    for (std::size_t got = 0; got < text.size();) {
        const ssize_t more = ::pread(file.get(), text.data() + got, text.size() - got, static_cast<off_t>(got));
        if (more <= 0) break;
        got += static_cast<std::size_t>(more);
    }
    return read_campaign({text, "campaign of this run", {}}, no_file_for_a_helper);
}

class Server {
  public:
    Server(Descriptor control, const MemberFunction& compute) : control_(std::move(control)), compute_(compute) {
        // Requests to stop a run are for the process that this one serves, which then ends this one.
        for (const int signal : stop_signals) ::signal(signal, SIG_IGN);
        ::signal(SIGPIPE, SIG_IGN);
        sigset_t child_ended;
        ::sigemptyset(&child_ended);
        ::sigaddset(&child_ended, SIGCHLD);
        ::sigprocmask(SIG_BLOCK, &child_ended, nullptr);
        child_ended_ = Descriptor(::signalfd(-1, &child_ended, SFD_CLOEXEC | SFD_NONBLOCK));
    }

    void serve() {
        while (true) {
            std::vector<pollfd> waits{{control_.get(), POLLIN, 0}, {child_ended_.get(), POLLIN, 0}};
            // A child whose parent hung up has been killed: wait for its end, not for the same hang-up again.
            for (const Child& child : children_) waits.push_back({child.ended ? -1 : child.socket.get(), 0, 0});
            ::poll(waits.data(), waits.size(), until(next_deadline()));
            for (std::size_t i = 0; i < children_.size(); ++i) {
                if ((waits[i + 2].revents & POLLHUP) != 0) end(children_[i]);
            }
            end_overdue();
            bury();
            if (waits[0].revents != 0 && !take_request()) return;
        }
    }

  private:
    std::optional<Clock::time_point> next_deadline() const {
        std::optional<Clock::time_point> next;
        for (const Child& child : children_)
            if (!child.ended && child.deadline && (!next || *child.deadline < *next)) next = child.deadline;
        return next;
    }

    static void end(Child& child) {
        child.ended = true;
        ::kill(child.pid, SIGKILL);
    }

    void end_overdue() {
        for (Child& child : children_) {
            if (child.ended || !child.deadline || Clock::now() < *child.deadline) continue;
            child.at_deadline = true;
            end(child);
        }
    }

    void bury() {
        std::array<signalfd_siginfo, 16> noticed;
        while (::read(child_ended_.get(), noticed.data(), sizeof noticed) > 0) {
        }
        int status = 0;
        rusage usage{};
        for (pid_t pid = 0; (pid = ::wait4(-1, &status, WNOHANG, &usage)) > 0;) {
            const auto child =
                std::find_if(children_.begin(), children_.end(), [&](const Child& c) { return c.pid == pid; });
            if (child == children_.end()) continue;
            const Ending ending{status, child->at_deadline, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};
            send_frames(child->socket.get(), PacketKind::ending, std::as_bytes(std::span(&ending, 1)));
            children_.erase(child);
        }
    }

    bool take_request() {
        std::optional<std::pair<Request, Descriptor>> taken = next_request(control_.get());
        if (!taken) return false;
        auto& [request, descriptor] = *taken;
        if (request.kind == Request::Kind::campaign)
            campaign_ = read_from(descriptor);
        else
            begin(request, std::move(descriptor));
        return true;
    }

    void begin(const Request& request, Descriptor socket) {
        const pid_t helper = ::getpid();
        const pid_t pid = ::fork();
        if (pid == 0) {
            children_.clear();  // otherwise the others' sockets stay open as long as this child lives
            control_.close();
            child_ended_.close();
            compute_and_leave(request, socket, campaign_, compute_, helper);
        }
        if (pid < 0) {
            const std::string why = fmt::format("Cannot create a process for the member ({}).", std::strerror(errno));
            send_frames(socket.get(), PacketKind::part, answer_with(AnswerKind::no_process, why));
            const Ending none;
            send_frames(socket.get(), PacketKind::ending, std::as_bytes(std::span(&none, 1)));
            return;
        }
        std::optional<Clock::time_point> deadline;
        if (request.limits.deadline > 0) deadline = in_seconds(request.limits.deadline);
        children_.push_back({pid, std::move(socket), deadline});
    }

    Descriptor control_;
    Descriptor child_ended_;
    const MemberFunction& compute_;
    Campaign campaign_;
    std::vector<Child> children_;
};

/// Serves requests until the control socket is closed. Never returns.
[[noreturn]] void serve_as_helper(Descriptor control, const MemberFunction& compute) {
    int status = 0;
    try {
        Server(std::move(control), compute).serve();
    } catch (const std::exception&) {
        status = 1;  // the served process notices the closed socket
    }
    ::_exit(status);
}

[[noreturn]] void refuse(const char* what) {
    throw RunError(fmt::format("Cannot create a process for members ({}: {}).", what, std::strerror(errno)));
}

std::pair<Descriptor, Descriptor> socket_pair(int type) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0) refuse("socketpair");
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// An in-memory file with the text.
Descriptor file_of(const std::string& text) {
    Descriptor file(::memfd_create("floes-campaign", MFD_CLOEXEC));
    if (file.get() < 0) refuse("memfd_create");
    for (std::size_t written = 0; written < text.size();) {
        const ssize_t more = ::write(file.get(), text.data() + written, text.size() - written);
        if (more < 0) refuse("write");
        written += static_cast<std::size_t>(more);
    }
    return file;
}

struct Answered {
    Bytes bytes;                   // from the child
    std::optional<Ending> ending;  // from the helper; empty if it is gone or silent
    bool closed = false;
};

/// Collects everything until the ending, until the other end is closed, or until end(), which is asked twice a second.
Answered listen(int socket, const std::function<std::optional<Clock::time_point>()>& end,
                const std::function<void(const MemberProgress&)>& tell) {
    Answered answer;
    std::vector<std::byte> packet(most_bytes_in_a_frame + 1);
    constexpr int interval = 500;  // ms
    while (!answer.ending && !answer.closed) {
        pollfd wait{socket, POLLIN, 0};
        const std::optional<Clock::time_point> last = end();
        const int longest = until(last);
        if (::poll(&wait, 1, longest < 0 ? interval : std::min(longest, interval)) <= 0) {
            if (last && Clock::now() >= *last) break;
            continue;
        }
        const ssize_t size = ::recv(socket, packet.data(), packet.size(), 0);
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) {
            answer.closed = true;
        } else if (static_cast<PacketKind>(packet[0]) == PacketKind::ending) {
            std::memcpy(&answer.ending.emplace(), packet.data() + 1, sizeof(Ending));
        } else if (static_cast<PacketKind>(packet[0]) == PacketKind::progress) {
            MemberProgress progress;
            std::memcpy(&progress, packet.data() + 1, sizeof progress);
            if (tell) tell(progress);
        } else {
            answer.bytes.insert(answer.bytes.end(), packet.begin() + 1, packet.begin() + size);
        }
    }
    return answer;
}

/// The result from what the child wrote and how it ended.
MemberResult understand(std::span<const std::byte> written, const Ending& ending, const AttemptLimits& limits) {
    const bool orderly = !ending.at_deadline && WIFEXITED(ending.wait_status) && WEXITSTATUS(ending.wait_status) == 0;
    if (!orderly || written.empty()) return failed_result(reason_of(ending, limits));
    ByteReader in(written);
    const auto kind = static_cast<AnswerKind>(in.u8());
    if (kind == AnswerKind::no_process) throw RunError(in.text());  // the machine's fault, and not the member's
    if (kind == AnswerKind::sentence) return failed_result(in.text());
    MemberResult result = read_member_result(in);
    read_arrays(in, result);
    return result;
}

}  // namespace

Helper::Helper(MemberFunction compute, double patience) : patience_(patience) {
    auto [mine, helpers] = socket_pair(SOCK_SEQPACKET);
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ < 0) refuse("fork");
    if (pid_ == 0) {
        mine.close();
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(0);  // it died before prctl() took effect
        serve_as_helper(std::move(helpers), compute);
    }
    control_ = std::move(mine);
}

Helper::~Helper() {
    ::kill(pid_, SIGKILL);  // its children die with it
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

void Helper::prepare(const Campaign& campaign) {
    const Descriptor text = file_of(write_campaign(campaign));
    post(control_.get(), {Request::Kind::campaign, 0, {}}, text.get());
}

Attempted Helper::run(int number, const AttemptLimits& limits, const std::stop_token& stop,
                      const std::function<void(const MemberProgress&)>& tell) const {
    auto [mine, childs] = socket_pair(SOCK_SEQPACKET);
    post(control_.get(), {Request::Kind::attempt, number, limits}, childs.get());
    childs.close();
    std::optional<Clock::time_point> end;
    if (limits.deadline > 0) end = in_seconds(limits.deadline + limits.grace);
    const std::stop_callback put_off(
        stop, [&socket = mine, saves = patience_ > 0] { ::shutdown(socket.get(), saves ? SHUT_WR : SHUT_RDWR); });
    bool waits = false;
    const auto last = [&] {
        if (stop.stop_requested() && !std::exchange(waits, true)) end = in_seconds(patience_);
        return end;
    };
    const Answered answer = listen(mine.get(), last, tell);
    if (stop.stop_requested() && answer.bytes.empty()) return {};
    if (answer.ending) return {understand(answer.bytes, *answer.ending, limits), answer.ending->peak_memory};
    if (stop.stop_requested()) return {};
    throw HelperLost(answer.closed ? helper_is_gone : "The helper process that runs members does not answer.");
}

}  // namespace floes
