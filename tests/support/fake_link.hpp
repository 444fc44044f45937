#pragma once
// A link that plays the other ranks by a script and reports every message that is not in the script.
//
//     FakeLink link(/*rank*/ 1, /*size*/ 2);
//     link.deliver(0, Tag::campaign, …);   // returned by poll() after all messages expected before it were sent
//     link.expect(0, Tag::hello);          // the next message sent must be this one
//     …
//     link.finish();                       // nothing of the script is left
//
// If the tested side waits for a message that is not in the script, it gets an exception after a while.

#include <chrono>
#include <deque>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "run/link.hpp"

namespace floes {

class FakeLink final : public Link {
  public:
    using Look = std::function<void(const std::vector<std::byte>&)>;

    FakeLink(int rank, int size) : rank_(rank), size_(size) {}
    void play(int rank, int size) { rank_ = rank, size_ = size; }

    void deliver(int from, Tag tag, std::vector<std::byte> bytes = {}) {
        script_.push_back({true, {from, tag, std::move(bytes)}, {}});
    }
    /// The same of bytes that `make` gives when it is time.
    void deliver_made(int from, Tag tag, std::function<std::vector<std::byte>()> make) {
        script_.push_back({true, {from, tag, {}}, {}, std::move(make)});
    }
    /// `look` sees the bytes that were sent.
    void expect(int to, Tag tag, Look look = {}) { script_.push_back({false, {to, tag, {}}, std::move(look)}); }
    void finish() const { EXPECT_TRUE(script_.empty()) << script_.size() << " steps of the script did not happen"; }

    int rank() const override { return rank_; }
    int size() const override { return size_; }
    const Topology& topology() const override { return topology_; }
    void abandon(int rank) override { abandoned.push_back(rank); }
    bool moving() const override { return false; }

    void send(int to, Tag tag, std::vector<std::byte> bytes) override {
        const bool expects_it = !script_.empty() && !script_.front().deliver && script_.front().message.tag == tag;
        if (tag == Tag::alive && !expects_it) return;  // comes by the clock
        if (script_.empty() || script_.front().deliver || script_.front().message.from != to ||
            script_.front().message.tag != tag) {
            ADD_FAILURE() << "unexpected message " << static_cast<int>(tag) << " to rank " << to << ": "
                          << testing::PrintToString(
                                 std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
            return;
        }
        const Look look = std::move(script_.front().look);
        advance();
        if (look) look(bytes);
    }

    std::optional<Message> poll() override {
        if (std::chrono::steady_clock::now() - last_step_ > std::chrono::seconds(20)) {
            throw std::runtime_error("the script of the fake link stands still");
        }
        if (script_.empty() || !script_.front().deliver) return std::nullopt;
        Message message = std::move(script_.front().message);
        if (script_.front().make) message.bytes = script_.front().make();
        advance();
        return message;
    }

    std::vector<int> abandoned;  ///< ranks that the party gave up

  private:
    struct Step {
        bool deliver;
        Message message;  // `from` is the receiver of what is expected
        Look look;
        std::function<std::vector<std::byte>()> make = {};
    };

    void advance() {
        script_.pop_front();
        last_step_ = std::chrono::steady_clock::now();
    }

    int rank_;
    int size_;
    std::chrono::steady_clock::time_point last_step_ = std::chrono::steady_clock::now();
    Topology topology_{.cores = 1, .bound_cores = 1, .node_cores = 1, .node_ranks = 1};
    std::deque<Step> script_;
};

}  // namespace floes
