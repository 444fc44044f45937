#include "driver/plate_moduli.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/units.hpp"
#include "laboratory/calibration.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

constexpr double most_apart = 0.05;  // relative; the paper's three pairs are within 4 %

struct Measured {
    double modulus = 0;   ///< Pa
    std::string refusal;  ///< why there is none; empty where there is one
};

/// The ice of a case as a plate test sees it. E does not act in joints that follow Σ.
Scenario tested_ice(const Case& one) {
    Scenario ice = plate_scenario(one.scenario);
    ice.joint.cfm = one.scenario.joint.cfm;
    ice.ice.elastic_modulus = Ice{}.elastic_modulus;
    return ice;
}

Measured measure(const Scenario& ice) {
    try {
        return {measure_curve_point(ice, whole_plate_test(ice)).elastic_modulus, ""};
    } catch (const InputError& error) {
        return {0, error.what()};
    }
}

std::string megapascals(double modulus) {
    return fmt::format("{:.3g} MPa", modulus / unit::megapascal);
}

[[noreturn]] void refuse_pair(const Case& one, double shown) {
    throw InputError(fmt::format(
        "case {}: {} and {} do not belong together: in a plate test ice of this Σ shows {}. Leave one of the two out, "
        "and the other gives it; or write joint.model = \"beam\" and general.solver = \"direct\" (the defaults) and "
        "leave joint.cfm out: then the ice has the E that is stated. If E is only a name, as in the paper: "
        "run.nominal_modulus = true.",
        one.name, given(one.scenario, "ice.elastic_modulus_MPa"), given(one.scenario, "joint.cfm"),
        megapascals(shown)));
}

double to_three_figures(double value) {
    return std::stod(fmt::format("{:.2e}", value));
}

void settle(Case& one, const Measured& measured, Progress& progress) {
    const double stated = one.scenario.ice.elastic_modulus;
    if (one.pairing == Pairing::find_modulus) {
        if (!measured.refusal.empty())
            throw InputError(fmt::format("case {}: the E of {} cannot be measured: {} State ice.elastic_modulus_MPa.",
                                         one.name, given(one.scenario, "joint.cfm"), measured.refusal));
        one.scenario.ice.elastic_modulus = to_three_figures(measured.modulus);
        progress.say(fmt::format("case {}: {} gives {}", one.name, given(one.scenario, "joint.cfm"),
                                 megapascals(measured.modulus)));
    } else if (!measured.refusal.empty()) {
        progress.say(fmt::format("case {}: whether E and Σ agree cannot be tested: {}", one.name, measured.refusal));
    } else if (std::abs(measured.modulus - stated) > most_apart * stated) {
        refuse_pair(one, measured.modulus);
    }
    one.pairing = Pairing::settled;
}

}  // namespace

void settle_moduli(Campaign& campaign, int threads, Progress& progress) {
    struct Tested {
        Scenario ice;
        Measured measured;
    };
    std::map<std::string, Tested> ices;  // distinct ones, by their canonical text
    std::vector<std::pair<Case*, const Tested*>> asked;
    for (Case& one : campaign.cases) {
        if (one.pairing != Pairing::find_modulus && one.pairing != Pairing::check) continue;
        Scenario ice = tested_ice(one);
        std::string text = canonical_text(ice);
        asked.emplace_back(&one, &ices.try_emplace(std::move(text), Tested{std::move(ice), {}}).first->second);
    }
    std::vector<Tested*> tests;
    for (auto& [text, tested] : ices) tests.push_back(&tested);
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, tests.size(),
                          [&](std::size_t i) { tests[i]->measured = measure(tests[i]->ice); });
    });
    for (const auto& [one, tested] : asked) settle(*one, tested->measured, progress);
}

}  // namespace floes
