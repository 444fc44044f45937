#include "driver/calibrate_campaign.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/error.hpp"
#include "core/units.hpp"

namespace floes {

namespace {

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
                       task.record.found.ceiling / unit::megapascal, task.kept ? ", from the journal" : "");
}

}  // namespace

std::vector<CalibrationRecord> kept_calibrations(const Recorder::Places& places) {
    const std::filesystem::path journal = journal_path(places.campaign_file);
    if (places.existing != Existing::resume || !std::filesystem::exists(journal)) return {};
    try {
        return read_journal(journal).calibrations;
    } catch (const InputError&) {
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
