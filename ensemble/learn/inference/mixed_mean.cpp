#include "inference/mixed_mean.hpp"

#include <algorithm>
#include <array>
#include <boost/random/gamma_distribution.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>

#include "core/random.hpp"
#include "inference/bootstrap.hpp"
#include "inference/unlike_members.hpp"
#include "statistics/means.hpp"

namespace floes {
namespace {

constexpr int draws = 4000;
constexpr std::uint32_t own_draws = 0x6d6978;  // none that a bootstrap uses
constexpr double jeffreys = 0.5;
constexpr double usual_scatter = 0.3;  // of the logarithm, of members of a kind
constexpr double worth = 2;            // members
constexpr double largest_log = 50;     // of a distance that a draw may have, over those seen

/// A sample's mean, sample SD and size.
struct Moments {
    double mean = 0;
    double sd = 0;
    double count = 0;

    explicit Moments(std::span<const double> values)
        : mean(mean_of(values)), count(static_cast<double>(values.size())) {
        if (count > 1) sd = population_sd(values, mean) * std::sqrt(count / (count - 1));
    }
    double freedom() const { return std::max(1.0, count - 1); }
};

/// 32 random bits a call, as Boost's distributions take them.
class Bits {
  public:
    using result_type = std::uint32_t;
    explicit Bits(std::size_t number) : random_{0, own_draws, StreamId::bootstrap, number} {}
    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return 0xffffffffu; }
    result_type operator()() { return static_cast<result_type>(random_.uniform() * 0x1p32); }

  private:
    RandomStream random_;
};

/// Draws of what is not known of the kinds.
class Draws {
  public:
    explicit Draws(std::size_t number) : bits_(number) {}

    double normal() { return normal_(bits_); }
    double gamma(double shape) { return boost::random::gamma_distribution<>{shape}(bits_); }
    double chi_squared(double freedom) { return 2 * gamma(freedom / 2); }
    double student(double freedom) {
        const double z = normal();
        return z / std::sqrt(chi_squared(freedom) / freedom);
    }
    double uniform() { return boost::random::uniform_01<>{}(bits_); }

  private:
    Bits bits_;
    boost::random::normal_distribution<> normal_;
};

std::vector<double> logarithms(std::span<const double> values) {
    std::vector<double> logs;
    for (const double value : values) logs.push_back(std::log(value));
    return logs;
}

std::vector<double> of_rows(std::span<const double> values, std::span<const std::size_t> rows) {
    std::vector<double> chosen;
    for (const std::size_t row : rows) chosen.push_back(values[row]);
    return chosen;
}

}  // namespace

Apart apart(std::span<const double> values, Sides sides) {
    if (values.size() > most_tested) return {};
    if (sides == Sides::both) {
        Apart found;
        if (values.empty()) return found;
        std::vector<double> rising(values.begin(), values.end());
        std::ranges::sort(rising);
        const double middle = quantile_of_sorted(rising, 0.5);
        for (const std::size_t row : rows_standing_apart(values))
            (values[row] > middle ? found.above : found.below).push_back(row);
        return found;
    }
    if (std::ranges::any_of(values, [](double value) { return !(value > 0); })) return {};
    return {rows_standing_out(logarithms(values)), {}};
}

Interval mixed_interval(std::span<const double> values, const Interval& plain, const Apart& apart, Sides sides,
                        double confidence) {
    if (apart.count() == 0) return plain;
    std::vector<double> usual, distances;
    for (std::size_t row = 0; row < values.size(); ++row)
        if (!std::ranges::binary_search(apart.above, row) && !std::ranges::binary_search(apart.below, row))
            usual.push_back(values[row]);
    const Moments of_usual(usual);
    for (const std::vector<std::size_t>* side : {&apart.above, &apart.below})
        for (const double value : of_rows(values, *side)) distances.push_back(std::abs(value - of_usual.mean));
    const Moments far(logarithms(distances));
    const double squares = worth * usual_scatter * usual_scatter + (far.count - 1) * far.sd * far.sd;

    Draws draw(values.size());
    std::vector<double> means, further;
    const Moments usual_logs(sides == Sides::above ? logarithms(usual) : std::vector<double>{0});
    for (int k = 0; k < draws; ++k) {
        const double above = draw.gamma(static_cast<double>(apart.above.size()) + jeffreys);
        const double below =
            sides == Sides::both ? draw.gamma(static_cast<double>(apart.below.size()) + jeffreys) : 0.0;
        const double others = draw.gamma(of_usual.count + jeffreys);
        const double all = above + below + others;
        const double variance = squares / draw.chi_squared(worth + far.count - 1);
        const double mean = of_usual.mean + of_usual.sd / std::sqrt(of_usual.count) * draw.student(of_usual.freedom());
        const double moved = std::clamp(std::sqrt(variance / far.count) * draw.normal(), -largest_log, largest_log);
        means.push_back(mean + (above - below) / all * std::exp(far.mean + moved));
        if (sides == Sides::both) continue;
        const double one = draw.normal();
        further.push_back(draw.uniform() < above / all
                              ? of_usual.mean +
                                    std::exp(far.mean + moved + std::min(largest_log, std::sqrt(variance) * one))
                              : std::exp(usual_logs.mean + usual_logs.sd * std::sqrt(1 + 1 / usual_logs.count) *
                                                               draw.student(usual_logs.freedom())));
    }
    const Limits limits = percentile_interval(std::move(means), confidence);
    Interval mixed = plain;
    mixed.low = std::min(limits.low, plain.estimate);
    mixed.high = std::max(limits.high, plain.estimate);
    if (!further.empty()) {
        const Limits next = percentile_interval(std::move(further), confidence);
        mixed.prediction_low = next.low;
        mixed.prediction_high = next.high;
    }
    return mixed;
}

}  // namespace floes
