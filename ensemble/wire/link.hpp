#pragma once
// The link between ranks: whole messages, in order from each sender. The same alone (LocalLink) and on MPI (MpiLink).
//
//     std::unique_ptr<Link> link = open_link();  // wire/open_link.hpp
//     link->send(0, Tag::hello, bytes);
//     while (std::optional<Message> message = link->poll()) …

#include <cstddef>
#include <optional>
#include <vector>

#include "wire/topology.hpp"

namespace floes {

/// Every kind of message between ranks. What stands in each: driver/messages.hpp.
enum class Tag : int {
    // master -> worker
    campaign = 1,  ///< the resolved configuration; the first message a worker gets
    assign = 2,    ///< compute this member
    dismiss = 3,   ///< abandon what you hold and say farewell
    leave = 4,     ///< the run is over; end with this exit status
    part = 5,      ///< ranks are missing: leave, when told to, without waiting for anybody; see Link::abandon()
    // worker -> master
    hello = 11,         ///< what the worker understood of the campaign, and its cores
    answer = 12,        ///< a finished member
    farewell = 13,      ///< every answer of this worker has been sent
    stop_request = 14,  ///< the worker got a signal to stop
    trouble = 15,       ///< the worker cannot go on; a sentence
    // either way
    alive = 21,  ///< nothing but a sign of life
};

struct Message {
    int from = 0;  ///< rank
    Tag tag = Tag::hello;
    std::vector<std::byte> bytes;
};

class Link {
  public:
    Link() = default;
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;
    virtual ~Link() = default;

    virtual int rank() const = 0;  ///< of this process, from 0
    virtual int size() const = 0;  ///< number of ranks, at least 1
    virtual const Topology& topology() const = 0;

    /// Sends to a rank (also to itself). Returns at once; the link owns the bytes until they are gone. Messages leave
    /// only while poll() is called now and then. Throws RunError when the message cannot be sent.
    virtual void send(int to, Tag tag, std::vector<std::byte> bytes) = 0;

    /// The next message that has arrived whole; nothing when there is none yet. Never waits.
    virtual std::optional<Message> poll() = 0;

    /// The rank is lost, or leaves without this one: nothing more is sent to it, and this process does not wait for it
    /// when it ends.
    virtual void abandon(int rank) = 0;

    /// Bytes are on their way, in or out: it is worth polling again soon.
    virtual bool moving() const = 0;
};

}  // namespace floes
