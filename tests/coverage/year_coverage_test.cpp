// How often the intervals of the loads of a year hold: two regimes of which the truth is known, each with members of
// 150 s, for the loads that 10^-2 and 10^-4 of years exceed. docs/year.md has the result. Label slow: FLOES_TRIALS
// gives the trials of each row.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "inference/interval.hpp"
#include "inference/known_processes.hpp"
#include "inference/posterior_load.hpp"

namespace floes {
namespace year_coverage_test {

constexpr double window = 150;         // s
constexpr double peaks_a_member = 20;  // about so many in 150 s
constexpr double hour = 3600;
constexpr std::array levels{1e-2, 1e-4};

/// Peaks of times (10 + 20 w), in N: w Weibull, or generalised Pareto.
struct Ice {
    bool pareto;
    double shape;
    double scatter;  ///< SD of the logarithm of a member's scale
    double times;
    double hours;  ///< a year

    double peak(double hazard) const {
        return times * (10 + 20 * (pareto ? std::expm1(shape * hazard) / shape : std::pow(hazard, 1 / shape)));
    }
    double hazard(double x) const {
        const double w = std::max(0.0, (x / times - 10) / 20);
        if (!pareto) return std::pow(w, shape);
        return 1 + shape * w > 0 ? std::log1p(shape * w) / shape : 1e300;
    }
    /// Expected number of members of a year with a peak above x.
    double above(double x) const {
        double sum = 0, all = 0;
        for (double z = -5; z <= 5; z += 0.02) {
            const double weight = std::exp(-z * z / 2);
            sum += weight * -std::expm1(-peaks_a_member * std::exp(-hazard(x / std::exp(scatter * z))));
            all += weight;
        }
        return -hours * hour / window * std::log1p(-sum / all);
    }
};

struct YearOf {
    const char* name;
    std::array<Ice, 2> ice;

    double truth(double p) const {
        double low = 1, high = 1e7;
        for (int k = 0; k < 80; ++k) {
            const double middle = std::sqrt(low * high);
            (ice[0].above(middle) + ice[1].above(middle) > -std::log1p(-p) ? low : high) = middle;
        }
        return low;
    }
};

const std::array kinds{
    YearOf{"exponential and Weibull (c 1.5) peaks", {Ice{false, 1, 0, 1, 600}, Ice{false, 1.5, 0, 2, 60}}},
    YearOf{"Gaussian (c 2) and Weibull (c 1.5) peaks", {Ice{false, 2, 0, 1.5, 600}, Ice{false, 1.5, 0, 1, 60}}},
    YearOf{"limited (ξ -0.3), and Weibull (c 1.5)", {Ice{true, -0.3, 0, 2, 600}, Ice{false, 1.5, 0, 1, 60}}},
    YearOf{"members' scale varies by 20 %, and Weibull (c 1.5)",
           {Ice{false, 1.5, 0.2, 1, 600}, Ice{false, 1.5, 0, 1.5, 60}}},
    YearOf{"heavy (ξ 0.15), and exponential", {Ice{true, 0.15, 0, 1, 60}, Ice{false, 1, 0, 1, 600}}}};

PosteriorLoad run(const Ice& ice, std::size_t members, RandomStream& random) {
    std::vector<std::vector<double>> peaks(members);
    double mean = 0;
    for (std::vector<double>& own : peaks) {
        const double scale = std::exp(ice.scatter * known::normal(random));
        for (double at = known::exponential(random); at < peaks_a_member; at += known::exponential(random))
            own.push_back(scale * ice.peak(known::exponential(random)));
        std::ranges::sort(own, std::ranges::greater{});
        mean += 10 * ice.times * scale / static_cast<double>(members);
    }
    const auto spans = known::spans(peaks);
    return {spans, unlike_members(spans, 0.25).out, {window, 0, 0.01, mean}, averaged_shares(0.25, false)};
}

int trials() {
    const char* given = std::getenv("FLOES_TRIALS");
    return given != nullptr ? std::atoi(given) : 40;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return quantile_of_sorted(values, 0.5);
}

struct Row {
    std::size_t kind;
    std::size_t members;
};

class YearCoverage : public testing::TestWithParam<Row> {};

TEST_P(YearCoverage, IsAsTheIntervalsSay) {
    const auto [number, members] = GetParam();
    const YearOf& kind = kinds[number];
    const int count = trials();
    std::array<int, 2> within{}, below{};
    std::array<std::vector<double>, 2> centre, width;
    for (std::uint32_t trial = 0; trial < static_cast<std::uint32_t>(count); ++trial) {
        RandomStream random{63, trial, StreamId::bootstrap, 1000 * number + members};
        const PosteriorLoad one = run(kind.ice[0], members, random);
        const PosteriorLoad other = run(kind.ice[1], members, random);
        const std::array sources{&one, &other};
        const YearLoad year(sources, {{0, kind.ice[0].hours * hour}, {1, kind.ice[1].hours * hour}});
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const double truth = kind.truth(levels[k]);
            const LoadFigure found = year.load(levels[k]);
            within[k] += found.interval.low <= truth && truth <= found.interval.high;
            below[k] += found.interval.high < truth;
            centre[k].push_back(found.value / truth);
            width[k].push_back(found.interval.high / found.interval.low);
        }
    }
    for (std::size_t k = 0; k < levels.size(); ++k) {
        fmt::print("| year | {} | {} | {:g} | {:.0f} % | {:.0f} % | {:+.0f} % | {:.1f} |\n", kind.name, members,
                   levels[k], 100.0 * within[k] / count, 100.0 * below[k] / count, 100 * (median(centre[k]) - 1),
                   median(width[k]));
        EXPECT_GE(static_cast<double>(within[k]) / count, 0.85 - 3 * std::sqrt(0.85 * 0.15 / count)) << levels[k];
    }
    std::fflush(stdout);
}

INSTANTIATE_TEST_SUITE_P(Rows, YearCoverage,
                         testing::Values(Row{0, 12}, Row{0, 50}, Row{1, 12}, Row{1, 50}, Row{2, 12}, Row{2, 50},
                                         Row{3, 12}, Row{3, 50}, Row{4, 12}, Row{4, 50}));

}  // namespace year_coverage_test
}  // namespace floes
