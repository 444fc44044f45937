// Prints the tables of docs/field.md on scattered fields:
//   scattered_fields coverage [ARRANGEMENTS]   how far the method goes, how ordered its fields are, how long they take
//   scattered_fields sweeps [ARRANGEMENTS]     order over arrangement.ordering_sweeps, in the paper's channel
// 189 floes of 0.36 m² in the paper's channel. Means and ranges over arrangements of those that came to rest.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "core/error.hpp"

namespace {

using namespace floes;

struct Field {
    std::vector<double> psi4;
    std::vector<double> local;
    std::vector<double> ahead;
    double longest = 0;  // s
    double seconds = 0;  // of all

    void add(const Scenario& scenario, std::uint32_t number) {
        const auto begin = std::chrono::steady_clock::now();
        try {
            const Arrangement made = make_arrangement(scenario, 1, number);
            psi4.push_back(made.psi4);
            local.push_back(made.local_order);
            ahead.push_back(made.coverage_ahead);
        } catch (const InputError&) {  // did not come to rest
        }
        const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        seconds += took;
        longest = std::max(longest, took);
    }
};

struct Moments {
    double mean = 0;
    double sd = 0;
};

Moments moments(const std::vector<double>& values) {
    Moments result;
    const auto count = static_cast<double>(values.size());
    for (const double value : values) result.mean += value / count;
    for (const double value : values) result.sd += (value - result.mean) * (value - result.mean) / (count - 1);
    result.sd = std::sqrt(result.sd);
    return result;
}

std::string range(const std::vector<double>& values) {
    if (values.empty()) return "-";
    const auto [low, high] = std::ranges::minmax(values);
    return fmt::format("{:.2f} ({:.2f} to {:.2f})", moments(values).mean, low, high);
}

Scenario scattered_scenario(double concentration, double aspect) {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::scattered;
    scenario.field.concentration = concentration;
    scenario.floe.length *= std::sqrt(aspect);
    scenario.floe.breadth /= std::sqrt(aspect);
    return scenario;
}

void print_coverage(int arrangements) {
    fmt::print(
        "| floes | coverage, % | came to rest | s each (longest) | ψ4 | local order |\n|---|---|---|---|---|---|\n");
    for (const double aspect : {1.0, 2.0}) {
        for (const int percent : {10, 50, 75, 80, 85, 90}) {
            const Scenario scenario = scattered_scenario(0.01 * percent, aspect);
            Field field;
            for (int i = 0; i < arrangements; ++i) field.add(scenario, static_cast<std::uint32_t>(i));
            fmt::print("| {}:1 | {} | {} of {} | {:.2f} ({:.2f}) | {} | {} |\n", aspect, percent, field.psi4.size(),
                       arrangements, field.seconds / arrangements, field.longest, range(field.psi4),
                       range(field.local));
            std::fflush(stdout);
        }
    }
}

void print_sweeps(int arrangements) {
    fmt::print("| sweeps | ψ4 | local order | coverage ahead, % | s each |\n|---|---|---|---|---|\n");
    const auto row = [&](const std::string& name, const Scenario& scenario) {
        Field field;
        for (int i = 0; i < arrangements; ++i) field.add(scenario, static_cast<std::uint32_t>(i));
        const Moments ahead = moments(field.ahead);
        fmt::print("| {} | {} | {} | {:.1f} ± {:.1f} | {:.2f} |\n", name, range(field.psi4), range(field.local),
                   100 * ahead.mean, 100 * ahead.sd, field.seconds / arrangements);
        std::fflush(stdout);
    };
    Scenario scenario = scattered_scenario(0.75, 1);
    for (const int sweeps : {0, 10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000}) {
        scenario.arrangement.ordering_sweeps = sweeps;
        row(std::to_string(sweeps), scenario);
    }
    row("method `monte_carlo`", Scenario{});
}

}  // namespace

int main(int count, char** values) {
    const std::string_view table = count > 1 ? values[1] : "";
    const int arrangements = count > 2 ? std::atoi(values[2]) : table == "sweeps" ? 12 : 20;
    if (table == "coverage") {
        print_coverage(arrangements);
    } else if (table == "sweeps") {
        print_sweeps(arrangements);
    } else {
        fmt::print(stderr, "usage: scattered_fields coverage|sweeps [ARRANGEMENTS]\n");
        return 2;
    }
}
