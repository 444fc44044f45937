#include "findings/estimates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "inference/interval.hpp"

namespace floes {

Kind kind_of(const Quantity& quantity) {
    return {quantity.least, quantity.most, quantity.positive, quantity.unit == "N"};
}

Interval mean_over(std::vector<double> values, const Kind& kind) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });  // not measured
    const Interval plain = kind.positive ? positive_interval(values) : mean_interval(values);
    const Apart out = kind.load ? apart(values, Sides::above) : Apart{};
    return clipped(mixed_interval(values, plain, out, Sides::above), kind.least, kind.most);
}

Interval mean_over(const Sample& sample, const Members& members, const Quantity& quantity) {
    return mean_over(sample.values(members, quantity), kind_of(quantity));
}

bool says_something(double estimate, Limits limits, int runs, const Kind& kind) {
    constexpr double widest = 4;                                             // of the estimate
    if (limits.low <= kind.least && limits.high >= kind.most) return false;  // as wide as can be
    if (runs < fewest_for_interval || !std::isfinite(limits.low) || !std::isfinite(limits.high)) return false;
    const bool has_a_sign = kind.least < 0 && std::isfinite(kind.least);  // by its nature, as a correlation has
    const double size = has_a_sign ? limits.high - limits.low : estimate;
    return limits.high > limits.low && limits.high - limits.low <= widest * std::abs(size);
}

Estimate estimate(const Interval& found, int runs, const Kind& kind) {
    return {found.estimate, found.low, found.high, says_something(found.estimate, {found.low, found.high}, runs, kind)};
}

Estimate over(std::vector<double> values, const Kind& kind) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    const int runs = static_cast<int>(values.size());
    return estimate(mean_over(std::move(values), kind), runs, kind);
}

Estimate over(const Sample& sample, const Members& members, const Quantity& quantity) {
    return over(sample.values(members, quantity), kind_of(quantity));
}

std::string unit_of(const Quantity& quantity) {
    return quantity.percent ? "share" : std::string{quantity.unit};
}

ResultColumn column_of(const Quantity& quantity, ResultColumn::Holds holds) {
    return {.key = std::string{quantity.key.view()},
            .words = std::string{quantity.label.view()},
            .unit = unit_of(quantity),
            .holds = holds,
            .decimals = quantity.percent || quantity.count ? 1 : -1};
}

std::string change_text(const Estimate& change, const Units& units) {
    const auto number = [&](double value) { return (value < 0 ? "" : "+") + units.number(value, "N"); };
    return fmt::format("{} {}{}", number(change.value), units.of("N").name,
                       change.said && std::isfinite(change.low)
                           ? fmt::format(" ({} to {})", number(change.low), number(change.high))
                           : "");
}

ResultColumn estimates(std::string key, std::string words, std::string unit) {
    return {.key = std::move(key),
            .words = std::move(words),
            .unit = std::move(unit),
            .holds = ResultColumn::Holds::estimates};
}

}  // namespace floes
