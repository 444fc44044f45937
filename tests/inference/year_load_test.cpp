// The loads of a year where the tails of all regimes are known: roots of one-line equations, shares, and years drawn
// peak by peak.

#include "inference/posterior_load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>

#include "core/random.hpp"
#include "inference/known_processes.hpp"

namespace floes {
namespace year_load_test {

constexpr double window = 150;  // s
constexpr double hour = 3600;

UnlikeTail exponential_tail(double rate, double threshold, double scale) {
    UnlikeTail tail{.kind = TailKind::pareto, .threshold = threshold, .origin = 0};
    tail.rate = rate;
    tail.scale = scale;
    return tail;
}

UnlikeTail weibull_tail(double rate, double threshold, double origin, double scale, double shape) {
    UnlikeTail tail{.kind = TailKind::weibull, .threshold = threshold, .origin = origin};
    tail.rate = rate;
    tail.scale = scale;
    tail.shape = shape;
    return tail;
}

PosteriorLoad known_tail(const UnlikeTail& tail) {
    return {window, {{tail, 1}}};
}

/// Where a falling function is `wanted`.
double root(const std::function<double(double)>& falling, double wanted) {
    double low = 1, high = 1e6;
    for (int k = 0; k < 200; ++k) (falling(0.5 * (low + high)) > wanted ? low : high) = 0.5 * (low + high);
    return low;
}

/// A year with the tails that it is of.
class KnownYear : public YearLoad {
  public:
    KnownYear(const std::vector<PosteriorLoad>& sources, const std::vector<YearRegime>& regimes)
        : KnownYear(std::make_shared<const std::vector<PosteriorLoad>>(sources), regimes) {}

  private:
    using Kept = std::shared_ptr<const std::vector<PosteriorLoad>>;
    KnownYear(Kept kept, const std::vector<YearRegime>& regimes)
        : YearLoad(pointers(*kept), regimes), kept_(std::move(kept)) {}

    static std::vector<const PosteriorLoad*> pointers(const std::vector<PosteriorLoad>& sources) {
        std::vector<const PosteriorLoad*> all;
        for (const PosteriorLoad& one : sources) all.push_back(&one);
        return all;
    }

    Kept kept_;
};

KnownYear year_of(const std::vector<PosteriorLoad>& sources, const std::vector<YearRegime>& regimes) {
    return {sources, regimes};
}

const std::vector<PosteriorLoad> two{known_tail(exponential_tail(0.05, 50, 20)),
                                     known_tail(weibull_tail(0.02, 80, 30, 15, 1.5))};
const std::vector<YearRegime> hours{{0, 300 * hour}, {1, 40 * hour}};

double exponential_rate(double x) {
    return 0.05 * std::exp(-(x - 50) / 20);
}

/// H of member_tails.hpp with d = 50, c = 1.5, σ = 15.
double weibull_rate(double x) {
    return 0.02 * std::exp(-50 / (1.5 * 15) * (std::pow((x - 30) / 50, 1.5) - 1));
}

TEST(YearLoad, OfOneExponentialRegimeIsGumbels) {
    const KnownYear year = year_of({two[0]}, {{0, 300 * hour}});
    for (const double p : {0.5, 1e-2, 1e-4})
        EXPECT_NEAR(year.load(p).value, 50 + 20 * std::log(300 * hour * 0.05 / -std::log1p(-p)), 1e-3);
}

TEST(YearLoad, OfAMixtureIsTheRootOfTheSum) {
    const KnownYear year = year_of(two, hours);
    for (const double p : {0.3, 1e-2, 1e-4}) {
        const double truth = root(
            [](double x) { return 300 * hour * exponential_rate(x) + 40 * hour * weibull_rate(x); }, -std::log1p(-p));
        EXPECT_NEAR(year.load(p).value / truth, 1, 1e-5);
        EXPECT_NEAR(year.load(p).interval.high / truth, 1, 1e-5);  // nothing is uncertain
        EXPECT_NEAR(year.exceeded(truth).front(), p, 1e-6 + 1e-4 * p);
    }
}

TEST(YearLoad, IsSharedByTheExpectedNumbersOfPeaks) {
    const KnownYear year = year_of(two, hours);
    const double x = year.load(1e-2).value;
    const double first = 300 * exponential_rate(x), second = 40 * weibull_rate(x);
    const std::vector<YearShare> shares = year.shares(1e-2);
    EXPECT_NEAR(shares[0].value, first / (first + second), 1e-3);
    EXPECT_NEAR(shares[0].value + shares[1].value, 1, 1e-12);
    EXPECT_NEAR(shares[0].exceeded_once_in * exponential_rate(x), 1, 1e-3);
}

TEST(YearLoad, GrowsWithTheFactorOfARegime) {
    const double one = year_of({two[0]}, {{0, 300 * hour}}).load(1e-2).value;
    const KnownYear twice = year_of({two[0]}, {{0, 300 * hour, 2, 0}});
    EXPECT_NEAR(twice.load(1e-2).value / one, 2, 1e-5);
    const KnownYear uncertain = year_of({two[0]}, {{0, 300 * hour, 2, 0.1}});
    EXPECT_NEAR(uncertain.load(1e-2).value / one, 2, 0.01);
    EXPECT_NEAR(uncertain.load(1e-2).interval.high / one, 2 * (1 + 1.96 * 0.1), 0.02);
    EXPECT_NEAR(uncertain.load(1e-2).interval.low / one, 2 * (1 - 1.96 * 0.1), 0.02);
}

// Members that differ are counted by members: what is rare comes from scales of four and five standard deviations.
TEST(YearLoad, OfMembersThatDifferIsThatOfAsManyWindows) {
    UnlikeTail tail = exponential_tail(0.05, 50, 20);
    tail.scatter = 0.3;
    const KnownYear year = year_of({known_tail(tail)}, {{0, 300 * hour}});
    const auto expected = [&](double x) {
        double sum = 0;
        constexpr double step = 0.01;
        for (double at = -8; at < 8; at += step) {
            const double scale = std::exp(0.3 * at);
            const double rate = 0.05 * std::exp(-(x / scale - 50) / 20);
            sum -= step * std::exp(-at * at / 2) / std::sqrt(2 * std::numbers::pi) * std::expm1(-window * rate);
        }
        return -300 * hour / window * std::log1p(-sum);
    };
    for (const double p : {1e-2, 1e-4}) EXPECT_NEAR(year.load(p).value / root(expected, -std::log1p(-p)), 1, 0.01) << p;
}

TEST(YearLoad, KnowsWhichSourceItIsUncertainOf) {
    const PosteriorLoad unsure(window, {{exponential_tail(0.05, 50, 15), 0.5}, {exponential_tail(0.05, 50, 25), 0.5}});
    const std::vector<double> parts = year_of({two[1], unsure}, {{1, 300 * hour}, {0, 40 * hour}}).uncertainty(1e-2);
    EXPECT_NEAR(parts[0], 0, 0.02);
    EXPECT_NEAR(parts[1], 1, 0.1);
    // A regime that adds nothing to the load is no matter.
    const std::vector<double> idle = year_of({unsure, two[0]}, {{0, 300 * hour}, {1, 1e-9}}).uncertainty(1e-2);
    EXPECT_NEAR(idle[0], 1, 0.2);
    EXPECT_NEAR(idle[1], 0, 0.02);
}

TEST(YearLoad, IsUndefinedWhereAYearHasHardlyAnyIce) {
    EXPECT_TRUE(std::isnan(year_of({two[0]}, {{0, 1e-3}}).load(0.5).value));
}

// Years drawn peak by peak: as many exceed the load as it says.
TEST(YearLoad, IsExceededInThatShareOfDrawnYears) {
    constexpr int years = 20000;
    const std::vector<YearRegime> few{{0, 0.4 * hour}, {1, 0.3 * hour}};
    const KnownYear year = year_of(two, few);
    RandomStream random{36, 7, StreamId::bootstrap, 0};
    for (const double p : {0.3, 0.05}) {
        const double load = year.load(p).value;
        int exceeded = 0;
        for (int k = 0; k < years; ++k) {
            double largest = 0;
            for (double at = known::exponential(random); at < 0.05 * few[0].time; at += known::exponential(random))
                largest = std::max(largest, 50 + 20 * known::exponential(random));
            for (double at = known::exponential(random); at < 0.02 * few[1].time; at += known::exponential(random))
                largest =
                    std::max(largest, 30 + 50 * std::pow(1 + 1.5 * 15 / 50 * known::exponential(random), 1 / 1.5));
            exceeded += largest > load;
        }
        EXPECT_NEAR(static_cast<double>(exceeded) / years, p, 4 * std::sqrt(p * (1 - p) / years)) << p;
    }
}

}  // namespace year_load_test
}  // namespace floes
