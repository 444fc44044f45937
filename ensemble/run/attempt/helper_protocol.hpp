#pragma once
// The protocol between a process, its helper and the helper's children. Only for the files of these three.
//
// Requests go over the control socket, each with a descriptor: of a file with the campaign's text, or of the socket of
// one attempt. The answer comes over that socket in frames: first parts of a result or of a sentence from the child;
// then, after the child's end, the Ending from the helper. If the Ending is missing, the helper is gone.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "attempt/limits.hpp"
#include "core/descriptor.hpp"

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

enum class Frame : std::uint8_t { part, ending };  // the first byte of each packet
constexpr std::size_t most_bytes_in_a_frame = 32768;

/// Sends the bytes in as many frames as needed; gives up if the other end is closed.
void send_frames(int socket, Frame kind, std::span<const std::byte> bytes);

/// False if the other end is closed.
bool send(int control, const Request& request, int descriptor);
/// The next request; empty if the other end is closed.
std::optional<RequestWithDescriptor> receive(int control);

}  // namespace floes::helper_protocol
