#include "campaign_file/campaign_content.hpp"
#include "campaign_file/load_map_tables.hpp"
#include "hdf5/rows.hpp"

namespace floes {
namespace {

class Histories {
  public:
    Histories(hid_t group, hid_t file, const CampaignScales& scales)
        : surge_(group, {"surge_load", "N", "contact force on the structure against the tow"}, scales.member,
                 {scales.time}),
          sway_(group, {"sway_load", "N", "contact force on the structure towards +z"}, scales.member, {scales.time}),
          heave_(group, {"heave_load", "N", "contact force on the structure upwards"}, scales.member, {scales.time}),
          maps_(file, scales) {}

    void write(const FiledMember& member) {
        if (member.done() == nullptr) return;
        const PackedHistory& history = member.record->history;
        surge_.write(member.number, history.surge);
        sway_.write(member.number, history.sway);
        heave_.write(member.number, history.heave);
        if (!history.map.empty()) maps_.write(member.number, history.map);
    }

    void finish() {
        for (hdf5::Rows* one : {&surge_, &sway_, &heave_}) one->finish();
        maps_.finish();
    }

  private:
    hdf5::Rows surge_;
    hdf5::Rows sway_;
    hdf5::Rows heave_;
    LoadMapTables maps_;
};

class Breaks {
  public:
    Breaks(hid_t group, const CampaignScales& scales)
        : member_(group, {"member", "1", "member in which the joint failed"}, {scales.break_}),
          time_(group, {"time", "s", "end of the step in which the joint failed"}, {scales.break_}, nan),
          floe_(group, {"floe", "1", "floe of the joint"}, {scales.break_}),
          joint_(group, {"joint", "1", "joint within its floe"}, {scales.break_}),
          mode_(group, {"mode", "1", "how the joint failed"}, {scales.break_}, hdf5::flags_of(failure_mode_names)) {}

    void write(const FiledMember& member) {
        const MemberResult* result = member.done();
        if (result == nullptr) return;
        for (const BreakEvent& event : result->breaks) {
            member_.add(static_cast<std::int32_t>(member.number));
            time_.add(event.time);
            floe_.add(event.floe);
            joint_.add(event.joint);
            mode_.add(static_cast<std::int8_t>(event.mode));
        }
    }

    void finish() {
        for (hdf5::Column<std::int32_t>* one : {&member_, &floe_, &joint_}) one->finish();
        time_.finish();
        mode_.finish();
    }

  private:
    hdf5::Column<std::int32_t> member_;
    hdf5::Column<double> time_;
    hdf5::Column<std::int32_t> floe_;
    hdf5::Column<std::int32_t> joint_;
    hdf5::Column<std::int8_t> mode_;
};

}  // namespace

void add_history(hid_t file, const CampaignScales& scales, MemberTables& tables) {
    const hdf5::Handle group = hdf5::create_group(file, "history");
    tables.add(std::make_shared<Histories>(group.id(), file, scales),
               [](Histories& all, const FiledMember& member) { all.write(member); });
}

void add_breaks(hid_t file, const CampaignScales& scales, MemberTables& tables) {
    const hdf5::Handle group = hdf5::create_group(file, "breaks");
    tables.add(std::make_shared<Breaks>(group.id(), scales),
               [](Breaks& all, const FiledMember& member) { all.write(member); });
}

}  // namespace floes
