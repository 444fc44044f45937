#pragma once
// The link of a single process: messages to itself.

#include <deque>

#include "wire/link.hpp"

namespace floes {

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

}  // namespace floes
