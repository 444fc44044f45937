// Random sequences of events against the scheduler: workers join, answer, die and answer late, and stops are requested.
//   the invariants hold after every event; no member is recorded twice; an attempt number is never used twice;
//   without a stop every member is recorded; after a stop nothing is assigned; a member is recorded as failed exactly
//   when it has used up its failures; once lost with its worker, it is only computed in isolation.

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "run/scheduler.hpp"

namespace floes {
namespace random_order_test {

/// The world around a scheduler: who is there, what they hold, and answers that are still on their way.
class Surroundings {
  public:
    explicit Surroundings(unsigned seed)
        : random_(seed),
          members_(below(40)),
          stop_(below(4) == 0),
          most_failures_(1 + below(3)),
          scheduler_(tasks(), most_failures_) {}

    void run() {
        join();
        for (int step = 0; !scheduler_.finished(); ++step) {
            ASSERT_LT(step, 100'000) << "the campaign does not end";
            advance();
        }
        EXPECT_TRUE(stopped_ || static_cast<int>(recorded_.size()) == members_);
        EXPECT_EQ(scheduler_.done(), static_cast<int>(recorded_.size()));
    }

  private:
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

    std::vector<MemberTask> tasks() {
        std::vector<MemberTask> result;
        for (int i = 0; i < members_; ++i) {
            result.push_back({i, 1.0 + below(5), below(2), below(3), below(most_failures_), below(5) == 0});
            failures_[i] = result.back().failures;
            if (result.back().suspect) suspects_.insert(i);
        }
        std::shuffle(result.begin(), result.end(), random_);
        return result;
    }

    void advance() {
        const int dice = below(20);
        if (dice == 0 || present_.empty()) return join();
        if (dice == 1) return lose();
        if (dice == 2 && !late_.empty())
            return answer(late_[static_cast<std::size_t>(below(static_cast<int>(late_.size())))]);
        if (dice == 3 && stop_ && !stopped_) {
            send(StopRequested{});
            stopped_ = true;
            return;
        }
        if (!dismissed_.empty() && below(2) == 0) return leave(*dismissed_.begin());
        if (!held_.empty()) {
            auto chosen = held_.begin();
            std::advance(chosen, below(static_cast<int>(held_.size())));
            const auto end = below(4) == 0 ? AttemptEnd::failed : AttemptEnd::done;
            answer({chosen->second, chosen->first.first, chosen->first.second, end, 0.01 * below(30)});
        }
    }

    void join() {
        const int worker = next_worker_++;
        present_.insert(worker);
        send(WorkerJoined{worker, 1 + below(3), below(3)});
    }

    void lose() {
        auto chosen = present_.begin();
        std::advance(chosen, below(static_cast<int>(present_.size())));
        for (const auto& [held, worker] : held_) {
            if (worker == *chosen) suspects_.insert(held.first);
        }
        remove(*chosen, WorkerLost{*chosen});
    }

    void leave(int worker) { remove(worker, WorkerLeft{worker}); }

    void remove(int worker, const Event& event) {
        for (auto it = held_.begin(); it != held_.end();) {
            if (it->second != worker) {
                ++it;
                continue;
            }
            late_.push_back({worker, it->first.first, it->first.second});
            it = held_.erase(it);
        }
        present_.erase(worker);
        dismissed_.erase(worker);
        send(event);
    }

    void answer(MemberFinished event) {
        const bool awaited = held_.erase({event.number, event.attempt}) > 0;
        if (awaited && event.end == AttemptEnd::failed) ++failures_[event.number];
        late_.push_back(event);  // the network may say it again
        send(event);
    }

    void send(const Event& event) {
        const bool was_stopped = scheduler_.stopping();
        const auto commands = scheduler_.handle(event);
        ASSERT_NO_THROW(scheduler_.check_invariants());
        for (const Command& command : commands) {
            if (const auto* assign = std::get_if<Assign>(&command)) {
                EXPECT_FALSE(was_stopped);
                EXPECT_TRUE(present_.contains(assign->worker));
                EXPECT_FALSE(recorded_.contains(assign->number));
                EXPECT_GT(assign->attempt, attempts_[assign->number]) << "an attempt number is given twice";
                attempts_[assign->number] = assign->attempt;
                EXPECT_EQ(assign->apart, suspects_.contains(assign->number));
                held_[{assign->number, assign->attempt}] = assign->worker;
            } else if (const auto* record = std::get_if<Keep>(&command)) {
                EXPECT_TRUE(recorded_.insert(record->number).second)
                    << "member " << record->number << " is recorded twice";
                EXPECT_LE(failures_[record->number], most_failures_);
            } else if (const auto* retry = std::get_if<Retry>(&command)) {
                EXPECT_LT(failures_[retry->number], most_failures_);
            } else {
                EXPECT_TRUE(dismissed_.insert(std::get<Dismiss>(command).worker).second) << "dismissed twice";
            }
        }
    }

    std::mt19937 random_;
    int members_;
    bool stop_;
    bool stopped_ = false;
    int most_failures_;
    std::set<int> suspects_;
    std::map<int, int> failures_;
    Scheduler scheduler_;
    int next_worker_ = 0;
    std::set<int> present_;
    std::set<int> dismissed_;
    std::map<std::pair<int, int>, int> held_;  // (number, attempt) -> worker
    std::vector<MemberFinished> late_;
    std::set<int> recorded_;
    std::map<int, int> attempts_;
};

TEST(SchedulerProperty, HoldsInAnyOrderOfEvents) {
    for (unsigned seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        Surroundings(seed).run();
        if (HasFailure()) return;
    }
}

}  // namespace random_order_test
}  // namespace floes
