#pragma once
// A small campaign with synthetic results, for tests of storage: every field has a different value.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/random.hpp"
#include "store/member_record.hpp"
#include "store/session.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes::synthetic {

/// Three cases: the second shares the first one's geometry, the third has fewer floes, segments and steps.
inline Campaign campaign(int arrangements = 4) {
    Scenario scenario = sweeping_scenario();
    scenario.field.floes = 6;
    scenario.field.concentration = 0.3;
    scenario.structure.speed = 1.75;
    scenario.analysis = {
        .steady_start = 1.0, .window = 1.2, .segments = 3, .exceedance_levels = {100, 300}, .averaging = {0.1, 0.4}};
    Campaign made;
    made.name = "synthetic";
    made.seed = 7;
    made.arrangements = arrangements;
    made.cases.push_back({"soft", scenario});
    scenario.joint.cfm = 1e-10;
    scenario.ice.elastic_modulus = 200e6;
    made.cases.push_back({"stiff", scenario});
    scenario.field.floes = 4;
    scenario.field.far_end = FarEnd::open;
    scenario.structure.shape = Shape({{-0.443, 0.3}, {0.0, 0.6}, {0.122, 0.736}});
    scenario.contact.erp = 0.8;
    scenario.analysis = {
        .steady_start = 1.2, .window = 0.8, .segments = 2, .exceedance_levels = {300, 500}, .averaging = {0.2, 0.4}};
    made.cases.push_back({"open", scenario});
    return made;
}

/// The first case at the six points of a grid.
inline Campaign campaign_with_design() {
    Campaign one = campaign();
    one.cases.resize(1);
    return read_campaign(
        {write_campaign(one) +
             "[design]\nmethod = \"grid\"\n[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [0.03, "
             "0.04, 0.05]\n[[design.axis]]\nkey = \"joint.cfm\"\nvalues = [0.01, 0.1]\nscale = \"log\"\n",
         "synthetic.toml",
         {}},
        nullptr);
}

/// campaign(1) of ice so coarse that a plate test takes a tenth of a second.
inline Campaign coarse_campaign() {
    Campaign made = campaign(1);
    for (Case& one : made.cases) {
        one.scenario.floe.length = one.scenario.floe.breadth = 1.5;
        one.scenario.floe.element = 0.75;
        one.scenario.general.iterations = 20;
    }
    return made;
}

/// A done member. Values depend on the member alone; floe poses on arrangement number and floe count alone.
inline MemberRecord record(const Campaign& campaign, int number) {
    const MemberKey key = member_key(campaign, number);
    const Scenario& scenario = campaign.cases[static_cast<std::size_t>(key.case_index)].scenario;
    const double base = 100.0 * (number + 1);
    MemberRecord made;
    made.case_key = case_fingerprint(campaign, key.case_index);
    made.arrangement = key.arrangement;
    made.attempt = 1 + number % 2;
    made.rank = number % 3;
    made.host = "node" + std::to_string(number % 2);
    made.peak_memory = 1000000u + static_cast<unsigned>(number);
    MemberResult& result = made.result;
    result.load = {base + 0.1,  base + 0.2, base + 0.3,      {},         base + 0.4, base + 0.5,
                   -base - 0.6, 0.25,       number % 2 == 0, base + 0.7, base + 0.8};
    for (int k = 0; k < scenario.analysis.segments; ++k) result.load.segment_maximum.push_back(base + 0.01 * k);
    result.levels = {{20 + number, 5 + number}, {10 + number, number}};
    for (const double time : scenario.averaging_times()) {
        AveragedLoad& one =
            result.averaged.emplace_back(AveragedLoad{time, base + time, {}, base + 10 * time, base + 100 * time});
        for (int k = 0; k < scenario.analysis.segments; ++k) one.segment_maximum.push_back(base + time + 0.01 * k);
        for (int k = number % 3; k >= 0; --k) one.peaks.push_back(base + time + 0.1 * k);
    }
    result.yaw = {base + 1.1, base + 1.2, base + 1.3};
    result.roll = {base + 1.4, base + 1.5, base + 1.6};
    result.pitch = {base + 1.7, base + 1.8, base + 1.9};
    result.mean_sway = base + 0.7;
    result.mean_heave = -base - 0.8;
    result.failure_ratio = 1.0 / (number + 3);
    result.mean_concentration = 0.5 + 0.001 * number;
    result.pile_height = 0.1 + 0.001 * number;
    result.pile_draught = 0.3 + 0.001 * number;
    for (std::size_t mode = 0; mode < result.failures.size(); ++mode)
        result.failures[mode] = 3 * number + static_cast<double>(mode);
    result.local_order = 0.5 + 0.001 * number;
    result.coverage_ahead = 0.7 + 0.001 * number;
    result.peaks = {base + 1, base + 2, base + 3, base + 4, base + 5, base + 6};
    LoadHistory history;
    for (int k = 0; k < scenario.step_count(); ++k) {
        history.surge.push_back(base * std::sin(0.1 * k));
        history.sway.push_back(base * std::cos(0.1 * k));
        history.heave.push_back(base / (k + 1));
        history.concentration.push_back(0.5 + 0.001 * number);
        history.pile_height.push_back(0.1 + 0.001 * number);
        history.pile_draught.push_back(0.3 + 0.001 * number);
    }
    LoadMap map{{}, {}, {}};
    for (std::size_t bin = 0; bin < LoadMap::heights * LoadMap::angles; ++bin) {
        map.surge.push_back(base + 0.001 * static_cast<double>(bin));
        map.normal.push_back(2 * base + 0.001 * static_cast<double>(bin));
    }
    for (std::size_t part = 0; part < LoadMap::parts; ++part)
        map.along_tow.push_back(base + 0.1 * static_cast<double>(part));
    result.history = std::move(history);
    result.load_map = std::move(map);
    for (int k = 0; k < number % 4; ++k)
        result.breaks.push_back({0.02 * (k + 1), k, k + 9, static_cast<FailureMode>((number + k) % 6)});
    if (number % 4 > 0) result.piece_areas = {{1, 0.12}, {1, 0.24}};
    for (int k = 0; k < scenario.field.floes; ++k)
        result.arrangement.push_back({6.0 + k + 0.1 * key.arrangement, 0.3 * scenario.field.floes - k, 0.01 * k});
    result.psi4 = 0.9 + 0.001 * key.arrangement;
    result.wall_time = 12.5 + number;
    result.cpu_time = 12.0 + number;
    return made;
}

inline MemberRecord failed_record(const Campaign& campaign, int number) {
    MemberRecord made = record(campaign, number);
    made.result.status = MemberStatus::failed;
    made.result.reason = "an element ran away at 12.34 s: 11 m/s, allowed ≤ 10 m/s";
    made.result.load.mean = std::numeric_limits<double>::infinity();
    return made;
}

/// The same of a steady load with exponential peaks of 20 N above 30 N, eight in each window.
inline MemberRecord record_with_peaks(const Campaign& campaign, int number) {
    MemberRecord made = record(campaign, number);
    RandomStream random{3, static_cast<std::uint32_t>(number), StreamId::bootstrap, 0};
    made.result.load.mean = 20;
    made.result.load.trend = 0;
    for (AveragedLoad& averaged : made.result.averaged) {
        averaged.peaks.resize(8);
        for (double& peak : averaged.peaks) peak = 30 - 20 * std::log(random.uniform(1e-16, 1));
        std::ranges::sort(averaged.peaks, std::ranges::greater{});
        std::ranges::fill(averaged.segment_maximum, averaged.peaks.front());
    }
    return made;
}

/// Members 0 to count - 1; number 4 failed, and number 7 stays missing.
inline std::vector<MemberRecord> records(const Campaign& campaign) {
    std::vector<MemberRecord> made;
    for (int number = 0; number < member_count(campaign); ++number) {
        if (number == 7) continue;
        made.push_back(number == 4 ? failed_record(campaign, number) : record(campaign, number));
    }
    return made;
}

/// Every member done.
inline std::vector<MemberRecord> all_done_records(const Campaign& campaign) {
    std::vector<MemberRecord> made;
    for (int number = 0; number < member_count(campaign); ++number) made.push_back(record(campaign, number));
    return made;
}

/// As if the second and the third case, of one ice, had given their elastic modulus in place of Σ; the values of a
/// point rise by its index.
inline CalibrationRecord calibration(const Campaign& campaign) {
    const Scenario& scenario = campaign.cases[1].scenario;
    CalibrationRecord made{calibration_key(scenario), {scenario.joint.cfm, 207e6, {}}};
    for (int k = 0; k < 3; ++k)
        made.found.curve.push_back({5.4 + k, 0.2 + k, 0.03 + k, 0.02 + k, 0.8 + k, 50 + k, 0.016 + k, 1e4 + k, 6e7 + k,
                                    7e7 + k, JointModel::cfm, 0});
    return made;
}

inline Session session(int number = 0) {
    Session made;
    made.started = "2026-01-0" + std::to_string(1 + number) + "T10:00:00Z";
    made.host = "node0";
    made.machine = "Linux 6.1 x86_64, a processor";
    made.job = "4711";
    made.ranks = 2 + number;
    made.threads = 4 + number;
    made.software = {{"floes", "0.1.0"}, {"bullet", "3.24"}};
    return made;
}

}  // namespace floes::synthetic
