#include "attempt/helper_protocol.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

namespace floes::helper_protocol {

namespace {

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

}  // namespace

bool send(int control, const Request& request, int descriptor) {
    Request copy = request;
    Envelope envelope(copy);
    cmsghdr* attached = CMSG_FIRSTHDR(&envelope.message);
    attached->cmsg_level = SOL_SOCKET;
    attached->cmsg_type = SCM_RIGHTS;
    attached->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(attached), &descriptor, sizeof descriptor);
    while (true) {
        if (::sendmsg(control, &envelope.message, MSG_NOSIGNAL) >= 0) return true;
        if (errno != EINTR) return false;
    }
}

std::optional<RequestWithDescriptor> receive(int control) {
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
    return RequestWithDescriptor{request, Descriptor(descriptor)};
}

void send_frames(int socket, Frame kind, std::span<const std::byte> bytes) {
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

}  // namespace floes::helper_protocol
