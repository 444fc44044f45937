#include "run/core_pool.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace floes {
namespace core_pool_test {

using testing::ElementsAre;

TEST(CorePool, TakesTheLowestTurnFirst) {
    std::promise<void> computing;
    std::promise<void> all_wait;
    std::promise<void> over;
    std::vector<std::string> order;
    CorePool pool(1);
    pool.begin(9, [&, waits = all_wait.get_future().share()] {
        computing.set_value();
        waits.wait();
    });
    computing.get_future().wait();
    const auto note = [&](const std::string& name) { return [&order, name] { order.push_back(name); }; };
    pool.begin(2, note("2a"));
    pool.begin(1, note("1a"));
    pool.begin(3, [&] { over.set_value(); });
    pool.begin(2, note("2b"));
    pool.begin(1, note("1b"));
    all_wait.set_value();
    over.get_future().wait();
    EXPECT_THAT(order, ElementsAre("1a", "1b", "2a", "2b"));
}

TEST(CorePool, ComputesAsManyAtATimeAsItHasThreads) {
    // Each task waits until as many as there are threads run together: fewer threads never end, more are seen.
    constexpr int threads = 3;
    CorePool pool(threads);
    std::atomic<int> running = 0;
    std::atomic<int> together = 0;
    std::vector<std::promise<void>> over(12);
    for (std::size_t k = 0; k < over.size(); ++k)
        pool.begin(static_cast<std::int64_t>(k % 2), [&, k] {
            const int now = ++running;
            for (int seen = together; now > seen && !together.compare_exchange_weak(seen, now);) {
            }
            while (together < threads) std::this_thread::yield();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            --running;
            over[k].set_value();
        });
    for (std::promise<void>& one : over) one.get_future().wait();
    EXPECT_EQ(together, threads);
}

TEST(CorePool, PassesOnWhatATaskThrows) {
    CorePool pool(1);
    int done = 0;
    pool.execute(0, [&] { ++done; });
    EXPECT_EQ(done, 1);
    EXPECT_THROW(pool.execute(0, [] { throw std::runtime_error("no"); }), std::runtime_error);
}

}  // namespace core_pool_test
}  // namespace floes
