#include "member/quantity.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>

namespace floes {
double Quantity::of(const MemberOutputs& outputs) const {
    if (averaging == 0) return place.get(outputs);
    const auto found = std::ranges::find(outputs.averaged, averaging, &AveragedLoad::time);
    return found == outputs.averaged.end() ? std::numeric_limits<double>::quiet_NaN() : averaged(*found);
}

bool Quantity::holds(double value) const {
    return !count || std::isnan(value) ||
           (value >= 0 && value <= std::numeric_limits<int>::max() && value == std::floor(value));
}

Quantity averaged_over(const Quantity& one, double time) {
    const std::string in_words = fmt::format("_{}s", time);
    Quantity made = one;
    made.key = ShortText{std::string_view{fmt::format("{}{}", one.key, in_words)}};
    made.label = ShortText{std::string_view{fmt::format("{} over {} s", one.label, time)}};
    made.shown = std::min(one.shown, Shown::in_pairs);
    made.averaging = time;
    made.for_programs = one.averaged == largest_of;  // people have the mean of the maxima
    return made;
}

std::vector<Quantity> quantities_with(std::span<const double> averaging_times) {
    constexpr double usual = 1;  // s
    std::vector<Quantity> all;
    for (const Quantity& one : quantities) {
        Quantity& of_steps = all.emplace_back(one);
        if (averaging_times.empty()) continue;
        if (one.key.view() == "maximum_load" || one.key.view().ends_with("_maximum")) {
            of_steps.label = ShortText{std::string_view{fmt::format("{} of single steps", one.label)}};
            of_steps.for_programs = true;
        }
        if (one.averaged == nullptr) continue;
        const bool takes_over = one.shown == Shown::in_headlines;
        if (takes_over) of_steps.shown = Shown::in_table3;
        const double headline =
            std::ranges::find(averaging_times, usual) != averaging_times.end() ? usual : averaging_times.back();
        for (const double time : averaging_times) {
            Quantity& averaged = all.emplace_back(averaged_over(one, time));
            if (takes_over && time == headline) averaged.shown = Shown::in_headlines;
        }
    }
    return all;
}

const Quantity& headline_maximum(std::span<const Quantity> all) {
    const auto found = std::ranges::find_if(all, [](const Quantity& one) {
        return one.shown == Shown::in_headlines && one.averaged == quantity("mean_maximum").averaged;
    });
    FLOES_EXPECTS(found != all.end());
    return *found;
}

std::optional<Quantity> any_quantity(std::string_view key) {
    if (const Quantity* const one = find_quantity(key)) return *one;
    const std::size_t place = key.rfind('_');
    if (place == std::string_view::npos) return {};
    const Quantity* const one = find_quantity(key.substr(0, place));
    double time = 0;
    std::from_chars(key.data() + place + 1, key.data() + key.size(), time);
    if (one == nullptr || one->averaged == nullptr || !(time > 0)) return {};
    const Quantity made = averaged_over(*one, time);
    return made.key.view() == key ? std::optional(made) : std::nullopt;
}

MemberOutputs unmeasured(int segments) {
    MemberOutputs outputs;
    outputs.load.steady = false;
    outputs.load.segment_maximum.assign(static_cast<std::size_t>(segments), std::numeric_limits<double>::quiet_NaN());
    for (const Quantity& one : quantities) one.place.set(outputs, std::numeric_limits<double>::quiet_NaN());
    return outputs;
}

}  // namespace floes
