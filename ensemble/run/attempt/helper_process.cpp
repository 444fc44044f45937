#include "attempt/helper_process.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "attempt/helper_child.hpp"
#include "campaign/read.hpp"
#include "core/bytes.hpp"
#include "core/error.hpp"

namespace floes {

namespace {

using namespace helper_protocol;
using Clock = std::chrono::steady_clock;

struct Child {
    pid_t pid;
    Descriptor socket;
    std::optional<Clock::time_point> deadline;
    bool ended = false;  // killed by this helper, not reaped yet
    bool at_deadline = false;
};

std::string no_file(const std::string& path) {
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
    return read_campaign({text, "campaign of this run", {}}, no_file);
}

class Server {
  public:
    Server(Descriptor control, const MemberFunction& compute) : control_(std::move(control)), compute_(compute) {
        // Requests to stop a run are for the process that this one serves, which then ends this one.
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGPIPE}) ::signal(signal, SIG_IGN);
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
            ::poll(waits.data(), waits.size(), patience());
            for (std::size_t i = 0; i < children_.size(); ++i) {
                if ((waits[i + 2].revents & POLLHUP) != 0) end(children_[i]);
            }
            end_overdue();
            bury();
            if (waits[0].revents != 0 && !take_request()) return;
        }
    }

  private:
    int patience() const {
        auto wait = std::chrono::milliseconds(-1);
        for (const Child& child : children_) {
            if (child.ended || !child.deadline) continue;
            const auto left = std::max(std::chrono::ceil<std::chrono::milliseconds>(*child.deadline - Clock::now()),
                                       std::chrono::milliseconds(0));
            wait = wait.count() < 0 ? left : std::min(wait, left);
        }
        return static_cast<int>(std::min<std::int64_t>(wait.count(), 1'000'000));
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
            send_frames(child->socket.get(), Frame::ending, std::as_bytes(std::span(&ending, 1)));
            children_.erase(child);
        }
    }

    bool take_request() {
        std::optional<RequestWithDescriptor> taken = receive(control_.get());
        if (!taken) return false;
        if (taken->request.kind == Request::Kind::campaign) {
            campaign_ = read_from(taken->descriptor);
        } else {
            begin(taken->request, std::move(taken->descriptor));
        }
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
            ByteWriter answer;
            answer.u8(static_cast<std::uint8_t>(AnswerKind::sentence));
            answer.text(fmt::format("Cannot create a process for the member ({}).", std::strerror(errno)));
            send_frames(socket.get(), Frame::part, answer.bytes());
            const Ending none;
            send_frames(socket.get(), Frame::ending, std::as_bytes(std::span(&none, 1)));
            return;
        }
        std::optional<Clock::time_point> deadline;
        if (request.limits.deadline > 0) {
            const std::chrono::duration<double> longest(request.limits.deadline);
            deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(longest);
        }
        children_.push_back({pid, std::move(socket), deadline});
    }

    Descriptor control_;
    Descriptor child_ended_;
    const MemberFunction& compute_;
    Campaign campaign_;
    std::vector<Child> children_;
};

}  // namespace

void serve_as_helper(Descriptor control, const MemberFunction& compute) {
    int status = 0;
    try {
        Server(std::move(control), compute).serve();
    } catch (const std::exception&) {
        status = 1;  // the served process notices the closed socket
    }
    ::_exit(status);
}

}  // namespace floes
