// What floes that touch nothing could cost less: over a member, the share of floes that nothing touches, and of the
// processor time.
//
//   floes_untouched CONFIG.toml CASE

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "campaign/read.hpp"
#include "simulation/simulation.hpp"

namespace {

using namespace floes;

constexpr int parts = 6;

struct Part {
    double untouched = 0;       ///< floe-steps
    double for_a_second = 0;    ///< … that have been untouched for a second
    double processor_time = 0;  ///< s
    int steps = 0;
};

double processor_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) {
        fmt::print(stderr, "usage: floes_untouched CONFIG.toml CASE\n");
        return 2;
    }
    std::ifstream file(words[1]);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Campaign campaign = read_campaign({text, words[1], {}, true}, nullptr);
    const auto chosen = std::ranges::find(campaign.cases, words[2], &Case::name);
    if (chosen == campaign.cases.end()) {
        fmt::print(stderr, "{} has no case {}\n", words[1], words[2]);
        return 2;
    }
    const Scenario& scenario = chosen->scenario;
    Simulation simulation(scenario, make_arrangement(scenario, campaign.seed, 0));
    const std::vector<IceElement>& elements = simulation.ice().elements();
    const auto floe_of = [&](int element) {
        return static_cast<std::size_t>(elements[static_cast<std::size_t>(element)].floe);
    };
    const auto floes = static_cast<std::size_t>(simulation.ice().floes());
    const int steps = scenario.step_count();
    const int second = static_cast<int>(1 / scenario.general.time_step);
    std::vector<int> last_touched(floes, -second - 1);
    std::vector<Part> found(parts);
    Frame frame;
    for (int step = 0; step < steps; ++step) {
        Part& part = found[static_cast<std::size_t>(static_cast<long>(step) * parts / steps)];
        const double before = processor_time();
        simulation.step();
        part.processor_time += processor_time() - before;
        ++part.steps;
        simulation.read_frame(frame);
        for (const FrameContact& contact : frame.contacts) {
            last_touched[floe_of(contact.element)] = step;
            if (contact.other >= 0) last_touched[floe_of(contact.other)] = step;
        }
        for (const int last : last_touched) {
            part.untouched += last < step ? 1 : 0;
            part.for_a_second += step - last > second ? 1 : 0;
        }
    }
    double time = 0;
    for (const Part& part : found) time += part.processor_time;
    fmt::print(
        "| to, s | floes that nothing touches, % | for a second, % | of the processor time, % |\n|---|---|---|---|\n");
    double end = 0;
    for (const Part& part : found) {
        end += part.steps * scenario.general.time_step;
        const double all = part.steps * static_cast<double>(floes);
        fmt::print("| {:.0f} | {:.0f} | {:.0f} | {:.1f} |\n", end, 100 * part.untouched / all,
                   100 * part.for_a_second / all, 100 * part.processor_time / time);
    }
}
