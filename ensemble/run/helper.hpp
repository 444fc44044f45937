#pragma once
// The protocol between a process, its helper and the helper's children. Only for the files of these three.
//
// Requests go over the control socket, each with a descriptor: of a file with the campaign's text, or of the socket of
// one attempt. The answer comes over that socket in frames: first parts of a result or of a sentence from the child;
// then, after the child's end, the Ending from the helper. If the Ending is missing, the helper is gone.

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>

#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "run/attempt.hpp"

namespace floes::helper_protocol {

struct Request {
    enum class Kind : std::int32_t { campaign, attempt } kind = Kind::attempt;
    std::int32_t number = 0;
    AttemptLimits limits;
};

struct RequestWithDescriptor {
    Request request;
    Descriptor descriptor;
};

enum class AnswerKind : std::uint8_t { result, sentence };

enum class PacketKind : std::uint8_t { part, ending };  // the first byte of each packet
constexpr std::size_t most_bytes_in_a_frame = 32768;

/// Sends the bytes in as many frames as needed; gives up if the other end is closed.
void send_frames(int socket, PacketKind kind, std::span<const std::byte> bytes);

/// False if the other end is closed.
bool send(int control, const Request& request, int descriptor);
/// The next request; empty if the other end is closed.
std::optional<RequestWithDescriptor> receive(int control);

}  // namespace floes::helper_protocol

namespace floes {

// The loop of the helper: a single thread that sleeps until a request, the end of a child, a closed socket, or a
// deadline.

/// Serves requests until the control socket is closed. Never returns.
[[noreturn]] void serve_as_helper(Descriptor control, const MemberFunction& compute);

// The child of a helper: one member, one process.

/// Computes the member in this process, a fork of the process `helper`, and exits. Never returns.
[[noreturn]] void compute_and_leave(const helper_protocol::Request& request, const Descriptor& socket,
                                    const Campaign& campaign, const MemberFunction& compute, pid_t helper);

// Members in isolated processes. A process with threads, or with MPI started, must not fork: the child would inherit
// locks that nobody releases. So a helper is forked before either starts, stays small and single-threaded, and forks a
// child for each attempt on request; the result comes back over a socket. A member that crashes, hangs or exhausts
// memory takes down only its child, and the helper reports how it ended.
//
//     Helper helper(compute);             // first thing in main()
//     helper.prepare(campaign);
//     Attempted attempt = helper.run(number, limits, stop);   // from any thread
//
// The memory limit is RLIMIT_AS, counted beyond what the helper has mapped. A child has one thread and maps hardly
// anything that it does not use, so the address space is a fair measure. The limit acts at once, without polling, and
// mostly shows as a failed allocation, which can be distinguished from a crash.
//
// Children die with their helper, the helper dies with the process that started it (PR_SET_PDEATHSIG).

/// The helper is gone or does not answer: this process can run no more isolated members.
class HelperLost : public RunError {
  public:
    using RunError::RunError;
};

class Helper {
  public:
    /// Forks the helper, which will compute members with `compute`. Must be called from the main thread while it is the
    /// only one, before MPI is started. Throws RunError if the system refuses.
    explicit Helper(MemberFunction compute);
    Helper(const Helper&) = delete;
    Helper& operator=(const Helper&) = delete;
    /// Ends the helper and its children.
    ~Helper();

    /// Sets the campaign of all following run() calls.
    void prepare(const Campaign& campaign);

    /// One attempt at the member in an isolated process: the result, a failed result with the reason of the crash, or
    /// none if `stop` is requested first. Throws HelperLost.
    Attempted run(int number, const AttemptLimits& limits, const std::stop_token& stop) const;

    pid_t pid() const { return pid_; }

  private:
    Descriptor control_;
    pid_t pid_ = -1;
};

}  // namespace floes
