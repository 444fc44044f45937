#pragma once
// The link between ranks: whole messages, in order for each sender. LocalLink serves a single process, MpiLink uses
// MPI.
//
//     std::unique_ptr<Link> link = open_link();  // wire/open_link.hpp
//     link->send(0, Tag::hello, bytes);
//     while (std::optional<Message> message = link->poll()) …

#include <cstddef>
#include <optional>
#include <vector>

#include "wire/topology.hpp"

namespace floes {

/// All kinds of messages between ranks. Their contents: driver/messages.hpp.
enum class Tag : int {
    // master -> worker
    campaign = 1,  ///< the resolved configuration; the first message a worker gets
    assign = 2,    ///< compute this member
    dismiss = 3,   ///< abandon all members and say farewell
    leave = 4,     ///< the run is over; end with this exit status
    part = 5,      ///< ranks are lost: when told to leave, wait for no other rank; see Link::abandon()
    // worker -> master
    hello = 11,         ///< the campaign's fingerprint as read by the worker, and its cores
    answer = 12,        ///< a finished member
    farewell = 13,      ///< every answer of this worker has been sent
    stop_request = 14,  ///< the worker received a signal to stop
    trouble = 15,       ///< the worker cannot continue; a sentence
    // both directions
    alive = 21,  ///< a sign of life
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

    /// Sends to a rank (also to itself). Returns at once; the link owns the bytes until they are sent. Messages make
    /// progress only in calls of poll(). Throws RunError if the message cannot be sent.
    virtual void send(int to, Tag tag, std::vector<std::byte> bytes) = 0;

    /// The next message that has fully arrived; empty if there is none. Never waits.
    virtual std::optional<Message> poll() = 0;

    /// To be called when the rank is lost or leaves without this one. Nothing more is sent to it, and this process does
    /// not wait for it at its own end.
    virtual void abandon(int rank) = 0;

    /// True while a transfer is in progress, so that polling again soon is worthwhile.
    virtual bool moving() const = 0;
};

}  // namespace floes
