// How often the interval of a design load holds at the arrangement at which the stop rule ends a campaign, where the
// truth is known. docs/statistics.md has the result. Label slow: FLOES_TRIALS gives the campaigns of a row.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/units.hpp"
#include "inference/known_members.hpp"
#include "inference/precision_stop.hpp"

namespace floes {
namespace load_stop_coverage_test {

struct Kind {
    const char* name;
    double scatter;  ///< SD of the logarithm of a member's scale
    double share;    ///< of members of another kind
    double times;    ///< their load

    double factor(RandomStream& random) const {
        const double own = std::exp(scatter * known::normal(random));
        return random.uniform() < share ? times * own : own;
    }
    /// Log of the probability that the largest of one member stays below x.
    double log_below(double x) const {
        double sum = 0, all = 0;
        for (double z = -5; z <= 5; z += 0.02) {
            const double weight = std::exp(-z * z / 2);
            const double own = std::exp(scatter * z);
            sum += weight * ((1 - share) * below(x / own) + share * below(x / own / times));
            all += weight;
        }
        return std::log(sum / all);
    }
    double truth(double exposure, double p) const {
        double low = known::least_peak, high = 1e5;
        for (int k = 0; k < 80; ++k) {
            const double middle = std::sqrt(low * high);
            (exposure / known::window * log_below(middle) < std::log(p) ? low : high) = middle;
        }
        return low;
    }

  private:
    static double below(double x) {
        const double hazard = std::max(0.0, (x - known::least_peak) / known::peak_scale);
        return std::exp(-known::peaks_a_member * std::exp(-hazard));
    }
};

const std::array kinds{Kind{"members alike, exponential peaks", 0, 0, 1},
                       Kind{"members' scale varies by 20 %", 0.2, 0, 1},
                       Kind{"5 % of members at 5 times the load", 0, 0.05, 5}};

struct Row {
    std::size_t kind;
    double target;
    double least;  ///< of the campaigns whose interval holds
};

class LoadStopCoverage : public testing::TestWithParam<Row> {};

TEST_P(LoadStopCoverage, IsAsTheIntervalsSay) {
    const auto [number, target, least] = GetParam();
    const Kind& kind = kinds[number];
    const char* given = std::getenv("FLOES_TRIALS");
    const int campaigns = given != nullptr ? std::atoi(given) : 40;
    const Campaign campaign = known::load_campaign(target);
    const double truth = kind.truth(campaign.stop.exposure, campaign.stop.quantile);
    int within = 0, below = 0;
    std::vector<double> lengths, errors;
    for (int trial = 0; trial < campaigns; ++trial) {
        RandomStream random{64, static_cast<std::uint32_t>(trial), StreamId::bootstrap,
                            static_cast<std::uint32_t>(number)};
        PrecisionStop stop(campaign);
        std::vector<PeakRow> rows;
        double mean = 0;
        while (!stop.met()) {
            const MemberOutputs one = known::member(random, kind.factor(random));
            stop.put_member(static_cast<int>(rows.size()), 0, &one);
            rows.push_back({one.averaged[0].peaks, one.averaged[0].segment_maximum});
            mean += one.load.mean;
            ASSERT_LT(rows.size(), 3000U);
        }
        const Measured measured{known::window, known::window / 3, known::separation,
                                mean / static_cast<double>(rows.size())};
        const Exposure exposure{.time = campaign.stop.exposure, .probabilities = {campaign.stop.quantile}};
        const LoadFigure load = load_by_both_tails(rows, measured, exposure).estimates.front().quantiles.front();
        within += load.interval.low <= truth && truth <= load.interval.high;
        below += load.interval.high < truth;
        lengths.push_back(static_cast<double>(rows.size()));
        errors.push_back(load.value / truth - 1);
    }
    std::ranges::sort(lengths);
    std::ranges::sort(errors);
    fmt::print("| loadstop | {} | {:g} | {} | {:.0f} | {:.0f} | {:.0f} | {:+.0f} |\n", kind.name, 100 * target,
               campaigns, lengths[lengths.size() / 2], 100.0 * within / campaigns, 100.0 * below / campaigns,
               100 * errors[errors.size() / 2]);
    std::fflush(stdout);
    // Three standard deviations of so few campaigns below what was found.
    EXPECT_GE(within, campaigns * (least - 3 * std::sqrt(least * (1 - least) / campaigns)));
}

INSTANTIATE_TEST_SUITE_P(Rows, LoadStopCoverage,
                         testing::Values(Row{0, 0.5, 0.95}, Row{1, 0.5, 0.95}, Row{2, 0.5, 0.9}));

}  // namespace load_stop_coverage_test
}  // namespace floes
