// Joint distributions from the hours of a scatter diagram.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "inference/joint_inputs.hpp"
#include "inference/simplex.hpp"

namespace floes {
namespace {

constexpr double least_probability = 1e-300;
constexpr SimplexOptions walk{.size = 0.3, .small_enough = 1e-9, .most_costs = 4000};
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

struct OneFit {
    InputDistribution law;
    double cost;
};

/// `mean`: of the input, a start.
OneFit fit_one(InputLaw law, const std::vector<ClassHours>& classes, const std::map<double, Border>& borders,
               double mean) {
    const double all = all_hours(classes);
    const auto of = [&](std::span<const double> at) {
        return InputDistribution{law, {.a = mean * std::exp(at[0])}, {.a = std::exp(at[1])}};
    };
    const auto cost = [&](std::span<const double> at) {
        const InputDistribution one = of(at);
        double sum = 0;
        for (const ClassHours& part : classes) {
            const Border& border = borders.at(part.value[0]);
            sum -= part.hours / all * std::log(std::max(one.between(border.low, border.high, 0), least_probability));
        }
        return sum;
    };
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
    const double all = all_hours(classes);
    const auto of = [&](std::span<const double> at) {
        const double power = scatter_fixed ? 0 : at[3];
        const double sd = std::exp(at[2]) * std::pow(middle[0], -power);
        return InputDistribution{InputLaw::lognormal,
                                 {0, middle[1] * std::exp(at[0]) * std::pow(middle[0], -at[1]), at[1]},
                                 scatter_fixed ? SmoothParameter{.a = sd} : SmoothParameter{0, sd, power}};
    };
    const auto cost = [&](std::span<const double> at) {
        const InputDistribution other = of(at);
        double sum = 0;
        for (const ClassHours& part : classes) {
            const Border& border = borders.at(part.value[1]);
            sum -= part.hours / all *
                   std::log(std::max(other.between(border.low, border.high, part.value[0]), least_probability));
        }
        return sum;
    };
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
