#pragma once
// The link over MPI. Its constructor starts MPI and its destructor ends MPI, so a process can have only one, ever, and
// must use it from the thread that made it.

#include <list>
#include <set>
#include <string>

#include "wire/link.hpp"

namespace floes {

class MpiLink final : public Link {
  public:
    /// Collective over all ranks. Throws RunError if MPI cannot be started. Where the ranks have not all started within
    /// `longest_start` s, this process says so and ends with status 1.
    explicit MpiLink(unsigned longest_start);

    /// Waits (asleep, for a limited time) until all messages are sent, then ends MPI. During an exception MPI_Finalize
    /// is not called, because the other ranks may never reach it: mpirun then sees an improper exit and ends them all,
    /// instead of waiting without end. It is not called either if a rank was abandoned. If a rank hangs in it for a
    /// minute, SIGALRM ends this process.
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
    int exceptions_ = 0;  // active at construction
    Topology topology_;
    std::set<int> abandoned_;
    std::list<Transfer> outgoing_;
    std::list<Transfer> stranded_;  // sent to ranks that were abandoned later
    std::list<Transfer> incoming_;  // in the order in which they were matched
};

/// Name and version of the MPI library, e.g. "Open MPI v4.1.4". Needs no MPI to be started.
std::string library_version();

}  // namespace floes
