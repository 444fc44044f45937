#include "campaign_file/campaign_content.hpp"
#include "hdf5/rows.hpp"

namespace floes {
namespace {

using hdf5::Handle;

template <class Value, class Function>
std::vector<Value> of_members(const CampaignContent& content, Function function) {
    std::vector<Value> values;
    for (const MemberRow& row : content.table.members) values.push_back(function(row));
    return values;
}

}  // namespace

void write_members(hid_t file, const CampaignContent& content, const CampaignScales& scales) {
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
    // Counts are doubles too, so that every reader sees NaN where there is none.
    for (const Quantity& one : quantities)
        hdf5::write_values(id, {std::string{one.key.view()}, std::string{one.unit}, std::string{one.long_name}}, member,
                           of_members<double>(content, [&one](const MemberRow& row) { return row.value(one); }));
    hdf5::write_values(
        id, {"steady", "1", "whether the trend of the surge load does not differ from zero"}, member,
        of_members<std::int8_t>(
            content, [](const MemberRow& row) { return static_cast<std::int8_t>(row.done() ? row.load.steady : -1); }),
        hdf5::Flags{{0, 1}, "not_steady steady", -1});
    hdf5::write_rows(id, {"segment_maximum", "N", "largest surge load in each segment of the window"}, scales.member,
                     scales.segment, [&content](std::size_t member_index) {
                         return std::span<const double>(content.table.members[member_index].load.segment_maximum);
                     });
    hdf5::write_values(id, {"reason", "1", "why the member failed; empty unless it did"}, member,
                       of_members<std::string>(content, [](const MemberRow& row) { return row.reason; }));
}

}  // namespace floes
