#include "inference/joint_inputs.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>

#include "core/contract.hpp"
#include "inference/numerics.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Probability that a standard normal variable is above u.
double above(double u) {
    return 0.5 * std::erfc(u / std::numbers::sqrt2);
}

/// The score that is exceeded with this probability.
double score_exceeded(double probability) {
    if (probability <= 0) return infinite;
    if (probability >= 1) return -infinite;
    return normal_quantile_above(probability);
}

/// -log of the probability above u, exact also where that is nearly 1.
double hazard_at(double u) {
    return u < 0 ? -std::log1p(-above(-u)) : -std::log(above(u));
}

double score_of_hazard(double hazard) {
    return hazard > 0.5 ? score_exceeded(std::exp(-hazard)) : -score_exceeded(-std::expm1(-hazard));
}

}  // namespace

std::string_view name_of(InputLaw law) {
    constexpr std::array<std::string_view, 4> names{"normal", "lognormal", "weibull", "exponential"};
    return names.at(static_cast<std::size_t>(law));
}

bool InputDistribution::valid(double given) const {
    const double one = first.at(given);
    const double two = second.at(given);
    if (!std::isfinite(one)) return false;
    if (law == InputLaw::exponential) return one > 0;
    return std::isfinite(two) && two > 0 && (law == InputLaw::normal || one > 0);
}

double InputDistribution::value(double score, double given) const {
    const double one = first.at(given);
    const double two = second.at(given);
    switch (law) {
        case InputLaw::normal:
            return one + two * score;
        case InputLaw::lognormal:
            return one * std::exp(two * score);
        case InputLaw::weibull:
            return one * std::pow(hazard_at(score), 1 / two);
        case InputLaw::exponential:
            break;
    }
    return one * hazard_at(score);
}

double InputDistribution::score(double x, double given) const {
    const double one = first.at(given);
    const double two = second.at(given);
    if (law == InputLaw::normal) return (x - one) / two;
    if (x <= 0) return -infinite;
    if (law == InputLaw::lognormal) return std::log(x / one) / two;
    return score_of_hazard(law == InputLaw::weibull ? std::pow(x / one, two) : x / one);
}

double InputDistribution::between(double low, double high, double given) const {
    const double from = score(low, given);
    const double to = score(high, given);
    return from > 0 ? above(from) - above(to) : above(-to) - above(-from);
}

std::array<double, 2> JointInputs::at(double one_score, double other_score) const {
    const double first = one.value(one_score, 0);
    return {first, other.value(other_score, first)};
}

double contour_radius(double per_year, double states) {
    return score_exceeded(-std::expm1(std::log1p(-per_year) / states));
}

std::vector<ContourPoint> contour(const JointInputs& inputs, double radius, int count) {
    FLOES_EXPECTS(radius > 0 && count >= 3);
    std::vector<ContourPoint> points;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        points.push_back({360.0 * k / count, inputs.at(radius * std::cos(angle), radius * std::sin(angle))});
    }
    return points;
}

namespace {

constexpr double least_probability = 1e-300;
constexpr SimplexOptions walk{.size = 0.3, .small_enough = 1e-9};
constexpr std::size_t classes_for_scatter = 3;  // of `one`, with several of `other`, for a scatter that depends on it

struct Border {
    double low;
    double high;
};

/// The borders of the class about each value: halfway to its neighbours, and as far outwards at the ends.
std::map<double, Border> borders_of(const std::vector<ClassHours>& classes, std::size_t input) {
    std::map<double, Border> borders;
    for (const ClassHours& one : classes) borders[one.value[input]] = {};
    for (auto here = borders.begin(); here != borders.end(); ++here) {
        const auto next = std::next(here);
        if (next != borders.end()) here->second.high = next->second.low = (here->first + next->first) / 2;
    }
    auto& [first, first_border] = *borders.begin();
    auto& [last, last_border] = *borders.rbegin();
    first_border.low = std::max(0.0, 2 * first - first_border.high);
    last_border.high = 2 * last - last_border.low;
    return borders;
}

double all_hours(const std::vector<ClassHours>& classes) {
    double all = 0;
    for (const ClassHours& one : classes) all += one.hours;
    return all;
}

/// Mean of the hours' - log likelihood, of the law of one of the inputs, given the first.
double cost_of(const InputDistribution& law, const std::vector<ClassHours>& classes,
               const std::map<double, Border>& borders, std::size_t input) {
    const double all = all_hours(classes);
    double sum = 0;
    for (const ClassHours& part : classes) {
        const Border& border = borders.at(part.value[input]);
        const double share = law.between(border.low, border.high, part.value[0]);
        sum -= part.hours / all * std::log(std::max(share, least_probability));
    }
    return sum;
}

struct OneFit {
    InputDistribution law;
    double cost;
};

/// `mean`: of the input, a start.
OneFit fit_one(InputLaw law, const std::vector<ClassHours>& classes, const std::map<double, Border>& borders,
               double mean) {
    const auto of = [&](std::span<const double> at) {
        return InputDistribution{law, {.a = mean * std::exp(at[0])}, {.a = std::exp(at[1])}};
    };
    const auto cost = [&](std::span<const double> at) { return cost_of(of(at), classes, borders, 0); };
    const std::vector<double> start{0, law == InputLaw::weibull ? std::log(2.0) : std::log(0.5)};
    const Minimum found = walk_simplex(cost, start, walk);
    return {of(found.at), found.cost};
}

/// Whether enough classes of `one` have several of `other`.
bool scatter_varies(const std::vector<ClassHours>& classes) {
    std::map<double, int> count;
    for (const ClassHours& one : classes) ++count[one.value[0]];
    return std::ranges::count_if(count, [](const auto& one) { return one.second > 1; }) >=
           static_cast<std::ptrdiff_t>(classes_for_scatter);
}

/// `middle`: geometric means of both inputs, so that the parameters hardly depend on each other.
InputDistribution fit_other(const std::vector<ClassHours>& classes, const std::array<double, 2>& middle,
                            bool scatter_fixed) {
    const std::map<double, Border> borders = borders_of(classes, 1);
    const auto of = [&](std::span<const double> at) {
        const double power = scatter_fixed ? 0 : at[3];
        const double sd = std::exp(at[2]) * std::pow(middle[0], -power);
        return InputDistribution{InputLaw::lognormal,
                                 {0, middle[1] * std::exp(at[0]) * std::pow(middle[0], -at[1]), at[1]},
                                 scatter_fixed ? SmoothParameter{.a = sd} : SmoothParameter{0, sd, power}};
    };
    const auto cost = [&](std::span<const double> at) { return cost_of(of(at), classes, borders, 1); };
    std::vector<double> start{0, 0, std::log(0.5)};
    if (!scatter_fixed) start.push_back(0);
    return of(walk_simplex(cost, start, walk).at);
}

}  // namespace

bool JointFit::valid() const {
    return inputs.one.valid(0) && inputs.other.valid(inputs.one.value(0, 0));
}

JointFit fit_joint_inputs(const std::vector<ClassHours>& classes) {
    const std::map<double, Border> borders = borders_of(classes, 0);
    const double all = all_hours(classes);
    double mean = 0;
    std::array<double, 2> log_middle{};
    for (const ClassHours& one : classes) {
        mean += one.hours / all * one.value[0];
        for (std::size_t k = 0; k < 2; ++k) log_middle[k] += one.hours / all * std::log(one.value[k]);
    }
    const OneFit weibull = fit_one(InputLaw::weibull, classes, borders, mean);
    const OneFit lognormal = fit_one(InputLaw::lognormal, classes, borders, mean);
    JointFit made;
    made.inputs.one = weibull.cost <= lognormal.cost ? weibull.law : lognormal.law;
    made.ahead = std::abs(weibull.cost - lognormal.cost);
    made.scatter_fixed = !scatter_varies(classes);
    made.inputs.other = fit_other(classes, {std::exp(log_middle[0]), std::exp(log_middle[1])}, made.scatter_fixed);
    for (const auto& [value, border] : borders)
        made.classes.push_back({value, 0, all * made.inputs.one.between(border.low, border.high, 0)});
    for (const ClassHours& one : classes)
        std::ranges::find(made.classes, one.value[0], &ClassCheck::value)->hours += one.hours;
    return made;
}

}  // namespace floes
