#include "inference/tails.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include "core/random.hpp"
#include "core/units.hpp"

namespace floes {

namespace {

constexpr double lowest_pareto_shape = -0.5;
constexpr double highest_pareto_shape = 1;
constexpr double highest_weibull_shape = 8;
constexpr double lowest_weibull_shape = 0.2;
constexpr double small_shape = 1e-9;
constexpr int bits = 24;  // of a parameter's logarithm; its error by chance is far larger

/// Place of the least cost between `low` and `high`: the best of a grid, then Brent's method round it.
template <class Cost>
double least(Cost cost, double low, double high) {
    constexpr int grid = 24;
    const auto place = [&](int k) { return low + (high - low) * k / grid; };
    int best = 0;
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= grid; ++k) {
        if (const double found = cost(place(k)); found < lowest) {
            lowest = found;
            best = k;
        }
    }
    return boost::math::tools::brent_find_minima(cost, place(std::max(best - 1, 0)), place(std::min(best + 1, grid)),
                                                 bits)
        .first;
}

struct Fitted {
    double scale;
    double shape;
    double cost;  ///< - log likelihood
};

/// Peaks above the threshold.
struct Excesses {
    std::span<const double> values;
    std::span<const double> weights;
    double count = 0;  ///< sum of the weights

    /// Mean of a function of the excess.
    template <class Function>
    double mean(Function function) const {
        double sum = 0;
        for (std::size_t k = 0; k < values.size(); ++k) sum += weights[k] * function(values[k]);
        return sum / count;
    }
};

/// Where a rising function has a value: the end that is nearer, if it lies outside.
template <class Function>
double place_of(double value, Function rising, double low, double high) {
    const auto off = [&](double at) { return rising(at) - value; };
    const double at_low = off(low);
    if (at_low >= 0) return low;
    const double at_high = off(high);
    if (at_high <= 0) return high;
    std::uintmax_t steps = 60;
    const auto bracket = boost::math::tools::toms748_solve(off, low, high, at_low, at_high,
                                                           boost::math::tools::eps_tolerance<double>(50), steps);
    return 0.5 * (bracket.first + bracket.second);
}

/// The likeliest scale where the shape is given, and below 0: a largest excess is possible.
Fitted fit_pareto_scale(const Excesses& excesses, double shape, double largest) {
    const auto cost = [&](double log_scale) {
        const double slope = shape / std::exp(log_scale);
        return excesses.count *
               (log_scale + (1 + 1 / shape) * excesses.mean([&](double excess) { return std::log1p(slope * excess); }));
    };
    const double least_scale = std::log(-shape * largest) + small_shape;
    const double best = least(cost, least_scale, least_scale + std::log(100));
    return {std::exp(best), shape, cost(best)};
}

/// Grimshaw's profile (Technometrics 35 (1993) 185-191): given θ = ξ/σ the likeliest ξ is the mean of log(1 + θ e),
/// which rises with θ. The search is over w with θ = (e^w - 1) / largest excess, so w = 0 is the exponential.
Fitted fit_pareto(const Excesses& excesses) {
    const double largest = std::ranges::max(excesses.values);
    const double mean = excesses.mean([](double excess) { return excess; });
    const auto theta_at = [&](double w) { return std::expm1(w) / largest; };
    const auto shape_at = [&](double w) {
        return excesses.mean([theta = theta_at(w)](double excess) { return std::log1p(theta * excess); });
    };
    const auto at = [&](double w) -> Fitted {
        const double shape = shape_at(w);
        if (std::abs(shape) < small_shape) return {mean, 0, excesses.count * (std::log(mean) + 1)};
        const double scale = shape / theta_at(w);
        return {scale, shape, excesses.count * (std::log(scale) + shape + 1)};
    };
    const double low = place_of(lowest_pareto_shape, shape_at, -30, 0);
    const double high = place_of(highest_pareto_shape, shape_at, 0, 30);
    const Fitted found = at(least([&](double w) { return at(w).cost; }, low, high));
    constexpr double near = 1e-6;
    if (found.shape > lowest_pareto_shape + near) return found;
    // On the profile ξ is the likeliest for its θ; at the bound it is not, and the scale is to be found by itself.
    return fit_pareto_scale(excesses, lowest_pareto_shape, largest);
}

/// Given c the likeliest a^c is the mean of (d + e)^c - d^c, where d = u - b.
Fitted fit_weibull(const Excesses& excesses, double above_origin) {
    std::vector<double> logs;  // a power by its logarithm takes half the time
    for (const double excess : excesses.values) logs.push_back(std::log(above_origin + excess));
    const Excesses logarithms{logs, excesses.weights, excesses.count};
    const double mean_log = logarithms.mean([](double log) { return log; });
    const auto at = [&](double log_shape) -> Fitted {
        const double shape = std::exp(log_shape);
        const double mean =
            logarithms.mean([&](double log) { return std::exp(shape * log); }) - std::pow(above_origin, shape);
        return {std::pow(mean, 1 / shape), shape,
                excesses.count * (std::log(mean) - log_shape + 1 - (shape - 1) * mean_log)};
    };
    const double best = least([&](double log_shape) { return at(log_shape).cost; }, std::log(lowest_weibull_shape),
                              std::log(highest_weibull_shape));
    return at(best);
}

}  // namespace

Tail fit_tail(TailKind kind, std::span<const double> excesses, std::span<const double> weights, double threshold,
              double origin, double time) {
    const Excesses peaks{excesses, weights, std::accumulate(weights.begin(), weights.end(), 0.0)};
    Tail tail{.kind = kind,
              .threshold = threshold,
              .rate = peaks.count / time,
              .origin = origin,
              .scale = undefined,
              .shape = undefined,
              .log_likelihood = undefined};
    if (excesses.size() < fewest_peaks || std::ranges::min(excesses) == std::ranges::max(excesses)) return tail;
    const Fitted found = kind == TailKind::pareto ? fit_pareto(peaks) : fit_weibull(peaks, threshold - origin);
    if (!std::isfinite(found.cost)) return tail;
    tail.scale = found.scale;
    tail.shape = found.shape;
    tail.log_likelihood = -found.cost;
    return tail;
}

double rate_above(const Tail& tail, double x) {
    const double excess = x - tail.threshold;
    if (excess <= 0) return tail.rate;
    if (tail.kind == TailKind::weibull)
        return tail.rate * std::exp(std::pow((tail.threshold - tail.origin) / tail.scale, tail.shape) -
                                    std::pow((x - tail.origin) / tail.scale, tail.shape));
    if (std::abs(tail.shape) < small_shape) return tail.rate * std::exp(-excess / tail.scale);
    return tail.rate * std::pow(std::max(0.0, 1 + tail.shape * excess / tail.scale), -1 / tail.shape);
}

double level_at(const Tail& tail, double rate) {
    const double rarer = std::log(tail.rate / rate);
    if (rarer <= 0) return tail.threshold;
    if (tail.kind == TailKind::weibull)
        return tail.origin +
               tail.scale *
                   std::pow(std::pow((tail.threshold - tail.origin) / tail.scale, tail.shape) + rarer, 1 / tail.shape);
    if (std::abs(tail.shape) < small_shape) return tail.threshold + tail.scale * rarer;
    return tail.threshold + tail.scale / tail.shape * std::expm1(tail.shape * rarer);
}

double quantile_of_largest(const Tail& tail, double exposure, double p) {
    return level_at(tail, -std::log(p) / exposure);
}

namespace {

/// The integral of the quantile over p, with p = exp(-e^t): the trapezoid rule is exact to many digits for it. `first`:
/// the largest is beyond with probability e^first. `quantile`: of the load that is exceeded so often as e^t says.
template <class Quantile>
double mean_of_largest(double first, double step, int count, Quantile quantile) {
    double sum = 0;
    for (int k = 0; k < count; ++k) {
        const double y = std::exp(first + step * k);
        sum += quantile(y) * y * std::exp(-y) * step;
    }
    return sum;
}

}  // namespace

double expected_largest(const Tail& tail, double exposure) {
    // To t = 4, where p is e^-54.
    return mean_of_largest(-34, 0.125, 304, [&](double y) { return level_at(tail, y / exposure); });
}

namespace {

constexpr double shape_sd = 0.3;
constexpr double lowest_shape = -0.8;
constexpr double highest_shape = 0.7;
constexpr double log_weibull_middle = 0.34657359;  // √2
constexpr double log_weibull_sd = 0.5;
constexpr double scatter_sd = 0.3;
constexpr double small = 1e-6;
constexpr double impossible = -std::numeric_limits<double>::infinity();

struct Node {
    double at;  ///< standard normal
    double share;
};

/// The standard normal distribution in equal steps.
template <int node_count>
std::array<Node, node_count> make_nodes() {
    std::array<Node, node_count> nodes{};
    double sum = 0;
    for (int k = 0; k < node_count; ++k) {
        const double at = 0.6 * (k - node_count / 2);
        nodes[static_cast<std::size_t>(k)] = {at, std::exp(-at * at / 2)};
        sum += std::exp(-at * at / 2);
    }
    for (Node& node : nodes) node.share /= sum;
    return nodes;
}
constexpr int node_count = 11;
const std::array<Node, node_count> nodes = make_nodes<node_count>();
const std::array<Node, 21> far_nodes = make_nodes<21>();

std::span<const Node> nodes_of(Scales scales) {
    return scales == Scales::far ? std::span<const Node>(far_nodes) : std::span<const Node>(nodes);
}

/// H(y) and log of its derivative; infinite beyond an upper bound, or below where the tail begins.
struct Hazard {
    double sum;
    double log_now;
};

/// The hazard of a tail at any place.
class Hazards {
  public:
    explicit Hazards(const UnlikeTail& tail) : tail_(tail), log_scale_(std::log(tail.scale)) {}

    Hazard at(double y) const {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        if (tail_.kind == TailKind::weibull) {
            const double d = tail_.threshold - tail_.origin;
            const double grown = 1 + y / d;
            if (grown <= 0) return {-d / (tail_.shape * tail_.scale), impossible};
            const double log_grown = std::log(grown);
            return {d / (tail_.shape * tail_.scale) * std::expm1(tail_.shape * log_grown),
                    (tail_.shape - 1) * log_grown - log_scale_};
        }
        if (std::abs(tail_.shape) < small) return {y / tail_.scale, -log_scale_};
        const double grown = 1 + tail_.shape / tail_.scale * y;
        if (grown <= 0) return {tail_.shape < 0 ? infinite : -infinite, impossible};
        const double log_grown = std::log(grown);
        return {log_grown / tail_.shape, -log_grown - log_scale_};
    }

    /// λ(x; s)
    double rate(double x, double s) const { return tail_.rate * std::exp(-at(x / s - tail_.threshold).sum); }

    const UnlikeTail& tail() const { return tail_; }

  private:
    const UnlikeTail& tail_;
    double log_scale_;
};

/// The likelihood of the members of a class. What does not depend on their peaks is found once for all of them: most
/// have none above the threshold.
class ClassLikelihood {
  public:
    /// `part`: of an event of unit weight.
    ClassLikelihood(const Hazards& hazards, const TailData& data, bool out, double part)
        : hazards_(hazards), part_(part) {
        const UnlikeTail& tail = hazards.tail();
        const double middle = out ? tail.out_factor : 1;
        const double scatter = out ? tail.out_scatter : tail.scatter;
        count_ = scatter == 0 ? 1 : node_count;
        for (std::size_t k = 0; k < count_; ++k) {
            const double s = scatter == 0 ? middle : middle * std::exp(scatter * nodes[k].at);
            scales_[k] = {s, -data.window * hazards.rate(out ? data.out_threshold : data.threshold, s),
                          std::log(tail.rate / s)};
        }
        without_peaks_ = mean_over_scales({});
    }

    double log_of(const MemberPeaks& member) const {
        return member.peaks.empty() ? without_peaks_ : mean_over_scales(member);
    }

  private:
    struct Scale {
        double s;
        double without_peaks;  ///< log likelihood
        double each;           ///< log (R / s)
    };

    double log_at(const Scale& scale, const MemberPeaks& member) const {
        double sum = scale.without_peaks;
        for (std::size_t k = 0; k < member.peaks.size(); ++k) {
            const Hazard hazard = hazards_.at(member.peaks[k] / scale.s - hazards_.tail().threshold);
            sum += member.weights[k] * (scale.each - hazard.sum + hazard.log_now);
        }
        return part_ * (std::isnan(sum) ? impossible : sum);
    }

    /// Log of the mean over the member's scale.
    double mean_over_scales(const MemberPeaks& member) const {
        if (count_ == 1) return log_at(scales_[0], member);
        std::array<double, node_count> logs{};
        for (std::size_t k = 0; k < count_; ++k) logs[k] = log_at(scales_[k], member);
        const double most = *std::ranges::max_element(logs);
        if (!std::isfinite(most)) return impossible;
        double sum = 0;
        for (std::size_t k = 0; k < count_; ++k) sum += nodes[k].share * std::exp(logs[k] - most);
        return most + std::log(sum);
    }

    const Hazards& hazards_;
    double part_;
    std::size_t count_ = 1;
    std::array<Scale, node_count> scales_{};
    double without_peaks_ = 0;
};

double log_prior(const UnlikeTail& tail, std::span<const double> at) {
    const auto normal = [](double value, double sd) { return -0.5 * value * value / (sd * sd) - std::log(sd); };
    double sum = normal(at[3], scatter_sd);
    if (at.size() > 4) sum += normal(at[5], scatter_sd);
    if (tail.kind == TailKind::weibull) return sum + normal(std::log(tail.shape) - log_weibull_middle, log_weibull_sd);
    if (tail.shape < lowest_shape || tail.shape > highest_shape) return impossible;
    return sum + normal(tail.shape, shape_sd);
}

/// log R, log σ, shape, SD of log s; then for a class that stands out the log of its factor, and its SD.
UnlikeTail tail_of(TailKind kind, const TailData& data, std::span<const double> at) {
    UnlikeTail tail{.kind = kind, .threshold = data.threshold, .origin = data.origin};
    tail.rate = std::exp(at[0]);
    tail.scale = std::exp(at[1]);
    tail.shape = kind == TailKind::weibull ? std::exp(at[2]) : at[2];
    tail.scatter = std::max(at[3], 0.0);
    if (at.size() > 4) {
        tail.out_factor = std::exp(at[4]);
        tail.out_scatter = std::max(at[5], 0.0);
    }
    return tail;
}

/// What is seen of a class.
struct Seen {
    double events = 0;
    double squares = 0;  ///< of the weights
    double excess = 0;   ///< sum
    double members = 0;

    Seen(const TailData& data, bool out) {
        for (const MemberPeaks& member : data.members) {
            if (member.stands_out != out) continue;
            ++members;
            for (std::size_t k = 0; k < member.peaks.size(); ++k) {
                events += member.weights[k];
                squares += member.weights[k] * member.weights[k];
                excess += member.weights[k] * (member.peaks[k] - (out ? data.out_threshold : data.threshold));
            }
        }
    }
};

/// Gamma with shape k >= 1/2 and scale 1: G. Marsaglia and W. W. Tsang, ACM TOMS 26 (2000) 363-372.
double gamma(RandomStream& random, double k) {
    if (k < 1) return gamma(random, k + 1) * std::pow(1 - random.uniform(), 1 / k);
    const double d = k - 1.0 / 3;
    const double c = 1 / std::sqrt(9 * d);
    while (true) {
        const double z = std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * M_PI * random.uniform());
        const double v = std::pow(1 + c * z, 3);
        if (v > 0 && std::log(1 - random.uniform()) < 0.5 * z * z + d - d * v + d * std::log(v)) return d * v;
    }
}

}  // namespace

UnlikeTails draw_tails(TailKind kind, const TailData& data, const WalkOptions& options) {
    const Seen usual(data, false);
    const Seen out(data, true);
    UnlikeTails made;
    if (usual.events <= 0 || usual.excess <= 0 || (out.members > 0 && out.events <= 0)) return made;
    // Weights count hidden events as if they had been seen; the likelihood is flattened by as much.
    const double part = (usual.events + out.events) / (usual.squares + out.squares);
    const auto density = [&](std::span<const double> at) {
        const UnlikeTail tail = tail_of(kind, data, at);
        double sum = log_prior(tail, at);
        const Hazards hazards(tail);
        const ClassLikelihood of_usual(hazards, data, false, part), of_out(hazards, data, true, part);
        for (const MemberPeaks& member : data.members) {
            if (!std::isfinite(sum)) return impossible;
            sum += (member.stands_out ? of_out : of_usual).log_of(member);
        }
        return sum;
    };
    const double few = 1 / std::sqrt(usual.events);
    std::vector<double> start{std::log(usual.events / (usual.members * data.window)),
                              std::log(usual.excess / usual.events), kind == TailKind::weibull ? 0.1 : 0.0, 0.1};
    std::vector<double> sizes{few, few, few, 0.1};
    if (out.members > 0) {
        start.insert(start.end(), {std::log(data.out_threshold / data.threshold), 0.2});
        sizes.insert(sizes.end(), {0.1, 0.2});
    }
    const Walk walk = walk_at_random(density, start, sizes, options);
    RandomStream random{33, options.draw, StreamId::bootstrap, 1};
    for (const std::vector<double>& at : walk.draws) {
        UnlikeTail& tail = made.draws.emplace_back(tail_of(kind, data, at));
        if (out.members == 0) continue;
        const double one = gamma(random, out.members + 0.5);
        tail.out_share = one / (one + gamma(random, usual.members + 0.5));
    }
    made.log_evidence = walk.log_evidence;
    return made;
}

namespace {

/// Log of the probability that a member's largest peak stays below x, where that is nearly impossible.
double log_hardly_below(const Hazards& hazards, double window, double x, Scales scales) {
    const UnlikeTail& tail = hazards.tail();
    std::vector<double> logs;
    const auto add = [&](double share, double middle, double scatter) {
        for (const Node& node : nodes_of(scales))
            logs.push_back(std::log(share * node.share) -
                           window * hazards.rate(x, middle * std::exp(scatter * node.at)));
    };
    add(1 - tail.out_share, 1, tail.scatter);
    if (tail.out_share > 0) add(tail.out_share, tail.out_factor, tail.out_scatter);
    const double most = *std::ranges::max_element(logs);
    if (!std::isfinite(most)) return impossible;
    double sum = 0;
    for (const double one : logs) sum += std::exp(one - most);
    return most + std::log(sum);
}

}  // namespace

double log_below(const UnlikeTail& tail, double window, double members, double x, Scales scales) {
    constexpr double nearly_all = 1 - 1e-12;
    const Hazards hazards(tail);
    const auto above = [&](double middle, double scatter) {
        if (scatter == 0) return -std::expm1(-window * hazards.rate(x, middle));
        double sum = 0;
        for (const Node& node : nodes_of(scales))
            sum -= node.share * std::expm1(-window * hazards.rate(x, middle * std::exp(scatter * node.at)));
        return sum;
    };
    double sum = (1 - tail.out_share) * above(1, tail.scatter);
    if (tail.out_share > 0) sum += tail.out_share * above(tail.out_factor, tail.out_scatter);
    return members * (sum < nearly_all ? std::log1p(-sum) : log_hardly_below(hazards, window, x, scales));
}

double largest_at(const UnlikeTail& tail, double window, double members, double log_p) {
    return halved_from(tail.threshold, 24, [&](double x) { return log_below(tail, window, members, x) < log_p; });
}

double mean_largest(const UnlikeTail& tail, double window, double members) {
    return mean_of_largest(-15, 0.75, 25, [&](double y) { return largest_at(tail, window, members, -y); });
}

namespace {

constexpr double u_step = 1e-3;  // of u
constexpr std::size_t last = 3000;

struct Table {
    std::array<double, last + 1> kept{};  ///< θ
    std::array<double, last + 1> seen{};  ///< θ'
};

double exponent_slope(double v) {
    return v < 1e-8 ? 1 : -std::expm1(-v) / v;
}

/// By the trapezoid rule, whose error here is below 1e-7.
Table tabulated() {
    Table table;
    double exponent = 0;
    table.seen[0] = 1;
    for (std::size_t k = 1; k <= last; ++k) {
        const double u = u_step * static_cast<double>(k);
        exponent += 0.5 * u_step * (exponent_slope(u - u_step) + exponent_slope(u));
        table.seen[k] = std::exp(-2 * exponent);
        table.kept[k] = table.kept[k - 1] + 0.5 * u_step * (table.seen[k - 1] + table.seen[k]);
    }
    return table;
}

}  // namespace

double events_per_peak(double kept) {
    static const Table table = tabulated();
    const auto above = std::ranges::upper_bound(table.kept, kept);
    if (above == table.kept.begin()) return 1;
    if (above == table.kept.end()) return 1 / table.seen.back();
    const auto k = static_cast<std::size_t>(above - table.kept.begin());
    const double part = (kept - table.kept[k - 1]) / (table.kept[k] - table.kept[k - 1]);
    return 1 / (table.seen[k - 1] + part * (table.seen[k] - table.seen[k - 1]));
}

}  // namespace floes
