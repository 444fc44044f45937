#pragma once
// The link over MPI. Constructing it starts MPI, destroying it ends MPI, so a process has at most one, ever, and calls
// it from the thread that made it.

#include <list>
#include <set>
#include <string>

#include "wire/link.hpp"

namespace floes {

class MpiLink final : public Link {
  public:
    /// Collective over all ranks. Throws RunError when MPI cannot be started.
    MpiLink();

    /// Waits (asleep, and not for ever) until what was sent has left, then ends MPI. When an exception is under way the
    /// other ranks may never come to MPI_Finalize, so it is not called: mpirun then sees an improper exit and ends
    /// them all, which beats waiting for ever. Nor is it called when a rank was abandoned, which may never come either.
    /// Where a rank hangs there for a minute, SIGALRM ends this process.
    ~MpiLink() override;

    int rank() const override { return rank_; }
    int size() const override { return size_; }
    const Topology& topology() const override { return topology_; }
    void send(int to, Tag tag, std::vector<std::byte> bytes) override;
    std::optional<Message> poll() override;
    void abandon(int rank) override;
    bool moving() const override { return !outgoing_.empty() || !incoming_.empty(); }

  private:
    struct Transfer;

    void forget_sent();
    void begin_receiving();
    std::optional<Message> take_arrived();

    int rank_ = 0;
    int size_ = 1;
    int exceptions_ = 0;  // under way at construction
    Topology topology_;
    std::set<int> abandoned_;
    std::list<Transfer> outgoing_;
    std::list<Transfer> stranded_;  // sent to ranks that were abandoned since
    std::list<Transfer> incoming_;  // in the order in which they were matched
};

/// Name and version of the MPI library, e.g. "Open MPI v4.1.4". Needs no MPI to be started.
std::string library_version();

}  // namespace floes
