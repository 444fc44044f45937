#include "campaign_file/read_campaign_file.hpp"

#include <limits>

#include <fmt/format.h>

#include "campaign_file/member_rows.hpp"
#include "campaign_file/read_arrays.hpp"
#include "campaign_file/read_details.hpp"
#include "hdf5/columns.hpp"

namespace floes {
namespace {

std::vector<MemberResult> read_quantities(const CampaignFile& file, std::size_t count) {
    std::vector<MemberResult> results(count);
    for (const Quantity& one : quantities) {
        const std::string name = fmt::format("members/{}", one.key);
        std::vector<double> values(count, std::numeric_limits<double>::quiet_NaN());
        if (one.since == 0 || hdf5::exists(file.id(), name)) values = hdf5::read_column<double>(file.id(), name, count);
        for (std::size_t k = 0; k < count; ++k) {
            if (!one.holds(values[k]))
                hdf5::refuse_damaged(file.id(), fmt::format("{} has {} in place of a count", name, values[k]));
            one.place.set(results[k], values[k]);
        }
    }
    return results;
}

/// Files of layout 1.8 have totals of three modes only, but the events of all.
void count_failures(const CampaignFile& file, const std::vector<RowStatus>& states,
                    std::vector<MemberResult>& results) {
    if (hdf5::exists(file.id(), "members/failures_tension")) return;
    for (std::size_t k = 0; k < results.size(); ++k)
        if (states[k] != RowStatus::missing) results[k].failures = {};
    for (const BreakRow& row : read_breaks(file)) {
        if (row.member < 0 || static_cast<std::size_t>(row.member) >= results.size())
            hdf5::refuse_damaged(file.id(), fmt::format("breaks/member has {}, which is no member", row.member));
        ++results.at(static_cast<std::size_t>(row.member)).failures.at(static_cast<std::size_t>(row.mode));
    }
}

/// Those that are read with the quantities. Times of averaged loads are what the scenario says.
void read_table_arrays(const CampaignFile& file, const std::vector<RowStatus>& states,
                       std::vector<MemberResult>& results) {
    const Campaign& campaign = file.campaign();
    const ArrayPlaces places(campaign);
    const auto case_of = [&](std::size_t member) { return member_key(campaign, static_cast<int>(member)).case_index; };
    for (std::size_t k = 0; k < results.size(); ++k) {
        if (states[k] != RowStatus::done) continue;
        for (const double time : campaign.cases[static_cast<std::size_t>(case_of(k))].scenario.averaging_times())
            results[k].averaged.push_back({.time = time, .segment_maximum = {}});
    }
    for (const ArrayOutput& array : array_outputs) {
        if (!array.in_table) continue;
        ArrayReader reader(file, array, places);
        for (std::size_t k = 0; k < results.size(); ++k)
            if (states[k] == RowStatus::done) reader.read(k, case_of(k), results[k]);
    }
}

}  // namespace

CampaignTable read_campaign_file(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    const MemberRows rows(file.campaign());
    CampaignTable table = rows.table();
    table.title = hdf5::read_text_attribute(file.id(), "title");
    const std::vector<RowStatus> states = read_states(file);
    std::vector<MemberResult> results = read_quantities(file, states.size());
    read_table_arrays(file, states, results);
    count_failures(file, states, results);
    const auto steady = hdf5::read_numbers<std::int8_t>(file.id(), "members/steady", states.size(), -1, 1);
    const auto reason = hdf5::read_texts(file.id(), "members/reason");
    hdf5::check_count(file.id(), "members/reason", reason.size(), states.size());
    for (std::size_t k = 0; k < states.size(); ++k) {
        results[k].load.steady = steady[k] == 1;
        results[k].reason = reason[k];
        table.members.push_back(rows.row(k, states[k], results[k]));
    }
    return table;
}

}  // namespace floes
