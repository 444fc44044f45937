#pragma once
// The link between ranks: whole messages, in order from each sender. The same alone (LocalLink) and on MPI (MpiLink).
//
//     std::unique_ptr<Link> link = open_link();
//     link->send(0, Tag::hello, bytes);
//     while (std::optional<Message> message = link->poll()) …

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wire/tags.hpp"
#include "wire/topology.hpp"

namespace floes {

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

/// True when mpirun or srun started this process as one of its ranks. Looks at the environment only.
bool started_by_mpi();

/// The link that fits how this process was started: MPI under mpirun or srun, else local without touching MPI.
std::unique_ptr<Link> open_link();

/// Name and version of the MPI library, e.g. "Open MPI v4.1.4". Needs no MPI to be started.
std::string library_version();

}  // namespace floes
