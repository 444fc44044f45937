// What members need of memory, and in words what they cost, and would cost with other elements and windows.

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/case_words.hpp"
#include "core/text.hpp"
#include "run/plan.hpp"
#include "scenario/floes.hpp"
#include "scenario/validate.hpp"

namespace floes {

namespace {

constexpr double dear = 60;         // s a member, from which on its cost is said
constexpr double dear_moored = 10;  // likewise of a hull that gives way, whose windows become long
constexpr std::size_t most_cases_said = 8;

/// To so many significant digits.
double to_two_digits(double value) {
    return std::stod(fmt::format("{:.2g}", value));
}

/// A campaign of one case.
Campaign alone(const Campaign& campaign, const Scenario& scenario) {
    Campaign one{{campaign.name, campaign.seed, 1}, {}};
    one.cases.push_back({"one", scenario});
    return one;
}

double run_time(const Campaign& campaign, const Scenario& scenario) {
    return expected_run_time(alone(campaign, scenario), 0);
}

/// Whether it can be run, and nothing is odder about it than about what it stands for.
bool can_stand_for(const Campaign& campaign, const Scenario& scenario, const Scenario& other) {
    return find_contradictions(other).empty() &&
           advice(alone(campaign, other)).size() <= advice(alone(campaign, scenario)).size();
}

/// "7.5 m (1010 elements) 17 min" for each element side that can be.
std::vector<std::string> other_elements(const Campaign& campaign, const Scenario& scenario) {
    std::vector<std::string> words;
    if (scenario.sizes.element != ElementSide::given && scenario.sizes.law != SizeLaw::one) return words;
    for (const double factor : {2.0, 1.5, 2.0 / 3}) {
        Scenario other = scenario;
        other.floe.element = to_two_digits(factor * scenario.floe.element);
        if (can_stand_for(campaign, scenario, other))
            words.push_back(fmt::format("{:g} m ({:.0f} elements) {}", other.floe.element, computed_elements(other),
                                        duration_text(run_time(campaign, other))));
    }
    return words;
}

/// "600 s 12 min" for half and twice the window.
std::vector<std::string> other_windows(const Campaign& campaign, const Scenario& scenario) {
    std::vector<std::string> words;
    for (const double factor : {0.5, 2.0}) {
        Scenario other = scenario;
        other.analysis.window = factor * scenario.analysis.window;
        if (can_stand_for(campaign, scenario, other))
            words.push_back(fmt::format("{:g} s {}", other.analysis.window, duration_text(run_time(campaign, other))));
    }
    return words;
}

/// "; with floe.element_m of 10 m (570 elements) 9 min, of …"; empty where there are none.
std::string with(const char* key, const std::vector<std::string>& others) {
    return others.empty() ? "" : fmt::format("; with {} of {}", key, fmt::join(others, ", of "));
}

std::string words_of(const Campaign& campaign, const Scenario& scenario) {
    return fmt::format(
        "a member takes about {} of one core (others took 0.7 to 2.3 times as long), {:.0f} elements over {} steps{}{}",
        duration_text(run_time(campaign, scenario)), computed_elements(scenario), scenario.step_count(),
        with("floe.element_m", other_elements(campaign, scenario)),
        with("analysis.window_s", other_windows(campaign, scenario)));
}

}  // namespace

double core_memory(const Campaign& campaign) {
    constexpr double of_program = 42e6;
    constexpr double of_element = 22e3;
    double most = 0;
    for (const Case& one : campaign.cases) most = std::max(most, computed_elements(one.scenario));
    return of_program + of_element * most;
}

std::vector<std::string> cost_words(const Campaign& campaign) {
    std::vector<std::pair<double, const Case*>> told;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        const double time = expected_run_time(campaign, static_cast<int>(k));
        if (time >= (campaign.cases[k].scenario.moorings.give_way() ? dear_moored : dear))
            told.emplace_back(time, &campaign.cases[k]);
    }
    if (told.empty()) return {};
    if (told.size() > most_cases_said) {
        const auto [least, most] = std::ranges::minmax_element(told, {}, [](const auto& one) { return one.first; });
        const std::string shortest = duration_text(least->first);
        const std::string longest = duration_text(most->first);
        return {fmt::format(
            "a member of {} of the cases takes about {} of one core{} (floes plan).", told.size(), longest,
            shortest == longest ? ""
                                : fmt::format(" in {}, {} in {}", most->second->name, shortest, least->second->name))};
    }
    std::vector<std::string> sentences;
    std::set<std::string> said;
    for (const auto& [time, one] : told)
        if (const std::string words = words_of(campaign, one->scenario); said.insert(words).second)
            sentences.push_back(fmt::format("case {}: {}.", one->name, words));
    return sentences;
}

}  // namespace floes
