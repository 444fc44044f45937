#pragma once
// What goes between a process, its helper and the helper's children, for the files of these three alone.
//
// Requests travel over the control socket, each with a descriptor: of a file with the campaign's text, or of the socket
// of one attempt. Over that comes the answer in frames: from the child parts of the bytes of a result or of a sentence,
// and after the child's end, from the helper, the Ending. What has no Ending comes from a helper that is gone.

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

enum class Answer : std::uint8_t { result, sentence };

enum class Frame : std::uint8_t { part, ending };  // the first byte of each packet
constexpr std::size_t most_bytes_in_a_frame = 32768;

/// Sends the bytes in as many frames as they need; gives up when nobody listens any more.
void send_frames(int socket, Frame kind, std::span<const std::byte> bytes);

/// False when nobody is at the other end.
bool send(int control, const Request& request, int descriptor);
/// The next request; nothing when the other end is closed.
std::optional<RequestWithDescriptor> receive(int control);

}  // namespace floes::helper_protocol
