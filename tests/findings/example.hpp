#pragma once
// A small campaign for the tests of reports: three cases, four arrangements. Of E60 one member failed and one is
// missing.

#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "campaign_file/read.hpp"

namespace floes::example {

inline MemberRow done(int case_index, int arrangement, double mean, double ratio, int bending) {
    MemberRow row;
    row.case_index = case_index;
    row.arrangement = arrangement;
    row.status = RowStatus::done;
    row.load.mean = mean;
    row.load.sd = mean / 2;
    row.load.maximum = 5 * mean;
    row.load.mean_maximum = 4 * mean;
    row.load.sd_maximum = mean + 1;
    row.failure_ratio = ratio;
    row.failures[0] = bending;
    row.failures[1] = 1;
    row.load.steady = true;
    return row;
}

/// As read_campaign_file() gives a member that is not done: numbers NaN, counts 0.
inline MemberRow without_result(int case_index, int arrangement, RowStatus status, std::string reason = {}) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    MemberRow row = done(case_index, arrangement, nan, nan, 0);
    row.status = status;
    row.reason = std::move(reason);
    row.failures[1] = 0;
    row.load.steady = false;
    return row;
}

inline CampaignTable campaign() {
    CampaignTable table;
    table.title = "example";
    const Shape cone({{-0.443, 0.171}, {0.122, 0.736}});
    for (const auto& [name, cfm, modulus] :
         {std::tuple{"E30", 0.03, 30e6}, {"E60", 0.016, 60e6}, {"E200", 1e-10, 200e6}}) {
        CaseRow row;
        row.name = name;
        row.cfm = cfm;
        row.elastic_modulus = modulus;
        row.contact = {.erp = 0.2};
        row.shape = cone;
        table.cases.push_back(row);
    }
    table.members = {
        done(0, 0, 26, 0.02, 3),
        done(1, 0, 30, 0.04, 5),
        done(2, 0, 20, 0.0, 7),
        done(0, 1, 28, 0.00, 2),
        without_result(1, 1, RowStatus::failed, "floe 3 sank"),
        done(2, 1, 24, 0.5, 8),
        done(0, 2, 24, 0.04, 4),
        done(1, 2, 34, 0.06, 6),
        done(2, 2, 28, 1.0, 9),
        done(0, 3, 30, 0.02, 1),
        without_result(1, 3, RowStatus::missing),
        done(2, 3, 32, 0.5, 10),
    };
    table.members[3].load.steady = false;
    return table;
}

}  // namespace floes::example
