#include "campaign_file/read_history.hpp"

#include <vector>

#include "campaign_file/read_arrays.hpp"

namespace floes {
namespace {

/// Of the members that `wanted` takes.
void for_histories(const CampaignFile& file, const ArrayOutput& array, const std::function<bool(int member)>& wanted,
                   const std::function<void(const SurgeHistory&)>& use) {
    const hdf5::QuietErrors quiet;
    const Campaign& campaign = file.campaign();
    const ArrayPlaces places(campaign);
    const std::vector<RowStatus> states = read_states(file);
    ArrayReader reader(file, array, places);
    for (int member = 0; member < static_cast<int>(states.size()); ++member) {
        if (states[static_cast<std::size_t>(member)] != RowStatus::done || !wanted(member)) continue;
        const int of_case = member_key(campaign, member).case_index;
        const ArrayValues history = reader.read(static_cast<std::size_t>(member), of_case);
        const Scenario& scenario = campaign.cases[static_cast<std::size_t>(of_case)].scenario;
        const double step = scenario.general.time_step * scenario.analysis.history_stride;
        if (!history.empty()) use({member, step, history.values});
    }
}

}  // namespace

void for_each_history(const CampaignFile& file, const std::function<void(const SurgeHistory&)>& use) {
    for_histories(
        file, array_output("history/surge_load"), [](int) { return true; }, use);
}

void for_each_mooring_history(const CampaignFile& file, const std::function<void(const SurgeHistory&)>& use) {
    for_histories(
        file, array_output("history/surge_mooring"), [](int) { return true; }, use);
}

void with_history(const CampaignFile& file, int member, const std::function<void(const SurgeHistory&)>& use) {
    for_histories(
        file, array_output("history/surge_load"), [member](int one) { return one == member; }, use);
}

}  // namespace floes
