#include "campaign_file/campaign_content.hpp"

namespace floes {

void add_members(hid_t id, const CampaignScales& scales, MemberTables& tables) {
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
    tables.add_texts(id, {"reason", "1", "why the member failed; empty unless it did"}, member,
                     [](const FiledMember& m) { return m.row.reason; });
}

void add_arrangement_numbers(hid_t group, const CampaignContent& content, const CampaignScales& scales,
                             MemberTables& tables) {
    // Members come in the order of their arrangements, so each row begins where its number is first seen.
    struct Numbers {
        hdf5::Column<std::int32_t> column;
        int rows = 0;
        void finish() { column.finish(); }
    };
    const ArrangementRows& rows = content.rows.arrangements();
    auto numbers =
        std::make_shared<Numbers>(Numbers{{group, {"number", "1", "arrangement number"}, {scales.arrangement}}});
    tables.add(numbers, [&rows](Numbers& all, const FiledMember& member) {
        for (const int last = rows.number(member.row.arrangement) * rows.groups() + rows.groups(); all.rows < last;
             ++all.rows)
            all.column.add(rows.number(all.rows));
    });
}

}  // namespace floes
