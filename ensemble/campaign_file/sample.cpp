#include "campaign_file/sample.hpp"

#include <algorithm>
#include <cmath>

#include "core/undefined.hpp"
#include "member/array_output.hpp"

namespace floes {
namespace {

constexpr std::string_view times_path = "averaging_time";

}  // namespace

Sample::Sample(const CampaignTable& table) : done_(table.cases.size()) {
    const std::vector<Quantity> known = table.quantities();
    MemberResult result;
    for (const MemberRow& row : table.members) {
        const std::size_t member = case_of_.size();
        case_of_.push_back(static_cast<std::size_t>(row.case_index));
        arrangement_of_.push_back(row.arrangement);
        if (row.done()) done_.at(case_of_.back()).push_back(member);
        for (const Quantity& one : known) columns_[std::string{one.key.view()}].push_back(row.value(one));
        static_cast<MemberOutputs&>(result) = row;
        for (const ArrayOutput& array : array_outputs) {
            // Levels differ between cases: the table has them in places that all share.
            if ((!array.in_table && array.path != times_path) || array.group() == "exceedance") continue;
            const ArrayValues values = row.done() ? array.access.get(result) : ArrayValues{};
            add(array.path, values.values, values.sizes.empty() ? 0 : values.sizes.back());
        }
        add("exceedance/steps_above", row.steps_above, row.steps_above.size());
        add("exceedance/upcrossings", row.upcrossings, row.upcrossings.size());
    }
    for (Members& members : done_)
        std::ranges::stable_sort(members, {}, [&](std::size_t k) { return arrangement_of_[k]; });
}

void Sample::add(std::string_view path, std::span<const double> values, std::size_t width) {
    Array& array = arrays_.try_emplace(std::string{path}).first->second;
    if (array.first.empty()) array.first.push_back(0);
    array.values.insert(array.values.end(), values.begin(), values.end());
    array.first.push_back(array.values.size());
    array.width.push_back(width);
}

double Sample::value(std::size_t member, const Quantity& quantity) const {
    const auto column = columns_.find(quantity.key.view());
    return column == columns_.end() ? undefined : column->second.at(member);
}

std::vector<double> Sample::values(const Members& members, const Quantity& quantity) const {
    std::vector<double> values;
    values.reserve(members.size());
    for (const std::size_t member : members) values.push_back(value(member, quantity));
    return values;
}

std::span<const double> Sample::along(std::string_view array, std::size_t member) const {
    const Array& found = arrays_.find(array)->second;
    return std::span(found.values).subspan(found.first[member], found.first[member + 1] - found.first[member]);
}

std::span<const double> Sample::along(std::string_view array, std::size_t member, std::size_t place) const {
    const std::span<const double> all = along(array, member);
    const std::size_t width = arrays_.find(array)->second.width[member];
    if ((place + 1) * width > all.size()) return {};
    std::span<const double> row = all.subspan(place * width, width);
    while (!row.empty() && std::isnan(row.back())) row = row.first(row.size() - 1);
    return row;
}

std::optional<std::size_t> Sample::place_of_time(std::size_t member, double time) const {
    const std::span<const double> times = along(times_path, member);
    const auto found = std::ranges::find(times, time);
    return found == times.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - times.begin()));
}

std::vector<double> Sample::values(const Members& members, std::string_view array, std::size_t place,
                                   std::size_t second) const {
    std::vector<double> values;
    values.reserve(members.size());
    for (const std::size_t member : members) {
        const std::span<const double> all = along(array, member);
        const std::size_t width = arrays_.find(array)->second.width[member];
        const bool two = width < all.size();  // one axis is one row
        const std::size_t at = two ? place * width + second : place;
        values.push_back(at < all.size() ? all[at] : undefined);
    }
    return values;
}

}  // namespace floes
