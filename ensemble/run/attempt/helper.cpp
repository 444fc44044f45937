#include "attempt/helper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "attempt/helper_process.hpp"
#include "attempt/helper_protocol.hpp"
#include "campaign/write.hpp"
#include "member/result_bytes.hpp"

namespace floes {

namespace {

using helper_protocol::Request;
using Clock = std::chrono::steady_clock;

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

/// How long poll() may wait, in ms; -1: without limit.
int until(const std::optional<Clock::time_point>& end) {
    if (!end) return -1;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(*end - Clock::now()).count();
    return static_cast<int>(std::clamp<std::int64_t>(left, 0, 1'000'000));
}

struct Answered {
    Bytes bytes;                   // from the child
    std::optional<Ending> ending;  // from the helper; empty if it is gone or silent
    bool closed = false;
};

/// Collects everything until the ending, until the other end is closed, or until `end`.
Answered listen(int socket, const std::optional<Clock::time_point>& end) {
    Answered answer;
    std::vector<std::byte> packet(helper_protocol::most_bytes_in_a_frame + 1);
    while (!answer.ending && !answer.closed) {
        pollfd wait{socket, POLLIN, 0};
        if (::poll(&wait, 1, until(end)) <= 0) {
            if (end && Clock::now() >= *end) break;
            continue;
        }
        const ssize_t size = ::recv(socket, packet.data(), packet.size(), 0);
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) {
            answer.closed = true;
        } else if (static_cast<helper_protocol::Frame>(packet[0]) == helper_protocol::Frame::ending) {
            std::memcpy(&answer.ending.emplace(), packet.data() + 1, sizeof(Ending));
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
    if (static_cast<helper_protocol::AnswerKind>(in.u8()) == helper_protocol::AnswerKind::sentence) {
        return failed_result(in.text());
    }
    MemberResult result = read_member_result(in);
    read_arrays(in, result);
    return result;
}

}  // namespace

Helper::Helper(MemberFunction compute) {
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
    if (!helper_protocol::send(control_.get(), {Request::Kind::campaign, 0, {}}, text.get())) {
        throw HelperLost("The helper process that runs members is gone.");
    }
}

Attempted Helper::run(int number, const AttemptLimits& limits, const std::stop_token& stop) const {
    auto [mine, childs] = socket_pair(SOCK_SEQPACKET);
    if (!helper_protocol::send(control_.get(), {Request::Kind::attempt, number, limits}, childs.get())) {
        throw HelperLost("The helper process that runs members is gone.");
    }
    childs.close();
    std::optional<Clock::time_point> end;
    if (limits.deadline > 0) {
        const std::chrono::duration<double> longest(limits.deadline + limits.grace);
        end = Clock::now() + std::chrono::duration_cast<Clock::duration>(longest);
    }
    const std::stop_callback hang_up(stop, [&socket = mine] { ::shutdown(socket.get(), SHUT_RDWR); });
    const Answered answer = listen(mine.get(), end);
    if (answer.ending) return {understand(answer.bytes, *answer.ending, limits), answer.ending->peak_memory};
    if (stop.stop_requested()) return {};
    throw HelperLost(answer.closed ? "The helper process that runs members is gone."
                                   : "The helper process that runs members does not answer.");
}

}  // namespace floes
