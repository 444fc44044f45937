#include "campaign_file/campaign_content.hpp"

#include <limits>

#include "campaign_file/campaign_columns.hpp"

namespace floes {
namespace {

using hdf5::Handle;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Value, class Function>
std::vector<Value> of_members(CampaignContent& content, Function function) {
    std::vector<Value> values;
    for (MemberRow& row : content.table.members) values.push_back(function(row));
    return values;
}

}  // namespace

void write_members(hid_t file, CampaignContent& content, const CampaignScales& scales) {
    const Handle group = hdf5::create_group(file, "members");
    const hid_t id = group.id();
    const hdf5::Dimensions member{scales.member};
    hdf5::write_values(id, {"case", "1", "case of the member, a row of /cases"}, member,
                       of_members<std::int32_t>(content, [](const MemberRow& row) { return row.case_index; }));
    hdf5::write_values(id, {"arrangement", "1", "arrangement of the member, a row of /arrangements"}, member,
                       of_members<std::int32_t>(content, [](const MemberRow& row) { return row.arrangement; }));
    hdf5::write_values(
        id, {"status", "1", "whether the member was computed"}, member,
        of_members<std::int8_t>(content, [](const MemberRow& row) { return static_cast<std::int8_t>(row.status); }),
        hdf5::Flags{{-1, 0, 1}, "missing done failed"});
    for (const RealColumn& column : real_columns)
        hdf5::write_values(id, {column.name, column.unit, column.long_name}, member,
                           of_members<double>(content, column.field));
    for (const CountColumn& column : count_columns)
        hdf5::write_values(id, {column.name, "1", column.long_name}, member,
                           of_members<double>(content, [&column](const MemberRow& row) {
                               return row.status == RowStatus::done ? row.*column.field : nan;
                           }));
    hdf5::write_values(
        id, {"steady", "1", "whether the trend of the surge load does not differ from zero"}, member,
        of_members<std::int8_t>(content,
                                [](const MemberRow& row) {
                                    return static_cast<std::int8_t>(row.status == RowStatus::done ? row.steady : -1);
                                }),
        hdf5::Flags{{0, 1}, "not_steady steady", -1});
    hdf5::write_rows(id, {"segment_maximum", "N", "largest surge load in each segment of the window"}, scales.member,
                     scales.segment, [&content](std::size_t member_index) {
                         return std::span<const double>(content.table.members[member_index].segment_maximum);
                     });
    hdf5::write_values(id, {"reason", "1", "why the member failed; empty unless it did"}, member,
                       of_members<std::string>(content, [](const MemberRow& row) { return row.reason; }));
}

}  // namespace floes
