#include "campaign_file/campaign_content.hpp"
#include "hdf5/rows.hpp"

namespace floes {

void add_members(hid_t file, const CampaignContent&, const CampaignScales& scales, MemberTables& tables) {
    const hdf5::Handle group = hdf5::create_group(file, "members");
    const hid_t id = group.id();
    const hdf5::Dimensions member{scales.member};
    const auto integers = [&](const char* name, const char* long_name, auto of) {
        tables.add_numbers<std::int32_t>(id, {name, "1", long_name}, member, std::nullopt, of);
    };
    const auto flags = [&](const char* name, const char* long_name, const hdf5::Flags& meanings, auto of) {
        tables.add_numbers<std::int8_t>(id, {name, "1", long_name}, member, meanings, of);
    };
    integers("case", "case of the member, a row of /cases", [](const FiledMember& m) { return m.row.case_index; });
    integers("arrangement", "arrangement of the member, a row of /arrangements",
             [](const FiledMember& m) { return m.row.arrangement; });
    flags("status", "whether the member was computed", hdf5::Flags{{-1, 0, 1}, "missing done failed"},
          [](const FiledMember& m) { return static_cast<std::int8_t>(m.row.status); });
    // Counts are doubles too, so that every reader sees NaN where there is none.
    for (const Quantity& one : quantities)
        tables.add_numbers<double>(id, {std::string{one.key.view()}, std::string{one.unit}, std::string{one.long_name}},
                                   member, nan, [&one](const FiledMember& m) { return m.row.value(one); });
    flags("steady", "whether the trend of the surge load does not differ from zero",
          hdf5::Flags{{0, 1}, "not_steady steady", -1},
          [](const FiledMember& m) { return static_cast<std::int8_t>(m.row.done() ? m.row.load.steady : -1); });
    tables.add(std::make_shared<hdf5::Rows>(
                   id, hdf5::Label{"segment_maximum", "N", "largest surge load in each segment of the window"},
                   scales.member, hdf5::Dimensions{scales.segment}),
               [](hdf5::Rows& rows, const FiledMember& m) { rows.write(m.number, m.row.load.segment_maximum); });
    tables.add_texts(id, {"reason", "1", "why the member failed; empty unless it did"}, member,
                     [](const FiledMember& m) { return m.row.reason; });
}

}  // namespace floes
