// How often the intervals of both tails hold where members are few or differ: lists of peaks of known truth, in windows
// of 150 s, for the load that 1, 10 and 100 times the time run exceed with 10 %. docs/design_load.md has the table.
// Label slow: FLOES_TRIALS gives the trials of each row.

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
namespace unlike_coverage_test {

constexpr double window = 150;
constexpr double peaks_a_member = 20;
constexpr double base = 10;  // N, the mean load; peaks are above it
constexpr double jam = 5;    // times the load
constexpr std::array times{1.0, 10.0, 100.0};

/// Peaks 10 + 20 w, in N: w Weibull with shape 1.5, or generalised Pareto.
struct Kind {
    const char* name;
    bool pareto;
    double shape;
    double scatter;  ///< SD of the logarithm of a member's scale
    double jams;     ///< share of members at `jam` times the load

    double peak(double hazard) const {
        return base + 20 * (pareto ? std::expm1(shape * hazard) / shape : std::pow(hazard, 1 / shape));
    }
    double hazard(double x) const {
        const double w = std::max(0.0, (x - base) / 20);
        if (!pareto) return std::pow(w, shape);
        return 1 + shape * w > 0 ? std::log1p(shape * w) / shape : 1e300;
    }
    /// Probability that a member has a peak above x.
    double above(double x) const {
        double sum = 0, all = 0;
        for (double z = -4; z <= 4; z += 0.02) {
            const double weight = std::exp(-z * z / 2), s = std::exp(scatter * z);
            const auto at = [&](double scale) { return -std::expm1(-peaks_a_member * std::exp(-hazard(x / scale))); };
            sum += weight * ((1 - jams) * at(s) + jams * at(jam * s));
            all += weight;
        }
        return sum / all;
    }
    double truth(double members) const {
        double low = base, high = 1e6;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (members * std::log1p(-above(middle)) < std::log(0.9) ? low : high) = middle;
        }
        return low;
    }
};

const std::array kinds{Kind{"5 % of members at 5 times the load", false, 1.5, 0, 0.05},
                       Kind{"members alike, Weibull peaks", false, 1.5, 0, 0},
                       Kind{"members' scale varies by 30 %", false, 1.5, 0.3, 0},
                       Kind{"limited, ξ -0.4", true, -0.4, 0, 0}, Kind{"heavy, ξ 0.3", true, 0.3, 0, 0}};

struct Members {
    std::vector<std::vector<double>> peaks;
    std::vector<std::size_t> jammed;
    double mean = 0;
};

Members drawn(const Kind& kind, std::size_t count, std::uint32_t trial) {
    RandomStream random{34, trial, StreamId::bootstrap, count};
    Members made;
    for (std::size_t row = 0; row < count; ++row) {
        double scale = std::exp(kind.scatter * known::normal(random));
        if (random.uniform() < kind.jams) {
            scale *= jam;
            made.jammed.push_back(row);
        }
        std::vector<double>& peaks = made.peaks.emplace_back();
        for (double at = known::exponential(random); at < peaks_a_member; at += known::exponential(random))
            peaks.push_back(scale * kind.peak(known::exponential(random)));
        std::ranges::sort(peaks, std::ranges::greater{});
        made.mean += scale * base / static_cast<double>(count);
    }
    return made;
}

struct Row {
    std::size_t kind;
    std::size_t members;
    double least;  ///< share of the intervals that hold, above which the row passes
};

class UnlikeCoverage : public testing::TestWithParam<Row> {};

/// Of one exposure.
struct Held {
    int within = 0;
    int below = 0;
    std::vector<double> centre;  ///< over the truth
    std::vector<double> width;   ///< upper over lower end
};

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return quantile_of_sorted(values, 0.5);
}

TEST_P(UnlikeCoverage, IsAsTheIntervalsSay) {
    const auto [number, members, least] = GetParam();
    const Kind& kind = kinds[number];
    const char* given = std::getenv("FLOES_TRIALS");
    const int trials = given != nullptr ? std::atoi(given) : 40;
    std::array<Held, times.size()> held;
    std::array<double, times.size()> truths{};
    for (std::size_t k = 0; k < times.size(); ++k) truths[k] = kind.truth(times[k] * static_cast<double>(members));
    int used = 0, unlike = 0;
    for (std::uint32_t trial = 0; used < trials; ++trial) {
        const Members made = drawn(kind, members, trial);
        if (kind.jams > 0 && made.jammed.empty()) continue;  // no sample says what is not in it
        ++used;
        const UnlikeMembers found = unlike_members(known::spans(made.peaks), 0.25);
        unlike += found.out != made.jammed;
        const PosteriorLoad load(known::spans(made.peaks), found.out, {window, 1e-9, made.mean, {0.5, 0.25, 0.1}});
        for (std::size_t k = 0; k < times.size(); ++k) {
            const LoadFigure figure = load.quantile(times[k] * static_cast<double>(members) * window, 0.9);
            held[k].within += figure.interval.low <= truths[k] && truths[k] <= figure.interval.high;
            held[k].below += figure.interval.high < truths[k];
            held[k].centre.push_back(figure.value / truths[k]);
            held[k].width.push_back(figure.interval.high / figure.interval.low);
        }
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        fmt::print("| unlike | {} | {} | {:g} | {:.0f} % | {:.0f} % | {:+.0f} % | {:.1f} | {:.0f} % |\n", kind.name,
                   members, times[k], 100.0 * held[k].within / used, 100.0 * held[k].below / used,
                   100 * (median(held[k].centre) - 1), median(held[k].width), 100.0 * unlike / used);
        EXPECT_GE(static_cast<double>(held[k].within) / used, least - 3 * std::sqrt(least * (1 - least) / used));
    }
    std::fflush(stdout);
    EXPECT_LE(unlike, 0.05 * used + 3 * std::sqrt(0.05 * used));
}

INSTANTIATE_TEST_SUITE_P(Rows, UnlikeCoverage,
                         testing::Values(Row{0, 8, 0.92}, Row{0, 12, 0.92}, Row{0, 20, 0.92}, Row{0, 50, 0.92},
                                         Row{1, 4, 0.92}, Row{1, 8, 0.92}, Row{1, 12, 0.92}, Row{1, 20, 0.92},
                                         Row{1, 50, 0.92}, Row{2, 4, 0.88}, Row{2, 8, 0.92}, Row{2, 12, 0.92},
                                         Row{2, 20, 0.92}, Row{2, 50, 0.92}, Row{3, 8, 0.92}, Row{3, 100, 0.92},
                                         Row{4, 8, 0.88}, Row{4, 50, 0.88}));

}  // namespace unlike_coverage_test
}  // namespace floes
