#pragma once
// The link between ranks: whole messages over MPI or within one process; and the cores of a rank.

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace floes {

/// The cores that a process may run on, one bit each, in the system's numbering.
using CoreMask = std::array<std::uint64_t, 16>;

int count_cores(const CoreMask& mask);

/// The mask of the calling process; all online cores if the system has more cores than fit.
CoreMask affinity_of_this_process();

/// Cores of the rank masks[mine]: those in its mask, divided evenly among the ranks of the node with the same mask (the
/// first ones get the remainder), at least 1.
int share_of_cores(std::span<const CoreMask> masks, std::size_t mine);

/// Cores and neighbours of a rank.
struct Topology {
    int cores = 1;        ///< to be used by this rank
    int bound_cores = 1;  ///< in its affinity mask
    int node_cores = 1;   ///< online on its node
    int node_ranks = 1;   ///< ranks on its node
    int rank_cores = 1;   ///< in the masks of these ranks together
};

/// `masks`: those of all ranks on the node; masks[mine] is this rank's.
Topology make_topology(std::span<const CoreMask> masks, std::size_t mine);

/// A sentence for the user if the only rank of a node is bound to some of its cores, or if more ranks than cores share
/// them; otherwise empty.
std::string binding_remark(const Topology& topology);

// The link between ranks: whole messages, in order for each sender. LocalLink serves a single process, another one uses
// MPI.
//
//     std::unique_ptr<Link> link = open_link();
//     link->send(0, Tag::hello, bytes);
//     while (std::optional<Message> message = link->poll()) …

inline constexpr int master_rank = 0;

/// All kinds of messages between ranks. Their contents: run/messages.hpp.
enum class Tag : int {
    // master -> worker
    campaign = 1,  ///< the resolved configuration; the first message a worker gets
    assign = 2,    ///< compute this member
    dismiss = 3,   ///< abandon all members and say farewell
    leave = 4,     ///< the run is over; end with this exit status
    part = 5,      ///< ranks are lost: when told to leave, wait for no other rank; see Link::abandon()
    post = 6,      ///< before the campaign, in runs with several writers: who keeps this rank's records
    close = 7,     ///< to a writer: all members have come; sync and close your journal, and say so
    publish = 8,   ///< to a writer: publish this piece of the campaign file
    digest = 9,    ///< to a writer: digest these datasets of the campaign file
    // worker -> master
    hello = 11,         ///< the campaign's fingerprint as read by the worker, and its cores
    answer = 12,        ///< finished members, to the rank that keeps the records
    farewell = 13,      ///< every answer of this worker has been sent; a writer passes it on with the worker's rank
    stop_request = 14,  ///< the worker received a signal to stop
    trouble = 15,       ///< the worker cannot continue; a sentence
    kept = 16,          ///< a writer has members in its journal
    closed = 17,        ///< a writer's journal is on the disk and closed
    published = 18,     ///< a writer's piece is on the disk, or cannot be written
    digested = 19,      ///< the digests, or why there are none
    // both directions
    alive = 21,  ///< a sign of life; of a worker, how far its members have come
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

// The link of a single process: messages to itself.

class LocalLink final : public Link {
  public:
    LocalLink();

    int rank() const override { return 0; }
    int size() const override { return 1; }
    const Topology& topology() const override { return topology_; }
    void send(int to, Tag tag, std::vector<std::byte> bytes) override;
    std::optional<Message> poll() override;
    void abandon(int) override {}  // there are no other ranks
    bool moving() const override { return !waiting_.empty(); }

  private:
    Topology topology_;
    std::deque<Message> waiting_;
};

/// Name and version of the MPI library, e.g. "Open MPI v4.1.4". Needs no MPI to be started.
std::string library_version();

/// The link that matches how this process was started: under mpirun or srun over MPI, which it starts and its
/// destructor ends, so that a process has only one, ever, and uses it from the thread that made it; otherwise local.
/// The former is collective over all ranks: throws RunError if MPI cannot be started; where the ranks have not all
/// started within `longest_start` s, this process says so and ends with status 1.
std::unique_ptr<Link> open_link(unsigned longest_start = 600);

}  // namespace floes
