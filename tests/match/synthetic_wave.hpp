#pragma once
// Waves with results that a formula gives, without files.

#include <functional>
#include <string>
#include <vector>

#include "campaign/read.hpp"
#include "match/waves.hpp"

namespace floes::synthetic {

/// Mean load of the member of a case on an arrangement, N; NaN: the member failed.
using LoadOf = std::function<double(const Case& one, int arrangement)>;

/// Every member is done unless its load is NaN. Times 0.5 and 1 s are averaged over: mean_maximum is the load plus 1,
/// and over a time plus the time.
inline MatchWave wave(const std::string& file, const std::string& text, const LoadOf& load) {
    MatchWave made{
        file,
        read_campaign({text, file, {"general.solver=lanes", "joint.model=cfm", "water.added_mass_from=share"}, true},
                      nullptr),
        {}};
    made.table.averaging_times = {0.5, 1};
    for (const Case& one : made.campaign.cases) {
        CaseRow& row = made.table.cases.emplace_back();
        row.name = one.name;
    }
    for (int number = 0; number < member_count(made.campaign); ++number) {
        const MemberKey key = member_key(made.campaign, number);
        MemberRow& row = made.table.members.emplace_back();
        row.case_index = key.case_index;
        row.arrangement = key.arrangement;
        const double value = load(made.campaign.cases[static_cast<std::size_t>(key.case_index)], key.arrangement);
        if (!(value == value)) {
            row.status = RowStatus::failed;
            continue;
        }
        row.status = RowStatus::done;
        row.load.mean = value;
        row.load.mean_maximum = value + 1;
        for (const double time : made.table.averaging_times) {
            AveragedLoad averaged;
            averaged.time = time;
            averaged.mean_maximum = value + time;
            row.averaged.push_back(averaged);
        }
    }
    return made;
}

}  // namespace floes::synthetic
