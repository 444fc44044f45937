// The stop rule: by hand, and the coverage of its intervals if run time grows with the load.

#include "inference/precision_stop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/error.hpp"
#include "core/random.hpp"
#include "inference/interval.hpp"

namespace floes {
namespace precision_stop_test {

StopRule rule(double half_width, int minimum, int look_ahead) {
    StopRule made;
    made.half_width = half_width;
    made.minimum = minimum;
    made.look_ahead = look_ahead;
    return made;
}

TEST(PrecisionStop, IsTheIntervalOfTheMean) {
    PrecisionStop stop(rule(0.2, 3, 0), {"one"});
    const std::vector<double> values{10, 14, 12, 11, 13, 12, 12};
    for (std::size_t i = 0; i < values.size(); ++i) {
        stop.put(static_cast<int>(i), 0, values[i]);
        if (stop.met()) break;
        if (i == 0) {
            EXPECT_TRUE(std::isnan(stop.achieved()));
            continue;
        }
        const Interval interval = mean_interval(std::span(values).first(i + 1));
        EXPECT_NEAR(stop.achieved(), (interval.high - interval.estimate) / interval.estimate, 1e-12);
    }
    // t s / √n over the mean: 0.414 at 3, 0.231 at 4, 0.164 at 5.
    EXPECT_TRUE(stop.met());
    EXPECT_EQ(stop.arrangements(), 5);
}

TEST(PrecisionStop, WantsTheMinimumAndTheLookAhead) {
    PrecisionStop stop(rule(0.5, 4, 2), {"one"});
    for (int i = 0; i < 6; ++i) {
        EXPECT_FALSE(stop.met()) << i;
        stop.put(i, 0, 10 + i % 2);
    }
    EXPECT_TRUE(stop.met());  // it held at 4, 5 and 6
    EXPECT_EQ(stop.arrangements(), 6);
}

// Loads that hardly scatter: the target is met at once, but 5 % of all may be of a kind that 58 do not show.
TEST(PrecisionStop, GoesOnUntilARareKindWouldHaveBeenMet) {
    PrecisionStop stop(rule(0.05, 0, 0), {"one"});
    EXPECT_EQ(stop.minimum(), 59);
    for (int i = 0; !stop.met(); ++i) stop.put(i, 0, 10 + 0.1 * (i % 2));
    EXPECT_EQ(stop.arrangements(), 59);
    EXPECT_EQ(PrecisionStop(rule(0.5, 0, 0), {"one"}).minimum(), 20);
}

// Student's half-width is at the target from 27 on, but one of 27 may be one of seven.
TEST(PrecisionStop, GoesOnWhileAMemberStandsOut) {
    PrecisionStop stop(rule(0.05, 20, 0), {"one"});
    std::vector<double> values;
    while (!stop.met()) {
        const int i = static_cast<int>(values.size());
        values.push_back(i == 3 ? 16 : 10 + 0.1 * (i % 7));
        stop.put(i, 0, values.back());
        const Interval student = mean_interval(values);
        if (values.size() == 30) {
            EXPECT_LT((student.high - student.estimate) / student.estimate, 0.05);
            EXPECT_GT(stop.achieved(), 0.05);
        }
        ASSERT_LT(i, 200);
    }
    EXPECT_GT(stop.arrangements(), 35);
    EXPECT_LE(stop.achieved(), 0.05);
}

TEST(PrecisionStop, TakesArrangementsInIndexOrderAlone) {
    PrecisionStop stop(rule(0.5, 2, 0), {"one", "two"});
    for (int i = 1; i < 50; ++i) {
        stop.put(i, 0, 10 + i % 2);
        stop.put(i, 1, 10 + i % 2);
    }
    stop.put(0, 1, 10);
    EXPECT_EQ(stop.arrangements(), 0);  // member (0, 0) is not there
    stop.put(0, 0, 10);
    EXPECT_TRUE(stop.met());
    EXPECT_EQ(stop.arrangements(), 3);  // 10 and 11 are 6.35 about 10.5; what came early is not looked at
}

TEST(PrecisionStop, AFailedMemberIsNoValueAndNoGap) {
    PrecisionStop stop(rule(0.5, 3, 0), {"one"});
    stop.put(0, 0, 10);
    stop.put(1, 0, std::numeric_limits<double>::quiet_NaN());
    stop.put(2, 0, 10.5);
    EXPECT_EQ(stop.arrangements(), 3);
    EXPECT_NEAR(stop.achieved(), 12.706204736 * 0.25 / 10.25, 1e-9);
}

TEST(PrecisionStop, AContrastIsPaired) {
    StopRule paired = rule(0.01, 3, 0);
    paired.case_name = "none";
    paired.contrast = "two - one";
    PrecisionStop stop(paired, {"one", "two"});
    for (int i = 0; i < 3; ++i) {
        stop.put(i, 0, 100.0 * (i + 1));
        stop.put(i, 1, 100.0 * (i + 1) + 7);
    }
    EXPECT_TRUE(stop.met());  // the cases scatter widely, their difference not at all
    EXPECT_EQ(stop.achieved(), 0);
    paired.case_name = "all";
    PrecisionStop both(paired, {"one", "two"});
    for (int i = 0; i < 3; ++i) {
        both.put(i, 0, 100.0 * (i + 1));
        both.put(i, 1, 100.0 * (i + 1) + 7);
    }
    EXPECT_FALSE(both.met());
}

TEST(PrecisionStop, PairsOnlyWhatSharesArrangements) {
    StopRule paired = rule(0.01, 3, 0);
    paired.case_name = "none";
    paired.contrast = "all";
    PrecisionStop stop(paired, {"one", "two", "other field"}, {0, 0, 1});
    for (int i = 0; i < 3; ++i) {
        stop.put(i, 0, 100.0 * (i + 1));
        stop.put(i, 1, 100.0 * (i + 1) + 7);
        stop.put(i, 2, 50.0 * i * i);
    }
    EXPECT_TRUE(stop.met());
    EXPECT_THROW(PrecisionStop(paired, {"one", "two"}, {0, 1}), InputError);
    paired.contrast = "two - one";
    EXPECT_THROW(PrecisionStop(paired, {"one", "two"}, {0, 1}), InputError);
}

TEST(PrecisionStop, RefusesWhatNobodyCanAnswer) {
    StopRule strange = rule(0.1, 3, 0);
    strange.case_name = "E61";
    EXPECT_THROW(PrecisionStop(strange, {"E30", "E60"}), InputError);
    strange.case_name = "none";
    EXPECT_THROW(PrecisionStop(strange, {"E30", "E60"}), InputError);
    strange.contrast = "E30-E60";
    EXPECT_THROW(PrecisionStop(strange, {"E30", "E60"}), InputError);
}

// A campaign in miniature: loads of gamma distribution with a coefficient of variation of 0.5, each run as long as
// 0.2 + load / mean, handed out in order to `workers` workers that never idle. The worst case: nothing but the load
// decides the time.
struct Campaigns {
    double coverage = 0;
    double bias = 0;
    double arrangements = 0;
};

Campaigns simulate(int workers, int campaigns) {
    using Finish = std::pair<double, int>;  // when, which arrangement
    Campaigns all;
    for (int number = 0; number < campaigns; ++number) {
        RandomStream random{77, static_cast<std::uint32_t>(number), StreamId::monte_carlo, 0};
        std::vector<double> loads;
        const auto load = [&](int index) {
            while (static_cast<int>(loads.size()) <= index) {
                double product = 1;
                for (int k = 0; k < 4; ++k) product *= 1 - random.uniform();
                loads.push_back(-0.25 * std::log(product));
            }
            return loads[static_cast<std::size_t>(index)];
        };
        PrecisionStop stop(rule(0.10, 20, 5), {"one"});
        std::priority_queue<Finish, std::vector<Finish>, std::greater<>> running;
        int next = 0;
        for (; next < workers; ++next) running.emplace(0.2 + load(next), next);
        while (!stop.met()) {
            const auto [time, index] = running.top();
            running.pop();
            stop.put(index, 0, load(index));
            running.emplace(time + 0.2 + load(next), next);
            ++next;
        }
        loads.resize(static_cast<std::size_t>(stop.arrangements()));
        const Interval found = mean_interval(loads);
        all.coverage += (found.low <= 1 && 1 <= found.high) / double(campaigns);
        all.bias += (found.estimate - 1) / campaigns;
        all.arrangements += stop.arrangements() / double(campaigns);
    }
    return all;
}

TEST(Coverage, IsAsPromisedInIndexOrderOnAnyNumberOfWorkers) {
    const Campaigns alone = simulate(1, 3000);
    EXPECT_GT(alone.coverage, 0.93);
    EXPECT_LT(alone.coverage, 0.97);
    EXPECT_NEAR(alone.bias, 0, 0.01);
    EXPECT_NEAR(alone.arrangements, 97, 10);  // (1.96 · 0.5 / 0.1)² and the look-ahead
    for (const int workers : {32, 256}) {
        const Campaigns many = simulate(workers, 3000);
        EXPECT_EQ(many.coverage, alone.coverage) << workers;
        EXPECT_EQ(many.arrangements, alone.arrangements) << workers;
    }
}

}  // namespace precision_stop_test
}  // namespace floes
