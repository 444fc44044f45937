#include "run/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

constexpr double most_apart = 0.05;  // relative; the paper's three pairs are within 4 %

struct PlateResult {
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

PlateResult measure(const Scenario& ice) {
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

void settle(Case& one, const PlateResult& measured, Progress& progress) {
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

/// One ice to be calibrated, for all cases that have it.
struct Task {
    std::string cases;  ///< their names
    Scenario scenario;  ///< of the first of them
    CalibrationRecord record;
    std::string refusal;  ///< why there is no such Σ; empty when there is one
    bool kept = false;
};

std::vector<Task> tasks_of(const Campaign& campaign, std::span<const CalibrationRecord> kept) {
    std::vector<Task> tasks;
    for (const Case& one : campaign.cases) {
        if (one.pairing != Pairing::find_cfm) continue;
        const std::string key = calibration_key(one.scenario);
        const auto same = std::ranges::find(tasks, key, [](const Task& task) { return task.record.key; });
        if (same != tasks.end()) {
            same->cases += ", " + one.name;
        } else if (const CalibrationRecord* record = find_calibration(kept, key)) {
            tasks.push_back({one.name, one.scenario, *record, "", true});
        } else {
            tasks.push_back({one.name, one.scenario, {key, {}}, "", false});
        }
    }
    return tasks;
}

void calibrate(Task& task) {
    try {
        // Only the inputs of the calibration go into it; otherwise the same ice could get a different Σ in another
        // field.
        task.record.found = calibrate_cfm(plate_scenario(task.scenario), whole_plate_test(task.scenario),
                                          task.scenario.ice.elastic_modulus);
    } catch (const InputError& error) {
        task.refusal = error.what();
    }
}

std::string intention(const Task& task) {
    const double element = task.scenario.floe.element;
    const double sheet = whole_plate_test(task.scenario).sheet;
    const double whole = plate_test_for(task.scenario).sheet;
    const bool divides = std::abs(sheet - whole) < 1e-6 * whole;
    return fmt::format("calibrating {}: searching for the Σ that gives {:.6g} MPa on a sheet of {:.6g} m{}", task.cases,
                       task.scenario.ice.elastic_modulus / unit::megapascal, sheet,
                       divides ? "" : fmt::format(" (elements of {:.6g} m do not divide {:.6g} m)", element, whole));
}

std::string finding(const Task& task) {
    return fmt::format("calibrated {}: Σ = {:.4g} gives {:.6g} MPa (ceiling {:.4g} MPa){}", task.cases,
                       task.record.found.cfm, task.scenario.ice.elastic_modulus / unit::megapascal,
                       task.record.found.ceiling / unit::megapascal, task.kept ? ", as before" : "");
}

}  // namespace

void settle_moduli(Campaign& campaign, int threads, Progress& progress) {
    struct Tested {
        Scenario ice;
        PlateResult measured;
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

std::vector<CurvePoint> measure_curve(const std::vector<PointPlan>& plans) {
    std::vector<CurvePoint> curve(plans.size());
    tbb::parallel_for(std::size_t{0}, plans.size(),
                      [&](std::size_t i) { curve[i] = measure_curve_point(plans[i].scenario, plans[i].test); });
    return curve;
}

std::vector<CalibrationRecord> kept_calibrations(const Recorder::Places& places) {
    const std::filesystem::path journal = journal_path(places.campaign_file);
    if (places.existing != Existing::resume) return {};
    try {
        if (std::filesystem::exists(journal)) return read_journal(journal).calibrations;
        if (std::filesystem::exists(places.campaign_file)) return Recorder::filed(places).calibrations;
        return {};
    } catch (const std::runtime_error&) {
        return {};  // nothing usable; whether the run can resume from it is decided when it is opened
    }
}

std::vector<CalibrationRecord> calibrate_campaign(Campaign& campaign, std::span<const CalibrationRecord> kept,
                                                  int threads, Progress& progress) {
    std::vector<Task> tasks = tasks_of(campaign, kept);
    for (const Task& task : tasks) {
        if (!task.kept) progress.say(intention(task));
    }
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
            if (!tasks[i].kept) calibrate(tasks[i]);
        });
    });
    std::vector<CalibrationRecord> records;
    for (Task& task : tasks) {
        if (!task.refusal.empty())
            throw InputError(
                fmt::format("case {} cannot be calibrated: {} Or state joint.cfm.", task.cases, task.refusal));
        progress.say(finding(task));
        records.push_back(std::move(task.record));
    }
    for (Case& one : campaign.cases) {
        if (one.pairing != Pairing::find_cfm) continue;
        one.scenario.joint.cfm = find_calibration(records, calibration_key(one.scenario))->found.cfm;
        one.pairing = Pairing::settled;
    }
    return records;
}

}  // namespace floes
