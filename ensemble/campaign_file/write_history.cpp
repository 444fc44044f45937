#include "campaign_file/campaign_content.hpp"
#include "campaign_file/load_map_tables.hpp"
#include "hdf5/rows.hpp"

namespace floes {

void write_history(hid_t file, const CampaignContent& content, const CampaignScales& scales,
                   const HistoryOf& history_of) {
    const hdf5::Handle group = hdf5::create_group(file, "history");
    const auto table = [&](const char* name, const char* long_name) {
        return hdf5::Rows(group.id(), {name, "N", long_name}, scales.member, {scales.time});
    };
    hdf5::Rows surge = table("surge_load", "contact force on the structure against the tow");
    hdf5::Rows sway = table("sway_load", "contact force on the structure towards +z");
    hdf5::Rows heave = table("heave_load", "contact force on the structure upwards");
    LoadMapTables maps(file, scales);
    for (std::size_t member = 0; member < content.records.size(); ++member) {
        if (content.done(member) == nullptr) continue;
        const PackedHistory history = history_of(*content.records[member]);
        surge.write(member, history.surge);
        sway.write(member, history.sway);
        heave.write(member, history.heave);
        if (!history.map.empty()) maps.write(member, history.map);
    }
    for (hdf5::Rows* one : {&surge, &sway, &heave}) one->finish();
    maps.finish();
}

void write_breaks(hid_t file, const CampaignContent& content, const CampaignScales& scales) {
    std::vector<std::int32_t> members;
    std::vector<double> times;
    std::vector<std::int32_t> floes;
    std::vector<std::int32_t> joints;
    std::vector<std::int8_t> modes;
    for (std::size_t member = 0; member < content.records.size(); ++member) {
        const MemberResult* result = content.done(member);
        if (result == nullptr) continue;
        for (const BreakEvent& event : result->breaks) {
            members.push_back(static_cast<std::int32_t>(member));
            times.push_back(event.time);
            floes.push_back(event.floe);
            joints.push_back(event.joint);
            modes.push_back(static_cast<std::int8_t>(event.mode));
        }
    }
    const hdf5::Handle group = hdf5::create_group(file, "breaks");
    const hdf5::Dimensions one{scales.break_};
    hdf5::write_values(group.id(), {"member", "1", "member in which the joint failed"}, one, members);
    hdf5::write_values(group.id(), {"time", "s", "end of the step in which the joint failed"}, one, times);
    hdf5::write_values(group.id(), {"floe", "1", "floe of the joint"}, one, floes);
    hdf5::write_values(group.id(), {"joint", "1", "joint within its floe"}, one, joints);
    hdf5::write_values(group.id(), {"mode", "1", "how the joint failed"}, one, modes,
                       hdf5::flags_of(failure_mode_names));
}

}  // namespace floes
