#pragma once
// Requirements on every link, local or over MPI. All ranks run each function together.

#include <chrono>
#include <cstdint>
#include <map>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "run/link.hpp"

namespace floes::contract {

/// The bytes that rank `from` sends to rank `to` as its message number k.
inline std::vector<std::byte> pattern(int from, int to, int k, std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (std::size_t i = 0; i < size; ++i) {
        bytes[i] = static_cast<std::byte>((i * 31 + static_cast<std::size_t>(from * 7 + to * 3 + k)) & 0xff);
    }
    return bytes;
}

/// Polls, asleep in between, until a message comes; fails after 30 s.
inline std::optional<Message> wait_for_message(Link& link) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < deadline) {
        if (auto message = link.poll()) return message;
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    ADD_FAILURE() << "rank " << link.rank() << " waited in vain for a message";
    return std::nullopt;
}

/// Every rank sends every rank messages of very different sizes: all arrive whole, in order from each sender.
inline void everybody_writes_to_everybody(Link& link) {
    const std::vector<std::size_t> sizes{0, 1, 3'000'000, 5, 4096, 70'000, 0, 200'000, 12};
    const auto tag_of = [](std::size_t k) { return k % 2 == 0 ? Tag::answer : Tag::assign; };
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        for (int to = 0; to < link.size(); ++to) {
            link.send(to, tag_of(k), pattern(link.rank(), to, static_cast<int>(k), sizes[k]));
        }
    }
    std::map<int, std::size_t> seen;
    for (std::size_t n = 0; n < sizes.size() * static_cast<std::size_t>(link.size()); ++n) {
        const auto message = wait_for_message(link);
        ASSERT_TRUE(message);
        const std::size_t k = seen[message->from]++;
        ASSERT_LT(k, sizes.size());
        EXPECT_EQ(message->tag, tag_of(k));
        EXPECT_EQ(message->bytes, pattern(message->from, link.rank(), static_cast<int>(k), sizes[k]));
    }
    EXPECT_FALSE(link.poll());
}

}  // namespace floes::contract
