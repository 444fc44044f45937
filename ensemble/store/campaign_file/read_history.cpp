#include "campaign_file/read_history.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "hdf5/columns.hpp"

namespace floes {
namespace {

/// Seconds from value to value of the histories of each case.
std::vector<double> value_steps(hid_t file) {
    auto steps = hdf5::read_values<double>(file, "cases/time_step");
    if (!hdf5::exists(file, "cases/history_stride")) return steps;  // before layout 1.3
    const auto strides = hdf5::read_numbers<std::int32_t>(file, "cases/history_stride", steps.size(), 1,
                                                          std::numeric_limits<std::int32_t>::max());
    for (std::size_t k = 0; k < steps.size(); ++k) steps[k] *= strides.at(k);
    return steps;
}

/// Of the members that `wanted` takes.
void for_histories(const CampaignFile& file, const std::function<bool(int member)>& wanted,
                   const std::function<void(const SurgeHistory&)>& use) {
    const hdf5::QuietErrors quiet;
    const char* name = "history/surge_load";
    if (!hdf5::exists(file.id(), name)) return;
    const std::vector<double> steps = value_steps(file.id());
    const auto status = hdf5::read_values<std::int8_t>(file.id(), "members/status");
    const auto last_case = static_cast<std::int32_t>(steps.size()) - 1;
    const auto cases = hdf5::read_numbers<std::int32_t>(file.id(), "members/case", status.size(), 0, last_case);
    hdf5::RowReader<double> rows(file.id(), name);
    for (std::size_t member = 0; member < status.size(); ++member) {
        if (static_cast<RowStatus>(status[member]) != RowStatus::done || !wanted(static_cast<int>(member))) continue;
        const std::span<const double> row = rows.read(member);
        std::size_t length = row.size();
        while (length > 0 && std::isnan(row[length - 1])) --length;  // rows are as long as the longest case
        const auto of_case = static_cast<std::size_t>(cases[member]);
        if (length > 0) use({static_cast<int>(member), steps.at(of_case), row.first(length)});
    }
}

}  // namespace

void for_each_history(const CampaignFile& file, const std::function<void(const SurgeHistory&)>& use) {
    for_histories(
        file, [](int) { return true; }, use);
}

void with_history(const CampaignFile& file, int member, const std::function<void(const SurgeHistory&)>& use) {
    for_histories(
        file, [member](int one) { return one == member; }, use);
}

}  // namespace floes
