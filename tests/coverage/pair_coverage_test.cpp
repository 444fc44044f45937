// How often the intervals of paired differences and of campaigns that stop by themselves hold, where some members are
// of another kind. docs/statistics.md has the result. Label slow: FLOES_TRIALS gives the trials of a row.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "inference/interval.hpp"
#include "inference/known_processes.hpp"
#include "inference/paired.hpp"
#include "inference/precision_stop.hpp"

namespace floes {
namespace pair_coverage_test {

struct Kind {
    const char* name;
    double scatter;  ///< SD of the logarithm of a member's load; its mean is 1
    double share;    ///< of members of another kind
    double times;    ///< their load

    double truth() const { return 1 + share * (times - 1); }
};

const std::array kinds{Kind{"5 % of members at 5 times the load", 0.2, 0.05, 5},
                       Kind{"2 % at 5 times", 0.2, 0.02, 5},
                       Kind{"15 % at 5 times", 0.2, 0.15, 5},
                       Kind{"5 % at 10 times", 0.2, 0.05, 10},
                       Kind{"5 % at twice", 0.2, 0.05, 2},
                       Kind{"members alike, log-normal, SD 20 %", 0.2, 0, 1},
                       Kind{"members alike, log-normal, SD 50 %", 0.472, 0, 1}};

double load_of(const Kind& kind, RandomStream& random) {
    return std::exp(kind.scatter * known::normal(random) - kind.scatter * kind.scatter / 2);
}

int trials_or(int usual) {
    const char* given = std::getenv("FLOES_TRIALS");
    return given != nullptr ? std::atoi(given) : usual;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values.empty() ? std::nan("") : quantile_of_sorted(values, 0.5);
}

double percent(int part, int all) {
    return all > 0 ? 100.0 * part / all : std::nan("");
}

/// Lower than this in fewer than one of a thousand rows that hold with `least`.
double bound(double least, int trials) {
    return least - 3 * std::sqrt(least * (1 - least) / trials);
}

bool holds(const Limits& limits, double truth) {
    return limits.low <= truth && truth <= limits.high;
}

/// Which of two cases over the same arrangements jams.
enum class Jams { second, either, both };

struct PairRow {
    const char* name;
    Jams jams;
    double together;  ///< correlation of the logarithms of the loads
    double more;      ///< the second case's load over the first's, without jams
    std::size_t members;
};

class PairCoverage : public testing::TestWithParam<PairRow> {};

TEST_P(PairCoverage, IsAsTheIntervalsSay) {
    const auto [name, jams, together, more, members] = GetParam();
    constexpr double scatter = 0.2, share = 0.05, times = 5;
    const double jammed = 1 + share * (times - 1);
    const double truth = more * jammed - (jams == Jams::second ? 1 : jammed);
    const int trials = trials_or(300);
    int met = 0, within = 0, student = 0, without = 0;
    std::vector<double> widths, student_widths;
    for (std::uint32_t trial = 0; met < trials; ++trial) {
        RandomStream random{62, trial, StreamId::bootstrap, 1000 * static_cast<std::size_t>(jams) + members};
        std::vector<double> first, second;
        bool any = false;
        for (std::size_t row = 0; row < members; ++row) {
            const double common = known::normal(random), own = known::normal(random);
            const bool one = random.uniform() < share && jams != Jams::second;
            const bool drawn = random.uniform() < share;
            const bool other = jams == Jams::both ? one : drawn;
            const auto load = [&](double z) { return std::exp(scatter * z - scatter * scatter / 2); };
            first.push_back(load(common) * (one ? times : 1));
            second.push_back(more * load(together * common + std::sqrt(1 - together * together) * own) *
                             (other ? times : 1));
            any = any || one || other;
        }
        if (!any) {
            ++without;
            continue;
        }
        ++met;
        const PairedComparison found = compare_paired(first, second);
        within += holds(found.interval, truth);
        student += holds(found.t_interval, truth);
        widths.push_back(found.interval.high - found.interval.low);
        student_widths.push_back(found.t_interval.high - found.t_interval.low);
    }
    fmt::print("| pair | {} | {} | {:.0f} | {:.0f} | {:.0f} | {:.2f} | {:.2f} |\n", name, members,
               percent(without, without + met), percent(within, met), percent(student, met), median(widths),
               median(student_widths));
    std::fflush(stdout);
    EXPECT_GE(within, bound(0.92, met) * met);
}

constexpr const char* either = "either case jams in 5 %";
constexpr const char* second = "the second case jams in 5 %";
constexpr const char* both = "the same arrangements jam both, 20 % more";
INSTANTIATE_TEST_SUITE_P(
    Rows, PairCoverage,
    testing::Values(PairRow{either, Jams::either, 0.2, 1, 8}, PairRow{either, Jams::either, 0.2, 1, 20},
                    PairRow{either, Jams::either, 0.2, 1, 50}, PairRow{second, Jams::second, 0.2, 1, 8},
                    PairRow{second, Jams::second, 0.2, 1, 20}, PairRow{second, Jams::second, 0.2, 1, 50},
                    PairRow{second, Jams::second, 0.2, 1, 100}, PairRow{both, Jams::both, 0.9, 1.2, 8},
                    PairRow{both, Jams::both, 0.9, 1.2, 20}, PairRow{both, Jams::both, 0.9, 1.2, 50},
                    PairRow{both, Jams::both, 0.9, 1.2, 100}));

struct StopRow {
    std::size_t kind;
    double target;
    int minimum;   ///< 0: by the target
    double least;  ///< of the campaigns whose interval holds
};

class StopCoverage : public testing::TestWithParam<StopRow> {};

TEST_P(StopCoverage, IsAsTheIntervalsSay) {
    const auto [number, target, minimum, least] = GetParam();
    const Kind& kind = kinds[number];
    const int campaigns = trials_or(100);
    int within = 0, near = 0, soon = 0, unmet = 0;
    std::vector<double> lengths;
    for (int campaign = 0; campaign < campaigns; ++campaign) {
        RandomStream random{63, static_cast<std::uint32_t>(campaign), StreamId::bootstrap, number};
        StopRule rule;
        rule.half_width = target;
        rule.minimum = minimum;
        PrecisionStop stop(rule, {"one"});
        std::vector<double> loads;
        bool met = false;
        for (int arrangement = 0; !stop.met(); ++arrangement) {
            const double load = load_of(kind, random);
            const bool other = random.uniform() < kind.share;
            met = met || other;
            loads.push_back(other ? kind.times * load : load);
            stop.put(arrangement, 0, loads.back());
        }
        const Interval found = mixed_interval(loads, mean_interval(loads), apart(loads, Sides::above), Sides::above);
        within += holds({found.low, found.high}, kind.truth());
        near += std::abs(found.estimate / kind.truth() - 1) <= target;
        soon += loads.size() <= 30;
        unmet += kind.share > 0 && !met;
        lengths.push_back(static_cast<double>(loads.size()));
    }
    fmt::print("| stop | {} | {:g} | {} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} |\n", kind.name, 100 * target,
               minimum == 0 ? "by the target" : fmt::format("{}", minimum), median(lengths), percent(soon, campaigns),
               percent(unmet, campaigns), percent(within, campaigns), percent(near, campaigns));
    std::fflush(stdout);
    EXPECT_GE(within, bound(least, campaigns) * campaigns);
}

// One campaign in twenty meets none of a kind that is as rare as the target.
INSTANTIATE_TEST_SUITE_P(Rows, StopCoverage,
                         testing::Values(StopRow{0, 0.05, 0, 0.9}, StopRow{0, 0.1, 0, 0.7}, StopRow{0, 0.1, 20, 0.6},
                                         StopRow{2, 0.1, 0, 0.9}, StopRow{4, 0.05, 0, 0.9}, StopRow{5, 0.05, 0, 0.92},
                                         StopRow{6, 0.05, 0, 0.92}, StopRow{6, 0.1, 0, 0.92}));

}  // namespace pair_coverage_test
}  // namespace floes
